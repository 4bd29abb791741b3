#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/choice/choice.h"

namespace fourpost {

/// A choice, and what it was made of.
struct ChoiceAnswer {
  /// The folder of the run, or the vehicle file.
  std::string subject;
  /// "80 to 90 %", of the intervals whose doubt the draws carry; empty: the choice is without doubt.
  std::string confidence;
  ChoiceRequest request;
  Choice choice;

  const std::vector<Knob>& knobs() const { return request.settings.knobs; }
  std::size_t draws() const { return static_cast<std::size_t>(request.draws.rows()); }
  const Metric& MetricOf(const Objective& objective) const { return request.metrics[objective.metric]; }
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

/// Names and texts of settings.csv, test_next.csv, settings.svg, front.svg and choose.html; pictures where there is
/// something to draw.
std::vector<std::pair<std::string, std::string>> ChoiceFiles(const ChoiceAnswer& answer);

}  // namespace fourpost
