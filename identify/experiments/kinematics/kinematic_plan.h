#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "identify/experiments/kinematics/kinematic_quantity.h"
#include "identify/study_file/channel_source.h"
#include "identify/study_file/strict_yaml.h"

namespace fourpost {

/// One table of a kinematics and compliance rig as a study describes it; the path is resolved.
struct KinematicPlan {
  struct Noise {
    const KinematicQuantity* quantity = nullptr;
    /// Standard deviation of one measurement, SI.
    double sd = 0;
    /// Whether an unknown constant is added to every curve of it, as by static alignment or a zero of the rig.
    bool has_free_offset = false;
  };
  /// The study's.
  std::string study;
  std::string name;
  std::filesystem::path file;
  int line = 0;
  bool is_validation = false;
  /// Of the vehicle; empty: as the table says, or its only one.
  std::string axle;
  /// "heave", "roll", a wheel, or a load: "lateral", "braking", "driving", "aligning"; empty: as the table says.
  std::string motion;
  /// Of a load on both wheels: whether the right one carries the opposite of the left one; empty: as the table says, or
  /// together.
  std::optional<bool> is_opposed;
  /// Column of the travel, or of the load; empty: by its name.
  std::optional<SourceChannel> position;
  /// Columns that are not called by their quantity: "camber_left".
  std::vector<std::pair<std::string, ChannelSource>> channels;
  /// What is fitted.
  std::vector<Noise> noise;
};

/// 'kinematics' of a study. Adds every fault to the study's diagnostics.
std::vector<KinematicPlan> ReadKinematicPlans(const StrictMap& study);

}  // namespace fourpost
