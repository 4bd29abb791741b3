#pragma once

#include <complex>
#include <span>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/laws/hydraulic_oil.h"

namespace fourpost {

/// What an element's tension departs by from its linear share, over extension e [m] and rate e' [m/s] of its port.
struct DashpotRemainder {
  DashpotLaw law;
  double rate = 0;  // N s/m, in the linear share

  bool operator==(const DashpotRemainder&) const = default;
};
struct SpringRemainder {
  SpringLaw law;
  double stiffness = 0;  // N/m, in the linear share

  bool operator==(const SpringRemainder&) const = default;
};
/// Minus the pull of a tyre that should have left its platform; all of its linear compression is the linear share.
struct LiftoffRemainder {
  double preload = 0;    // N
  double stiffness = 0;  // N/m
  double damping = 0;    // N s/m

  bool operator==(const LiftoffRemainder&) const = default;
};
/// Of a hydraulic damper with its mount. It remembers: a periodic tension follows from the whole cycle of the
/// extension, see CycleRemainders.
struct HydraulicRemainder {
  MountedHydraulicDamper law;
  HydraulicOil::LinearShare share;

  /// The share follows from the law.
  bool operator==(const HydraulicRemainder& other) const { return law == other.law; }
};
using PortLaw = std::variant<DashpotRemainder, SpringRemainder, LiftoffRemainder, HydraulicRemainder>;

/// Whether the extension, the rate decides on the remainder.
bool UsesExtension(const PortLaw& law);
bool UsesRate(const PortLaw& law);

/// Change of rate within which the remainder takes a step [m/s]; infinite: none.
double StepOfRate(const PortLaw& law);

/// Remainder at each sample [N]; all spans of one length, those of what the law does not use may be empty. NaN for a
/// law with memory.
void Remainders(const PortLaw& law, std::span<const double> extension, std::span<const double> rate,
                std::span<double> remainder);

/// A value of a port's signal at which the slope of its remainder jumps.
struct PortKink {
  enum class Signal { kExtension, kRate, kCompression } signal = Signal::kRate;
  double at = 0;
  /// Towards larger values of the signal.
  double jump = 0;
};
std::vector<PortKink> KinksOf(const PortLaw& law);

/// Of a whole cycle, samples equally spaced: Remainders(), but at the samples next to a kink such that sums over the
/// cycle are integrals to third order in the spacing, where plain samples of a kinked signal give the second.
/// The trapezoidal rule errs at a corner of slope s' - s'' a share t into its cell of width h by
///   (s' - s'') h^2 B(t) / 2, B(t) = t^2 - t + 1/6
/// (Euler and Maclaurin's formula for a function with a corner). NaN for a law with memory.
void MendedRemainders(const PortLaw& law, std::span<const PortKink> kinks, std::span<const double> extension,
                      std::span<const double> rate, std::span<double> remainder);

/// Derivatives of the remainder by extension [N/m] and by rate [N s/m]. NaN for a law with memory.
void RemainderSlopes(const PortLaw& law, std::span<const double> extension, std::span<const double> rate,
                     std::span<double> by_extension, std::span<double> by_rate);

/// Of a whole cycle, samples equally spaced: RemainderSlopes(), but at the samples next to a kink such that sums over
/// the cycle of a slope times any smooth signal are integrals to third order in the spacing, where plain samples of a
/// slope that jumps give the first. Where it jumps by J a share t into a cell, the cell's integral over its width
/// exceeds the trapezoidal rule's by
///   J (1/2 - t) g + J B(t) / 2 g'
/// of a signal of value g there, that rises by g' per cell; B as above. NaN for a law with memory.
void MendedSlopes(const PortLaw& law, std::span<const PortKink> kinks, std::span<const double> extension,
                  std::span<const double> rate, std::span<double> by_extension, std::span<double> by_rate);

/// What the tension departs by from the share's spring `stiffness` [N], at each sample of a cycle of `period` [s] over
/// which all are spread evenly, three or more. That, less LaggingShare times the extension at each harmonic, is the
/// remainder. NaN where the damper has no such cycle: where a chamber closes.
void CycleRemainders(const HydraulicRemainder& port, double period, std::span<const double> extension,
                     std::span<const double> rate, std::span<double> remainder);

/// Its first-order changes by changes of extension and rate, samples x changes. NaN likewise.
void CycleChanges(const HydraulicRemainder& port, double period, std::span<const double> extension,
                  std::span<const double> rate, const Eigen::MatrixXd& extension_changes,
                  const Eigen::MatrixXd& rate_changes, Eigen::MatrixXd& remainder_changes);

/// Tension per extension [N/m] of the share's dashpot and spring in line at the angular frequency w.
std::complex<double> LaggingShare(const HydraulicRemainder& port, double w);

/// A place where a linear vehicle (LinearVehicle, centre rates) meets a force that is not linear: the element's
/// extension is e = direction . [s x] + z of its post, its tension acts on [s x] as -direction f.
struct Port {
  Eigen::VectorXd direction;
  PortLaw law;
  /// -1: none.
  int post = -1;
  /// Index in CondensedModel::liftoffs; -1: no tyre's.
  int liftoff = -1;
  /// Index in [s x] of the extension of the spring in a hydraulic damper's linear share; -1: no such damper's.
  Eigen::Index lag = -1;
};

/// Of every element that is not linear; those of tyres that lift off come last.
std::vector<Port> PortsOf(const CondensedModel& model);

/// The same where no tyre leaves its platform: without their ports, whose remainders are zero then.
std::vector<Port> HeldPortsOf(const CondensedModel& model);

}  // namespace fourpost
