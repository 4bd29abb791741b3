#include "identify/experiments/covered_ranges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "analysis/text/text_table.h"
#include "identify/experiments/findings.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

struct QuantityNames {
  std::string_view key;
  /// Words of a range before its numbers.
  const char* word;
  const char* unit;
  /// In the unit of texts.
  const char* shown_unit;
  double shown;
  const Finding* finding;
};

/// In the order of CoveredQuantity.
constexpr std::array<QuantityNames, 6> kQuantities = {{
    {"bump_speed", " bump", "m/s", "m/s", 1, &kSpeedsNotCovered},
    {"rebound_speed", " rebound", "m/s", "m/s", 1, &kSpeedsNotCovered},
    {"travel", "", "m", "mm", 1e3, &kTravelsNotCovered},
    {"tyre_load", "", "N", "N", 1, &kLoadsNotCovered},
    {"frequency", "", "Hz", "Hz", 1, &kFrequenciesNotCovered},
    {"amplitude", "", "m", "mm", 1e3, &kAmplitudesNotCovered},
}};

const QuantityNames& NamesOf(CoveredQuantity quantity) { return kQuantities[static_cast<std::size_t>(quantity)]; }

/// Of a range about zero or about what is there at rest; other ranges begin at zero.
bool IsSpan(CoveredQuantity quantity) {
  return quantity == CoveredQuantity::kSpringTravel || quantity == CoveredQuantity::kTyreLoad;
}

bool Leaves(const CoveredRange& fit, const CoveredRange& prediction) {
  // A fifth of frequencies, some third of an octave, and a tenth of all else.
  const double margin = fit.quantity == CoveredQuantity::kPostFrequency ? 0.2 : 0.1;
  const double span = fit.upper - fit.lower;
  const double below = margin * (IsSpan(fit.quantity) ? span : std::abs(fit.lower));
  const double above = margin * (IsSpan(fit.quantity) ? span : std::abs(fit.upper));
  // An amplitude from zero on is that of any history.
  const bool has_lower = IsSpan(fit.quantity) || prediction.lower > 0;
  return (has_lower && prediction.lower < fit.lower - below) || prediction.upper > fit.upper + above;
}

std::string RangeText(const CoveredRange& range) {
  const QuantityNames& names = NamesOf(range.quantity);
  const auto shown = [&](double value) { return Rounded(value * names.shown, 3); };
  const bool is_speed = names.finding == &kSpeedsNotCovered;
  const std::string text = is_speed ? "up to " + shown(range.upper) : shown(range.lower) + " to " + shown(range.upper);
  return text + " " + names.shown_unit;
}

}  // namespace

void CoveredRanges::Add(CoveredQuantity quantity, const std::string& element, double lower, double upper) {
  if (!std::isfinite(lower) || !std::isfinite(upper)) return;
  for (CoveredRange& range : all_) {
    if (range.quantity != quantity || range.element != element) continue;
    range.lower = std::min(range.lower, lower);
    range.upper = std::max(range.upper, upper);
    return;
  }
  all_.push_back({quantity, element, lower, upper});
}

void CoveredRanges::Add(const CoveredRanges& others) {
  for (const CoveredRange& range : others.all_) Add(range.quantity, range.element, range.lower, range.upper);
}

const CoveredRange* CoveredRanges::Find(CoveredQuantity quantity, const std::string& element) const {
  for (const CoveredRange& range : all_)
    if (range.quantity == quantity && range.element == element) return &range;
  return nullptr;
}

Json CoveredJson(const CoveredRanges& ranges) {
  Json list = Json::array();
  for (const CoveredRange& range : ranges.all()) {
    const QuantityNames& names = NamesOf(range.quantity);
    list.push_back({{"quantity", names.key},
                    {"element", range.element},
                    {"lower", range.lower},
                    {"upper", range.upper},
                    {"unit", names.unit}});
  }
  return list;
}

CoveredRanges ReadCovered(const std::filesystem::path& result) {
  CoveredRanges ranges;
  for (const nlohmann::json& entry : ListAt(ReadResultFile(result), "covered")) {
    const std::string key = TextAt(entry, "quantity");
    for (std::size_t i = 0; i < kQuantities.size(); ++i)
      if (kQuantities[i].key == key)
        ranges.Add(static_cast<CoveredQuantity>(i), TextAt(entry, "element"), NumberAt(entry, "lower"),
                   NumberAt(entry, "upper"));
  }
  return ranges;
}

void WarnOfLeaving(const CoveredRanges& fit, const CoveredRanges& prediction, const Place& place,
                   Diagnostics& findings) {
  std::vector<std::pair<const Finding*, std::string>> found;
  for (const CoveredRange& range : prediction.all()) {
    const CoveredRange* const covered = fit.Find(range.quantity, range.element);
    if (!covered || !Leaves(*covered, range)) continue;
    const QuantityNames& names = NamesOf(range.quantity);
    const std::string text = range.element + names.word + " " + RangeText(range) + " (fit " + RangeText(*covered) + ")";
    if (!found.empty() && found.back().first == names.finding) found.back().second += ", " + text;
    else found.emplace_back(names.finding, text);
  }
  for (const auto& [finding, text] : found) findings.Report(*finding, place, {text});
}

}  // namespace fourpost
