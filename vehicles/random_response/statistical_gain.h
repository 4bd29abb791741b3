#pragma once

#include "vehicles/condensed/port.h"

namespace fourpost {

/// Motion of a nonlinear element under a stationary random road: its extension is normal about a mean, its rate about
/// zero, and both are independent at one instant.
struct PortMotion {
  double mean = 0;          // m
  double extension_sd = 0;  // m
  double rate_sd = 0;       // m/s
};

/// The linear law that replaces a nonlinear part r(e, e') with the least mean square error (statistical linearisation:
/// R. C. Booton, IRE Trans. Circuit Theory 1, 1954; J. B. Roberts and P. D. Spanos, Random Vibration and Statistical
/// Linearization, Wiley 1990, chapter 5),
///   r ~ mean + by_extension (e - E e) + by_rate e',  by_extension = E[dr/de],  by_rate = E[dr/de'].
struct StatisticalGain {
  double mean = 0;          // N
  double by_extension = 0;  // N/m
  double by_rate = 0;       // N s/m
};

/// Dashpots and springs by Gauss's rule between the kinks of the law; tyres that lift off in closed form,
/// those whose rate changes with their load by Gauss's rule over the extension; a hydraulic
/// damper, whose force has a memory, by the first harmonic of the sine of the same deviations of extension and rate;
/// friction that sticks, likewise, by those of sines whose amplitudes are spread as those of a narrow band. NaN for a
/// hydraulic damper without such a cycle.
StatisticalGain GainOf(const PortLaw& law, const PortMotion& motion);

/// Mean and standard deviation of a tyre's vertical force max(0, F) with F normal, and the share of time with F < 0.
struct LiftingForce {
  double mean = 0;       // N
  double deviation = 0;  // N
  double off_ground = 0;
};
LiftingForce LiftingForceOf(double mean, double deviation);

/// The same of a tyre whose rate changes with its load.
LiftingForce LiftingForceOf(const TyreRemainder& port, const PortMotion& motion);

/// Share of a normal distribution below z deviations.
double NormalShareBelow(double z);

}  // namespace fourpost
