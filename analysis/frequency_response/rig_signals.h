#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// What a rig recorded: posts and other channels, sampled at once and evenly, all of one length.
struct RigSignals {
  double rate_Hz = 0;
  std::vector<std::span<const double>> posts;
  std::vector<std::span<const double>> channels;

  std::size_t samples() const { return posts.empty() ? 0 : posts.front().size(); }
};

}  // namespace fourpost
