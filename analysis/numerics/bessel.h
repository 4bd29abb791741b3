#pragma once

namespace fourpost {

/// Modified Bessel function of the second kind and first order K1(x), x > 0, to rounding: std::cyl_bessel_k, which not
/// every standard library has.
double BesselK1(double x);

/// exp(-x) I1(x), I1 the modified Bessel function of the first kind and first order, x >= 0, to 1e-13.
double ScaledBesselI1(double x);

}  // namespace fourpost
