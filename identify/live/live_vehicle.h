#pragma once

#include <span>
#include <vector>

#include "analysis/signals/frequency_response.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/modes.h"
#include "vehicles/condensed/reduced_vehicle.h"
#include "vehicles/response/excitation.h"

namespace fourpost {

/// A reduced vehicle whose parameters follow a hand, with the answers of a fit. Compiled into the program, and by
/// build.py into the WebAssembly that pages carry.
class LiveVehicle {
 public:
  /// At the values of the vehicle's file.
  explicit LiveVehicle(ReducedData data);

  const ReducedData& data() const { return vehicle_.data(); }

  /// SI, one per parameter of the vehicle. Throws std::invalid_argument for another number of them, or values that a
  /// law refuses.
  void Set(std::span<const double> values);

  const std::vector<double>& values() const { return values_; }

  /// Whether its steady responses need time integration, see HasHysteresis(): too slow for a hand.
  bool IsHysteretic() const;

  /// Of the sensors, then of the independent coordinates as displacements. As ModelledResponse() of a fit, except that
  /// what the harmonic balance leaves open is not integrated in time: NaN at these frequencies. NaN at all of them of a
  /// hysteretic vehicle. Throws as SolveHarmonicBalance.
  FrequencyResponse Response(const Excitation& excitation) const;

  /// See ModesOf().
  std::vector<Mode> Modes() const;

 private:
  ReducedVehicle vehicle_;
  std::vector<double> values_;
  /// Those of the vehicle, and one per coordinate.
  std::vector<Sensor> sensors_;
  /// With rows of all these.
  CondensedModel model_;
};

}  // namespace fourpost
