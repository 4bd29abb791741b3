#include "vehicles/response/port_newton.h"

#include <complex>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Harmonics 0, 1 .. H of a signal s(t) from m = -2 H .. 2 H of a real one: s = sum over m of two-sided c_m.
class TwoSidedSpectrum {
 public:
  explicit TwoSidedSpectrum(const Eigen::VectorXcd& harmonics) : harmonics_(harmonics) {}
  Complex operator()(Eigen::Index m) const {
    if (m == 0) return harmonics_[0];
    return 0.5 * (m > 0 ? harmonics_[m] : std::conj(harmonics_[-m]));
  }

 private:
  const Eigen::VectorXcd& harmonics_;
};

/// Real unknowns of the harmonics 0..H: the mean, then real and imaginary parts.
Eigen::VectorXd Unfolded(const Eigen::VectorXcd& harmonics) {
  Eigen::VectorXd real(2 * harmonics.size() - 1);
  real << harmonics.real(), harmonics.imag().tail(harmonics.size() - 1);
  return real;
}
Eigen::VectorXcd Folded(const Eigen::VectorXd& real) {
  const Eigen::Index count = (real.size() + 1) / 2;
  Eigen::VectorXcd harmonics(count);
  harmonics.real() = real.head(count);
  harmonics.imag()[0] = 0;
  harmonics.imag().tail(count - 1) = real.tail(count - 1);
  return harmonics;
}

/// The real matrix of E -> direct E + conjugate conj(E), on Unfolded().
Eigen::MatrixXd RealMatrix(const Eigen::MatrixXcd& direct, const Eigen::MatrixXcd& conjugate) {
  const Eigen::Index count = direct.rows();
  const Eigen::Index rest = count - 1;
  const Eigen::MatrixXcd sum = direct + conjugate;
  const Eigen::MatrixXcd difference = direct - conjugate;
  Eigen::MatrixXd real(count + rest, count + rest);
  real << sum.real(), -difference.imag().rightCols(rest), sum.imag().bottomRows(rest),
      difference.real().bottomRightCorner(rest, rest);
  return real;
}

/// With two-sided harmonics a of the slope by extension and b of that by rate:
///   dR_l = sum over h > 0 of (a_{l-h} + i h w b_{l-h}) dE_h + (a_{l+h} - i h w b_{l+h}) conj(dE_h), and 2 a_l dE_0
/// for l > 0, half of it for l = 0.
std::vector<PortCoupling> Couplings(const PortCycle& cycle, Eigen::Index size) {
  Eigen::MatrixXd by_extension(cycle.samples(), 1);
  Eigen::MatrixXd by_rate(cycle.samples(), 1);
  Eigen::MatrixXcd of_extension;
  Eigen::MatrixXcd of_rate;
  const CycleTransform& transform =
      CycleTransform::Shared(2 * static_cast<int>(size - 1), static_cast<int>(cycle.samples()));
  std::vector<PortCoupling> couplings;
  for (std::size_t j = 0; j < cycle.ports().size(); ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    if (const PortLaw& law = cycle.ports()[j].law; HasMemory(law)) {
      couplings.push_back(CycleCoupling(cycle, law, column, size));
      continue;
    }
    RemainderSlopes(cycle.ports()[j].law, Samples(cycle.extension_time(), column), Samples(cycle.rate_time(), column),
                    Room(by_extension, 0), Room(by_rate, 0));
    if (by_extension.isZero(0) && by_rate.isZero(0)) continue;
    transform.ToHarmonics(by_extension, of_extension);
    transform.ToHarmonics(by_rate, of_rate);
    const Eigen::VectorXcd extension_column = of_extension.col(0);
    const Eigen::VectorXcd rate_column = of_rate.col(0);
    const TwoSidedSpectrum a(extension_column);
    const TwoSidedSpectrum b(rate_column);
    PortCoupling coupling{column, Eigen::MatrixXcd::Zero(size, size), Eigen::MatrixXcd::Zero(size, size)};
    for (Eigen::Index l = 0; l < size; ++l) {
      const double share = l > 0 ? 1 : 0.5;
      coupling.direct(l, 0) = 2 * share * a(l);
      for (Eigen::Index h = 1; h < size; ++h) {
        const Complex iw(0, static_cast<double>(h) * cycle.omega());
        coupling.direct(l, h) = share * (a(l - h) + iw * b(l - h));
        coupling.conjugate(l, h) = share * (a(l + h) - iw * b(l + h));
      }
    }
    couplings.push_back(std::move(coupling));
  }
  return couplings;
}

}  // namespace

/// By the remainder's change with the real and the imaginary part of each harmonic, r and i:
///   dR = r dRe(E) + i dIm(E) = (r - j i) / 2 dE + (r + j i) / 2 conj(dE),   j: the imaginary unit
PortCoupling CycleCoupling(const PortCycle& cycle, const PortLaw& law, Eigen::Index port, Eigen::Index size) {
  const Complex imaginary(0, 1);
  Eigen::MatrixXcd units(size, 2 * size - 1);
  units << Eigen::MatrixXcd::Identity(size, size),
      imaginary * Eigen::MatrixXcd::Identity(size, size).rightCols(size - 1);
  const Eigen::VectorXcd rates =
      Complex(0, cycle.omega()) * Eigen::VectorXd::LinSpaced(size, 0, static_cast<double>(size - 1));
  const CycleTransform& steps = CycleTransform::Shared(static_cast<int>(size - 1), static_cast<int>(cycle.steps()));
  Eigen::MatrixXd extensions;
  Eigen::MatrixXd extension_rates;
  Eigen::MatrixXd remainders;
  steps.ToTime(units, extensions);
  steps.ToTime(rates.asDiagonal() * units, extension_rates);
  const PortCycle::SteppedMotion motion = cycle.StepsOf(port);
  CycleChanges(law, cycle.Period(), Samples(motion.extension, 0), Samples(motion.rate, 0), extensions, extension_rates,
               remainders);
  Eigen::MatrixXcd changes;
  steps.ToHarmonics(remainders, changes);
  const auto by_real = changes.middleCols(1, size - 1);
  const auto by_imaginary = changes.rightCols(size - 1);
  PortCoupling coupling{port, Eigen::MatrixXcd::Zero(size, size), Eigen::MatrixXcd::Zero(size, size)};
  coupling.direct.col(0) = changes.col(0);
  coupling.direct.rightCols(size - 1) = 0.5 * (by_real - imaginary * by_imaginary);
  coupling.conjugate.rightCols(size - 1) = 0.5 * (by_real + imaginary * by_imaginary);
  for (Eigen::Index h = 0; h < size; ++h)
    coupling.direct(h, h) -= LaggingShare(law, static_cast<double>(h) * cycle.omega());
  return coupling;
}

Eigen::MatrixXcd NewtonStep(const PortCycle& cycle, const Eigen::MatrixXcd& step, Eigen::Index rows) {
  const std::vector<PortCoupling> couplings = Couplings(cycle, rows);
  const Eigen::Index count = step.cols();
  const Eigen::Index unknowns = 2 * rows - 1;
  const auto active = static_cast<Eigen::Index>(couplings.size());
  const auto Through = [&](Eigen::Index i, const PortCoupling& coupling) {
    const auto receptance = cycle.receptance().col(i + count * coupling.port).head(rows).asDiagonal();
    return RealMatrix(receptance * coupling.direct, receptance * coupling.conjugate);
  };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(active * unknowns, active * unknowns);
  Eigen::VectorXd right(active * unknowns);
  for (Eigen::Index p = 0; p < active; ++p) {
    const Eigen::Index port = couplings[static_cast<std::size_t>(p)].port;
    right.segment(p * unknowns, unknowns) = Unfolded(step.col(port).head(rows));
    for (Eigen::Index q = 0; q < active; ++q)
      matrix.block(p * unknowns, q * unknowns, unknowns, unknowns) -=
          Through(port, couplings[static_cast<std::size_t>(q)]);
  }
  const Eigen::VectorXd solution = Solved(matrix, right);
  Eigen::MatrixXcd newton = step;
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index q = 0; q < active; ++q)
      newton.col(i).head(rows) +=
          Folded(Through(i, couplings[static_cast<std::size_t>(q)]) * solution.segment(q * unknowns, unknowns));
  return newton;
}

}  // namespace fourpost
