#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "identify/choice/knob.h"
#include "identify/choice/metric.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A random road of ISO 8608 at a speed.
struct ChoiceRoad {
  std::string name;
  std::string road_class;
  /// m/s.
  double speed = 0;
  /// Share of the driving; of all roads they add up to 1.
  double weight = 1;
  int line = 0;
};

/// What can be set on a car, and what is wanted of it.
struct SettingsFile {
  std::filesystem::path file;
  std::vector<Knob> knobs;
  std::vector<ChoiceRoad> roads;
  /// One or two.
  std::vector<Objective> objectives;
  std::vector<MetricLimit> limits;
  /// Probability with which a setting must meet every limit.
  double certainty = 0.9;
  /// In which the roads excite the car [Hz].
  double lower_Hz = 0.5;
  double upper_Hz = 30;
  /// Of a road that is driven over time, and whose peaks are meant.
  double duration_s = 60;
  std::size_t draws = 100;
  std::uint64_t seed = 1;
  /// Settings that are computed over time as well, besides the present one.
  std::size_t shortlist = 3;
  /// Share of an objective by which engines may differ in its change against the present setting.
  double agreement = 0.02;
  /// Standard deviation of one run on the rig, as a share of the cost.
  double repeatability = 0.01;

  std::vector<double> RoadWeights() const;
};

/// Reads a file of settings for a vehicle and metrics that can be computed, of which the first two are the
/// objectives where the file names none. Adds every fault with file and line; nothing when there was an error.
std::optional<SettingsFile> ReadSettingsFile(const std::filesystem::path& file, const Vehicle& vehicle,
                                             const std::vector<Metric>& metrics, Diagnostics& diagnostics);

/// The same of a text, the content of `file`.
std::optional<SettingsFile> ReadSettingsText(const std::string& text, const std::filesystem::path& file,
                                             const Vehicle& vehicle, const std::vector<Metric>& metrics,
                                             Diagnostics& diagnostics);

}  // namespace fourpost
