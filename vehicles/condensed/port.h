#pragma once

#include <complex>
#include <span>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/laws/dahl_friction.h"
#include "vehicles/laws/hydraulic_oil.h"

namespace fourpost {

/// Nonlinear part of an element's tension, over extension e [m] and rate e' [m/s].
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
/// Minus the pull of a tyre that should have left its platform; its linear law is all in the linear part.
struct LiftoffRemainder {
  double preload = 0;    // N
  double stiffness = 0;  // N/m
  double damping = 0;    // N s/m

  bool operator==(const LiftoffRemainder&) const = default;
};
/// All that a tyre's vertical force changes by from rest, less its linear share; it never pulls.
struct TyreRemainder {
  LoadedTyre law;
  double damping = 0;    // N s/m, in the linear share
  double stiffness = 0;  // N/m, in the linear share

  bool operator==(const TyreRemainder&) const = default;
};
/// A hydraulic damper with its mount. It has memory: a periodic tension depends on the whole cycle of the extension,
/// see CycleRemainders.
struct HydraulicRemainder {
  MountedHydraulicDamper law;
  HydraulicOil::LinearShare share;

  /// The linear part follows from the law.
  bool operator==(const HydraulicRemainder& other) const { return law == other.law; }
};
/// Friction that sticks, all of it: nothing in the linear part. It has memory as well.
struct FrictionRemainder {
  DahlFriction law;

  bool operator==(const FrictionRemainder&) const = default;
};
using PortLaw = std::variant<DashpotRemainder, SpringRemainder, LiftoffRemainder, HydraulicRemainder, FrictionRemainder,
                             TyreRemainder>;

/// Whether the nonlinear part depends on the extension.
bool UsesExtension(const PortLaw& law);

/// Whether it depends on more than extension and rate at one instant.
bool HasMemory(const PortLaw& law);

/// Change of rate within which the nonlinear part has its transition [m/s]; infinite: none.
double StepOfRate(const PortLaw& law);

/// Nonlinear part at each sample [N]. All spans have one length; those that the law does not use may be empty. NaN for
/// a law with memory.
void Remainders(const PortLaw& law, std::span<const double> extension, std::span<const double> rate,
                std::span<double> remainder);

/// A value of an element's signal at which the slope of the nonlinear part jumps.
struct PortKink {
  enum class Signal { kExtension, kRate, kCompression } signal = Signal::kRate;  // kCompression: a tyre's force
  double at = 0;
  /// Towards larger values of the signal.
  double jump = 0;
};
std::vector<PortKink> KinksOf(const PortLaw& law);

/// Remainders() of a whole cycle with kink-corrected quadrature, samples equally spaced. Samples next to a kink are
/// corrected such that sums over the cycle are integrals to third order in the spacing; plain samples of a kinked
/// signal give second order. The trapezoidal rule errs at a corner of slope s' - s'' a share t into its cell of width h
/// by
///   (s' - s'') h^2 B(t) / 2, B(t) = t^2 - t + 1/6
/// (Euler and Maclaurin's formula for a function with a corner). NaN for a law with memory.
void MendedRemainders(const PortLaw& law, std::span<const PortKink> kinks, std::span<const double> extension,
                      std::span<const double> rate, std::span<double> remainder);

/// Derivatives of the nonlinear part by extension [N/m] and by rate [N s/m]. NaN for a law with memory.
void RemainderSlopes(const PortLaw& law, std::span<const double> extension, std::span<const double> rate,
                     std::span<double> by_extension, std::span<double> by_rate);

/// RemainderSlopes() of a whole cycle with kink-corrected quadrature, samples equally spaced. Samples next to a kink
/// are corrected such that sums over the cycle of a slope times any smooth signal are integrals to third order in the
/// spacing; plain samples of a slope that jumps give first order. At a jump J a share t into a cell, the cell's
/// integral over its width exceeds the trapezoidal rule's by
///   J (1/2 - t) g + J B(t) / 2 g'
/// for a signal of value g there that rises by g' per cell; B as above. NaN for a law with memory.
void MendedSlopes(const PortLaw& law, std::span<const PortKink> kinks, std::span<const double> extension,
                  std::span<const double> rate, std::span<double> by_extension, std::span<double> by_rate);

/// Of a law with memory; NaN for others. Tension minus that of the linear part's spring `stiffness` [N], at each sample
/// of a cycle of `period` [s] over which the samples are spread evenly, three or more. Subtracting LaggingShare times
/// the extension at each harmonic gives the nonlinear part. NaN if a hydraulic damper has no such cycle because a
/// chamber closes.
void CycleRemainders(const PortLaw& law, double period, std::span<const double> extension, std::span<const double> rate,
                     std::span<double> remainder);

/// First-order changes by changes of extension and rate, samples x changes. NaN likewise.
void CycleChanges(const PortLaw& law, double period, std::span<const double> extension, std::span<const double> rate,
                  const Eigen::MatrixXd& extension_changes, const Eigen::MatrixXd& rate_changes,
                  Eigen::MatrixXd& remainder_changes);

/// Tension per extension [N/m] of a hydraulic damper's linear part, dashpot and spring in series, at the angular
/// frequency w; zero for other laws.
std::complex<double> LaggingShare(const PortLaw& law, double w);

/// A nonlinear element as seen by a linear vehicle (LinearVehicle, centre rates): its extension is e = direction . [s
/// x] + z of its post, its tension acts on [s x] as -direction f.
struct Port {
  Eigen::VectorXd direction;
  PortLaw law;
  /// -1: none.
  int post = -1;
  /// Index in CondensedModel::liftoffs; -1: none of these.
  int liftoff = -1;
  /// Sensors under a tyre, which read its tension.
  std::vector<int> load_cells = {};
  /// Index in [s x] of the extension of the spring in a hydraulic damper's linear part; -1: no hydraulic damper.
  Eigen::Index lag = -1;
};

/// All nonlinear elements; linear tyres that may lift off come last, before them those of CondensedModel::curved_tyres.
std::vector<Port> PortsOf(const CondensedModel& model);

/// The same if no linear tyre leaves its platform: without these, whose nonlinear parts are zero then.
std::vector<Port> HeldPortsOf(const CondensedModel& model);

}  // namespace fourpost
