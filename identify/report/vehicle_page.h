#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/text/diagnostics.h"
#include "identify/experiments/experiment_report.h"
#include "identify/report/curves_json.h"
#include "identify/report/live_json.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/requests/sweep.h"

namespace fourpost {

/// What a command answered of a vehicle that need not have been fitted.
struct VehicleAnswer {
  /// Text beside the vehicle's name: "modes".
  std::vector<std::string> facts = {};
  /// Text of the vehicle's file, which a page saves with other values; empty: the page has no sliders.
  std::string file = {};
  /// What its sliders show of a ride; empty: the usual.
  std::optional<ShownRide> ride = {};
  Diagnostics findings = {};
  std::vector<SweptResponse> responses = {};
  std::vector<RecordedHistory> over_time = {};
  /// Whether a section of its own has the place of the sliders, which without responses is below the vehicle.
  bool has_sliders_elsewhere = false;
  /// Over the moving vehicle, and below it.
  std::string viewer_title = "The vehicle on its posts";
  std::string viewer_note = {};
  /// Before and after the section of the vehicle.
  std::vector<ReportSection> before = {};
  std::vector<ReportSection> after = {};
  std::vector<CurveGroup> curves = {};
  /// Further keys of the scripts' data and of their scene, by analysis/report/README.md.
  nlohmann::ordered_json drawn = nlohmann::ordered_json::object();
  nlohmann::ordered_json scene = nlohmann::ordered_json::object();
  /// Whether a table of modes and their map have a section; of a page that is about nothing else it comes first.
  bool shows_modes = true;
};

/// A page of a vehicle: what a command answered of it, the vehicle moving and its parameters. The vehicle is left out,
/// and the page says why, where it cannot be assembled or held.
std::string VehiclePage(const Vehicle& vehicle, const VehicleAnswer& answer);

}  // namespace fourpost
