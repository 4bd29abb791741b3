#include "identify/experiments/time_history/release_text.h"

#include <sstream>

#include "analysis/text/units.h"

namespace fourpost {
namespace {

std::string Trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::optional<Release::Hold> ParseHold(const std::string& text) {
  const std::size_t mark = text.find('=');
  if (mark == std::string::npos) return std::nullopt;
  Release::Hold hold{.sensor = Trimmed(text.substr(0, mark))};
  const std::string reading = Trimmed(text.substr(mark + 1));
  if (hold.sensor.empty()) return std::nullopt;
  if (reading == "estimated") return hold;
  const std::optional<Quantity> height = ParseQuantity(reading);
  if (!height || height->unit.dimension != kLength) return std::nullopt;
  hold.reading_m = height->si;
  return hold;
}

}  // namespace

std::optional<Release> ParseRelease(const std::string& text) {
  const std::string word = Trimmed(text);
  if (word == "estimated") return Release{.from = Release::From::kAnyState};
  if (word == "at rest") return Release{.from = Release::From::kRest};
  Release release{.from = Release::From::kHeld};
  std::istringstream parts(word);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::optional<Release::Hold> hold = ParseHold(part);
    if (!hold) return std::nullopt;
    release.held.push_back(*hold);
  }
  if (release.held.empty()) return std::nullopt;
  return release;
}

}  // namespace fourpost
