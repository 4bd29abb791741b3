#pragma once

#include <string>
#include <vector>

namespace fourpost {

/// Which measured channels a quantity of the model stands for. A planar vehicle stands for both sides: it is compared
/// with the mean of left and right accelerations, or with the sum of left and right tyre forces.
struct ChannelSource {
  enum class Combine { kMean, kSum };
  Combine combine = Combine::kMean;
  std::vector<std::string> channels;
  int line = 0;
};

}  // namespace fourpost
