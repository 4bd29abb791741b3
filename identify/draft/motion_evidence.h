#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "identify/draft/file_reading.h"
#include "vehicles/condensed/condensed_model.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// How the channels of recordings move beside the sensors of the vehicle as its file has it: the correlation of complex
/// responses over frequencies, the mean over motions.
class MotionEvidence {
 public:
  MotionEvidence(const Vehicle& vehicle, const CondensedModel* model) : vehicle_(vehicle), model_(model) {}

  /// Adds the motions of a file. One whose posts are not known is taken as that pattern in which channels that are
  /// named as sensors are move as these do; it is then set.
  void Add(FileReading& reading);

  std::optional<double> Of(const std::string& sensor, const std::string& channel) const;

 private:
  struct Sum {
    double correlations = 0;
    int count = 0;
  };

  FrequencyResponse Modelled(const DraftedMotion& motion, const std::vector<double>& shape) const;
  std::vector<double> LikeliestShape(const FileReading& reading, const DraftedMotion& motion) const;

  const Vehicle& vehicle_;
  /// Null of a vehicle without posts, which nothing is added to.
  const CondensedModel* model_;
  std::map<std::pair<std::string, std::string>, Sum> sums_;
};

}  // namespace fourpost
