#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "identify/experiments/bench/bench_data.h"

namespace fourpost {

/// Forces that were modelled lately, so that a change of a parameter at one setting does not model recordings at others
/// again. May be asked from several threads at once.
class ForceMemory {
 public:
  ForceMemory(const Vehicle& vehicle, const std::vector<BenchRecording>& recordings);

  /// ModelledForce() of the recording at this place.
  std::shared_ptr<const std::vector<double>> Of(std::size_t place, const BenchDamper& damper,
                                                const BenchRecording& recording, const std::vector<double>& values);

  /// How many forces were modelled.
  std::size_t modelled() const { return modelled_; }

 private:
  struct Known {
    /// Values that the force follows.
    std::vector<double> by;
    std::shared_ptr<const std::vector<double>> force;
  };

  std::vector<double> Key(const BenchRecording& recording, const std::vector<double>& values) const;

  /// Places of parameters that are the value of another one at a setting, and nothing else.
  std::vector<std::size_t> at_settings_;
  std::mutex guard_;
  /// Of each recording, the latest first.
  std::vector<std::list<Known>> known_;
  std::size_t modelled_ = 0;
};

}  // namespace fourpost
