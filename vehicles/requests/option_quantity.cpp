#include "vehicles/requests/option_quantity.h"

#include "analysis/text/unit_spelling.h"
#include "vehicles/description/gravity.h"
#include "vehicles/requests/findings.h"

namespace fourpost {
namespace {

std::string Example(const Dimension& dimension) {
  if (dimension == kLength) return "5 mm";
  if (dimension == kVelocity) return "0.15 m/s";
  if (dimension == kAcceleration) return "6 m/s^2 or 0.5 g";
  if (dimension == kFrequency) return "2 Hz";
  if (dimension == kTime) return "10 s";
  return "2 " + SiUnit(dimension);
}

/// Units that mean this on a command line though they are of another dimension, or of none of their own.
std::optional<double> SiOf(const Quantity& quantity, const Dimension& dimension) {
  // Of an acceleration gravity's, not gram.
  if (dimension == kAcceleration && quantity.unit_text == "g") return quantity.si * 1e3 * kGravity;
  if (quantity.unit.dimension != dimension || quantity.unit_text.empty()) return std::nullopt;
  // 2 pi rad/s make 1 Hz.
  if (dimension == kFrequency && !quantity.unit_text.ends_with("Hz")) return std::nullopt;
  return quantity.si;
}

}  // namespace

std::optional<double> ReadQuantity(const std::string& text, const Dimension& dimension, const std::string& option,
                                   Diagnostics& diagnostics, OptionSign sign) {
  const std::optional<Quantity> quantity = ParseQuantity(text);
  const std::optional<double> si = quantity ? SiOf(*quantity, dimension) : std::nullopt;
  const Place place = Place::Option(option);
  if (!si)
    diagnostics.Report(kOptionQuantity, place, {text, DimensionName(dimension), UnitHint(text), Example(dimension)});
  else if (sign == OptionSign::kPositive && !(*si > 0)) diagnostics.Report(kOptionNotPositive, place, {text});
  else return si;
  return std::nullopt;
}

std::optional<double> ReadShare(const std::string& text, const std::string& option, Diagnostics& diagnostics) {
  const std::optional<Quantity> quantity = ParseQuantity(text);
  const Place place = Place::Option(option);
  if (!quantity || quantity->unit_text != "%") diagnostics.Report(kOptionShare, place, {text});
  else if (!(quantity->si > 0)) diagnostics.Report(kOptionNotPositive, place, {text});
  else if (quantity->si > 1) diagnostics.Report(kOptionShareAbove, place, {text});
  else return quantity->si;
  return std::nullopt;
}

std::optional<FrequencyRange> ReadFrequencyRange(const std::string& text, const std::string& option,
                                                 Diagnostics& diagnostics) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    diagnostics.Report(kOptionFrequencyRange, Place::Option(option), {text});
    return std::nullopt;
  }
  const std::optional<double> first = ReadQuantity(text.substr(0, colon), kFrequency, option, diagnostics);
  const std::optional<double> last = ReadQuantity(text.substr(colon + 1), kFrequency, option, diagnostics);
  if (!first || !last) return std::nullopt;
  return FrequencyRange{*first, *last};
}

}  // namespace fourpost
