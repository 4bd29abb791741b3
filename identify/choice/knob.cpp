#include "identify/choice/knob.h"

#include <algorithm>

namespace fourpost {
namespace {

double NumberOf(const Knob::Position& position, std::size_t of, std::optional<Eigen::Index> draw) {
  return draw && position.drawn.size() > 0 ? position.drawn(*draw, static_cast<Eigen::Index>(of)) : position.values[of];
}

double Changed(const Knob& knob, std::size_t position, std::size_t of, double fitted,
               std::optional<Eigen::Index> draw) {
  const double there = NumberOf(knob.positions[position], of, draw);
  if (knob.change == Knob::Change::kAbsolute || !knob.now) return there;
  if (position == *knob.now) return fitted;
  const double here = NumberOf(knob.positions[*knob.now], of, draw);
  return knob.change == Knob::Change::kRatio ? fitted * there / here : fitted + there - here;
}

}  // namespace

Setting PresentSetting(const std::vector<Knob>& knobs) {
  Setting setting;
  for (const Knob& knob : knobs) setting.push_back(knob.now ? static_cast<int>(*knob.now) : kAsFitted);
  return setting;
}

std::vector<double> ValuesAt(const std::vector<Knob>& knobs, const Setting& setting, std::span<const double> fitted,
                             std::optional<Eigen::Index> draw) {
  std::vector<double> values(fitted.begin(), fitted.end());
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    if (setting[k] == kAsFitted) continue;
    for (std::size_t i = 0; i < knobs[k].parameters.size(); ++i) {
      double& value = values[knobs[k].parameters[i]];
      value = Changed(knobs[k], static_cast<std::size_t>(setting[k]), i, value, draw);
    }
  }
  return values;
}

std::int64_t SettingCount(const std::vector<Knob>& knobs) {
  constexpr std::int64_t kMost = std::int64_t{1} << 62;
  std::int64_t count = 1;
  for (const Knob& knob : knobs) {
    const auto positions = static_cast<std::int64_t>(knob.positions.size());
    if (count > kMost / positions) return kMost;
    count *= positions;
  }
  return count;
}

std::vector<Setting> AllSettings(const std::vector<Knob>& knobs) {
  std::vector<Setting> settings = {{}};
  for (const Knob& knob : knobs) {
    std::vector<Setting> longer;
    longer.reserve(settings.size() * knob.positions.size() + 1);
    for (const Setting& setting : settings)
      for (std::size_t p = 0; p < knob.positions.size(); ++p) {
        longer.push_back(setting);
        longer.back().push_back(static_cast<int>(p));
      }
    settings = std::move(longer);
  }
  const Setting present = PresentSetting(knobs);
  if (std::find(present.begin(), present.end(), kAsFitted) != present.end()) settings.push_back(present);
  return settings;
}

std::vector<Setting> NeighboursOf(const std::vector<Knob>& knobs, const Setting& setting) {
  std::vector<Setting> neighbours;
  for (std::size_t k = 0; k < knobs.size(); ++k)
    for (const int step : {-1, 1}) {
      const int position = setting[k] + step;
      if (setting[k] == kAsFitted || position < 0 || position >= static_cast<int>(knobs[k].positions.size())) continue;
      neighbours.push_back(setting);
      neighbours.back()[k] = position;
    }
  return neighbours;
}

std::string SettingText(const std::vector<Knob>& knobs, const Setting& setting) {
  std::string text;
  for (std::size_t k = 0; k < knobs.size(); ++k)
    text += (text.empty() ? "" : ", ") + knobs[k].name + ' ' + PositionText(knobs[k], setting[k]);
  return text;
}

std::string PositionText(const Knob& knob, int position) {
  return position == kAsFitted ? "as fitted" : knob.positions[static_cast<std::size_t>(position)].name;
}

}  // namespace fourpost
