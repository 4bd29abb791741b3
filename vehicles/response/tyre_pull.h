#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/text/diagnostics.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/excitation.h"
#include "vehicles/response/harmonic_balance_options.h"

namespace fourpost {

/// A tyre with liftoff="false" that pulls on its platform.
struct TyrePull {
  /// Index in Vehicle::tyres.
  std::size_t tyre = 0;
  /// Number of samples, or of frequencies, with a pull; `of`: of all.
  std::size_t count = 0;
  std::size_t of = 0;
  /// The largest pull [N].
  double pull_N = 0;
};

/// Indices in Vehicle::tyres of those that cannot lift off.
std::vector<std::size_t> LinearTyres(const Vehicle& vehicle);

/// A load cell without wheelpan under each of these tyres.
std::vector<Sensor> ForceSensors(const Vehicle& vehicle, const std::vector<std::size_t>& tyres);

/// For a history. `forces`: readings of ForceSensors() of the LinearTyres(), samples x tyres [N]; `preloads`: forces at
/// rest of all tyres [N].
std::vector<TyrePull> FindTyrePulls(const Vehicle& vehicle, const std::vector<double>& preloads,
                                    const Eigen::MatrixXd& forces);

/// For a stepped sine, at these values of the parameters, by the linearised harmonic balance. Throws as
/// CondensedVehicle and SolveHarmonicBalance do.
std::vector<TyrePull> FindTyrePulls(const Vehicle& vehicle, std::span<const double> values,
                                    const Excitation& excitation, const HarmonicBalanceOptions& options = {});

/// Least force over the cycle of each tyre at each frequency [N], frequencies x tyres; tyres that lift off count as if
/// they pulled. `tyres`: the tyres to compute, of the vehicle of `model`.
Eigen::MatrixXd LeastTyreForces(const CondensedModel& model, const std::vector<CondensedModel::Liftoff>& tyres,
                                const Excitation& excitation, const HarmonicBalanceOptions& options = {});

/// Adds a warning for each. `samples`: "samples" or "frequencies"; `motion`: name of the motion, such as "heave".
void WarnOfPulls(const Vehicle& vehicle, const std::vector<TyrePull>& pulls, const std::string& samples,
                 const std::string& motion, Diagnostics& findings);

}  // namespace fourpost
