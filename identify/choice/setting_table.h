#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/process/work_hooks.h"
#include "identify/choice/knob.h"
#include "identify/choice/metric.h"
#include "identify/choice/settings_file.h"

namespace fourpost {

/// A car that settings are compared on: what can be set, and the metrics of the car by one engine.
struct SettableCar {
  const SettingsFile* settings = nullptr;
  MetricsOf metrics_of;
};

/// Objectives and margins of limits of one setting in one possible car.
struct SettingScore {
  /// One per objective, SI.
  std::vector<double> objectives;
  /// One per limit, SI; negative: beyond it.
  std::vector<double> margins;
  /// Why there are none; empty: there are.
  std::string failure;

  bool IsGood() const { return failure.empty(); }
  /// All limits are met.
  bool MeetsLimits() const;
};

/// `fitted`: parameter values of the possible car at its present setting; `draw`: its number, for drawn positions.
SettingScore ScoreOf(const SettableCar& car, const Setting& setting, std::span<const double> fitted,
                     std::optional<Eigen::Index> draw = std::nullopt);

/// Sum of objectives relative to those of the present setting, by their weights: 1 for the present one.
double Compromise(const std::vector<Objective>& objectives, const SettingScore& score, const SettingScore& present);

/// How far limits are exceeded, each as a share of the limit; 0 where they are met.
double Violation(const std::vector<MetricLimit>& limits, const SettingScore& score);

/// The settings in one possible car, in their order, by several threads; the same for any number of them. Less where it
/// was interrupted. `words`: what is shown, "settings" of a choice.
std::vector<SettingScore> ScoresOf(const SettableCar& car, const std::vector<Setting>& settings,
                                   std::span<const double> fitted, int threads, const WorkHooks& hooks);

/// The same settings in all possible cars.
struct SettingTable {
  std::vector<Setting> settings;
  /// Settings x draws: of each objective, and of each limit's margin; NaN where a car has no answer.
  std::vector<Eigen::MatrixXd> objectives;
  std::vector<Eigen::MatrixXd> margins;
  /// Of each setting, why a draw has no answer; empty: all have one.
  std::vector<std::string> failures;
  bool is_interrupted = false;
};

/// `draws`: a row per draw, columns in the order of Vehicle::parameters, SI. All settings of a draw take the same drawn
/// positions of knobs.
SettingTable TableOf(const SettableCar& car, const std::vector<Setting>& settings, const Eigen::MatrixXd& draws,
                     int threads, const WorkHooks& hooks);

}  // namespace fourpost
