#include "identify/study_file/control.h"

#include <algorithm>

#include "analysis/text/number.h"
#include "identify/study_file/findings.h"

namespace fourpost {

std::string NameAtSetting(const std::string& parameter, double setting) {
  std::string number = FormatNumber(setting);
  std::replace(number.begin(), number.end(), '.', 'p');
  std::replace(number.begin(), number.end(), '-', 'm');
  std::erase(number, '+');
  return parameter + "_at_" + number;
}

std::vector<double> ControlSetting::At(const std::vector<double>& values) const {
  std::vector<double> at = values;
  for (const Blend& blend : blends)
    at[blend.parameter] = (1 - blend.share) * values[blend.lower] + blend.share * values[blend.upper];
  return at;
}

ControlSetting SettingOf(const Control& control, const std::optional<double>& setting, const std::string& recording,
                         const Place& place, Diagnostics& diagnostics) {
  if (setting.has_value() == !control.empty()) return setting ? control.At(*setting) : ControlSetting();
  diagnostics.Report(setting ? kSettingWithoutControl : kSettingMissing, place, {recording});
  return {};
}

void AddTo(Sha256& digest, const ControlSetting& setting) {
  for (const ControlSetting::Blend& blend : setting.blends)
    for (const double number : {static_cast<double>(blend.parameter), static_cast<double>(blend.lower),
                                static_cast<double>(blend.upper), blend.share})
      digest.Add(number);
}

std::vector<double> KnotsOf(const StudyControl::Follower& follower, const std::vector<double>& settings) {
  if (!follower.is_linear || settings.size() < 2) return settings;
  return {settings.front(), settings.back()};
}

Control::Control(const StudyControl& control, const std::vector<double>& settings,
                 const std::vector<std::string>& names) {
  const auto index = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  for (const StudyControl::Follower& follower : control.followers) {
    Follower known{.is_linear = follower.is_linear, .settings = KnotsOf(follower, settings)};
    for (const double setting : known.settings)
      known.parameters.push_back(
          index(known.parameters.empty() ? follower.parameter : NameAtSetting(follower.parameter, setting)));
    followers_.push_back(std::move(known));
  }
}

ControlSetting Control::At(double setting) const {
  ControlSetting at;
  for (const Follower& follower : followers_) {
    if (follower.settings.size() < 2) continue;
    const auto inner = std::upper_bound(follower.settings.begin() + 1, follower.settings.end() - 1, setting);
    const auto upper = static_cast<std::size_t>(inner - follower.settings.begin());
    const double below = follower.settings[upper - 1];
    const double share = (setting - below) / (follower.settings[upper] - below);
    at.blends.push_back({.parameter = follower.parameters.front(),
                         .lower = follower.parameters[upper - 1],
                         .upper = follower.parameters[upper],
                         .share = follower.is_linear ? share : std::clamp(share, 0.0, 1.0)});
  }
  return at;
}

}  // namespace fourpost
