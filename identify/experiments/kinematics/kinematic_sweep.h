#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/kinematics/kinematic_plan.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/poses/axle_kinematics.h"

namespace fourpost {

/// One measured quantity over the positions of a sweep.
struct KinematicCurve {
  const KinematicQuantity* quantity = nullptr;
  /// Of a wheel: place in Axle::wheels.
  std::size_t of = 0;
  /// Of a strut, whose name is `of_name`: a place in StrutsOf() would shift where a vehicle is given another strut.
  AxleStrut::Kind strut_kind = AxleStrut::Kind::kSpring;
  /// "front_tyre_left", "front", "front_coil_left".
  std::string of_name;
  /// Of each point: place in KinematicSweep::positions, and what was measured, SI.
  std::vector<std::size_t> places;
  std::vector<double> measured;
  /// Of one point, SI.
  double sd = 1;
  bool has_free_offset = false;

  /// Residuals that it gives: one less with an offset that is fitted beside.
  std::size_t degrees() const { return measured.size() - (has_free_offset ? 1 : 0); }
};

/// An axle that a rig has moved or loaded in one way.
struct KinematicSweep {
  std::string recording;
  bool is_validation = false;
  /// Of the study.
  int line = 0;
  /// Place in Suspension::axles.
  std::size_t axle = 0;
  std::string axle_name;
  /// "heave", "roll", "front_tyre_left", "lateral", "lateral opposed".
  std::string motion;
  AxleTravel travel;
  struct Load {
    WheelLoad kind = WheelLoad::kLateral;
    bool is_opposed = false;
  };
  /// In place of the travel.
  std::optional<Load> load;
  /// Travels [m], or loads [N or N m], rising, each once.
  std::vector<double> positions;
  std::vector<KinematicCurve> curves;

  const char* position_unit() const {
    if (!load) return "mm";
    return load->kind == WheelLoad::kAligning ? "N*m" : "N";
  }
};

/// Reads a table and maps its columns to the vehicle. Adds every fault to `diagnostics`.
std::vector<KinematicSweep> LoadKinematicSweeps(const KinematicPlan& plan, const Vehicle& vehicle,
                                                Diagnostics& diagnostics);

}  // namespace fourpost
