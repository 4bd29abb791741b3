#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/choice/bench_doubt.h"
#include "identify/choice/choice.h"
#include "vehicles/ride_metrics/ride_spectra.h"

namespace fourpost {

/// A choice, and what it was made of.
struct ChoiceAnswer {
  /// The folder of the run, or the vehicle file.
  std::string subject;
  /// "80 to 90 %", of the car's intervals, whose doubt the draws carry; empty: the car is without doubt.
  std::string confidence;
  /// Bench fits whose doubt they carry as well.
  std::vector<BenchDoubt> benches = {};
  ChoiceRequest request;
  Choice choice;
  /// Of the present and the best setting at the fitted values, on the road with the largest weight; empty without a
  /// best one.
  RideSpectra present_spectra = {};
  RideSpectra best_spectra = {};
  /// Of both at the fitted values, roads x metrics, SI; that of the best one empty without it.
  Eigen::MatrixXd present_metrics = {};
  Eigen::MatrixXd best_metrics = {};

  const std::vector<Knob>& knobs() const { return request.settings.knobs; }
  bool has_doubt() const { return !confidence.empty() || !benches.empty(); }
  std::size_t draws() const { return static_cast<std::size_t>(request.draws.rows()); }
  const Metric& MetricOf(const Objective& objective) const { return request.metrics[objective.metric]; }
  /// Knobs whose positions are not in doubt: those of tables and numbers, and of a bench fit without a covariance.
  std::vector<std::string> ExactKnobs() const;
  /// Whether positions lie between two settings of a bench.
  bool HasStraightLines() const;
  /// "front 12, rear 9"
  std::string NameOf(std::size_t row) const;
  /// The best setting, the present one, then those that cannot be distinguished from the best, the likeliest first; at
  /// most `count` rows, each once.
  std::vector<std::size_t> NotableRows(std::size_t count) const;
};

/// For the terminal.
std::string ChoiceText(const ChoiceAnswer& answer);

/// See schema/choose.json.
nlohmann::ordered_json ChoiceJson(const ChoiceAnswer& answer);

/// Names and texts of settings.csv, metrics.csv, test_next.csv, settings.svg, front.svg, spectra.svg and choose.html;
/// pictures where there is something to draw.
std::vector<std::pair<std::string, std::string>> ChoiceFiles(const ChoiceAnswer& answer);

}  // namespace fourpost
