#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/diagnostics.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/excitation.h"
#include "vehicles/response/harmonic_balance_options.h"

namespace fourpost {

/// A tyre with liftoff="false" that pulls on its platform.
struct TyrePull {
  /// Index in Vehicle::tyres.
  std::size_t tyre = 0;
  /// In how many of the samples, or of the frequencies.
  std::size_t count = 0;
  std::size_t of = 0;
  /// The largest pull [N].
  double pull_N = 0;
};

/// Indices in Vehicle::tyres of those that do not lift off.
std::vector<std::size_t> LinearTyres(const Vehicle& vehicle);

/// A load cell without wheelpan under each of these tyres.
std::vector<Sensor> ForceSensors(const Vehicle& vehicle, const std::vector<std::size_t>& tyres);

/// Of a history. `forces`: what ForceSensors() of the LinearTyres() read, samples x tyres [N]; `preloads`: forces at
/// rest of all tyres [N].
std::vector<TyrePull> FindTyrePulls(const Vehicle& vehicle, const std::vector<double>& preloads,
                                    const Eigen::MatrixXd& forces);

/// Of a stepped sine, at these values of the parameters, by the linearised balance. Throws as CondensedVehicle and
/// SolveHarmonicBalance do.
std::vector<TyrePull> FindTyrePulls(const Vehicle& vehicle, std::span<const double> values,
                                    const Excitation& excitation, const HarmonicBalanceOptions& options = {});

/// Least force over the cycle of each tyre at each frequency [N], frequencies x tyres: of tyres that lift off as if
/// they pulled. `tyres`: those looked at, of the vehicle that `model` is of.
Eigen::MatrixXd LeastTyreForces(const CondensedModel& model, const std::vector<CondensedModel::Liftoff>& tyres,
                                const Excitation& excitation, const HarmonicBalanceOptions& options = {});

/// Adds a warning for each. `samples`: "samples" or "frequencies"; `motion`: in which, such as "heave".
void WarnOfPulls(const Vehicle& vehicle, const std::vector<TyrePull>& pulls, const std::string& samples,
                 const std::string& motion, Diagnostics& findings);

}  // namespace fourpost
