#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/files/sha256.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Parameters of a vehicle that follow a control of a recording, such as a damper's current or its clicks, as a study
/// states them under 'control'.
struct StudyControl {
  struct Follower {
    std::string parameter;
    /// A straight line over the control; else one value per setting, and straight lines between.
    bool is_linear = false;
    int line = 0;
  };
  std::vector<Follower> followers;
};

/// "yield_at_1p5": the parameter that holds the value of another at a setting.
std::string NameAtSetting(const std::string& parameter, double setting);

/// Values of a vehicle's parameters at one setting: of each blend
///   values[parameter] = (1 - share) values[lower] + share values[upper].
struct ControlSetting {
  struct Blend {
    std::size_t parameter = 0;
    std::size_t lower = 0;
    std::size_t upper = 0;
    double share = 0;

    bool operator==(const Blend&) const = default;
  };
  std::vector<Blend> blends = {};

  std::vector<double> At(const std::vector<double>& values) const;
  bool operator==(const ControlSetting&) const = default;
};

/// A study's control in the terms of a vehicle.
class Control {
 public:
  Control() = default;
  /// `settings`: of the fitted recordings, increasing. A follower itself holds the value at the lowest one; those at
  /// the others are parameters of the vehicle by the names of NameAtSetting(); `names`: of all its parameters.
  Control(const StudyControl& control, const std::vector<double>& settings, const std::vector<std::string>& names);

  /// Beyond the settings of the fit a line goes on, and a value per setting stays as it is at the nearest one.
  ControlSetting At(double setting) const;
  bool empty() const { return followers_.empty(); }

 private:
  struct Follower {
    bool is_linear = false;
    std::vector<double> settings;
    /// The follower itself first.
    std::vector<std::size_t> parameters;
  };
  std::vector<Follower> followers_;
};

/// That of a recording, with a fault where it states none although parameters follow one, or one that nothing follows.
ControlSetting SettingOf(const Control& control, const std::optional<double>& setting, const std::string& recording,
                         const Place& place, Diagnostics& diagnostics);

/// Settings are part of what a fit depends on.
void AddTo(Sha256& digest, const ControlSetting& setting);

/// Settings at which a follower has a parameter of its own.
std::vector<double> KnotsOf(const StudyControl::Follower& follower, const std::vector<double>& settings);

}  // namespace fourpost
