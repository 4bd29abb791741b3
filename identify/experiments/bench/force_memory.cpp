#include "identify/experiments/bench/force_memory.h"

#include <algorithm>
#include <set>
#include <utility>

#include "vehicles/description/element_list.h"

namespace fourpost {
namespace {

/// Numbers of all recordings [8 bytes].
constexpr std::size_t kMostNumbers = 16'000'000;
constexpr std::size_t kMostForces = 64;

}  // namespace

ForceMemory::ForceMemory(const Vehicle& vehicle, const std::vector<BenchRecording>& recordings)
    : known_(recordings.size()) {
  std::set<std::size_t> sources;
  for (const BenchRecording& recording : recordings)
    for (const ControlSetting::Blend& blend : recording.setting.blends)
      for (const std::size_t source : {blend.lower, blend.upper})
        if (source != blend.parameter) sources.insert(source);
  for (const ElementNumber& one : NumbersOf(vehicle))
    if (one.number.parameter >= 0) sources.erase(static_cast<std::size_t>(one.number.parameter));
  at_settings_.assign(sources.begin(), sources.end());
}

std::vector<double> ForceMemory::Key(const BenchRecording& recording, const std::vector<double>& values) const {
  std::vector<double> key = recording.setting.At(values);
  for (const std::size_t place : at_settings_) key[place] = 0;
  return key;
}

std::shared_ptr<const std::vector<double>> ForceMemory::Of(std::size_t place, const BenchDamper& damper,
                                                           const BenchRecording& recording,
                                                           const std::vector<double>& values) {
  std::vector<double> key = Key(recording, values);
  std::list<Known>& known = known_[place];
  {
    const std::lock_guard lock(guard_);
    const auto found = std::find_if(known.begin(), known.end(), [&](const Known& one) { return one.by == key; });
    if (found != known.end()) {
      known.splice(known.begin(), known, found);
      return known.front().force;
    }
  }
  auto force = std::make_shared<const std::vector<double>>(ModelledForce(damper, recording, values));
  const std::lock_guard lock(guard_);
  ++modelled_;
  known.push_front({std::move(key), force});
  const std::size_t most =
      std::clamp<std::size_t>(kMostNumbers / std::max<std::size_t>(1, known_.size() * force->size()), 2, kMostForces);
  if (known.size() > most) known.pop_back();
  return force;
}

}  // namespace fourpost
