#pragma once

#include <cstdint>
#include <string_view>

namespace fourpost {

/// Random numbers that are a pure function of (seed, purpose, stream, number of the draw), on any machine and in any
/// order of the streams. SplitMix64 from a state that is the hash of the first three.
class RandomStream {
 public:
  /// `purpose`: what the numbers are for, such as "noise", so that equal seeds and streams for two purposes have
  /// nothing in common.
  RandomStream(std::uint64_t seed, std::string_view purpose, std::uint64_t stream = 0);

  /// Uniform in [0, 1), multiples of 2^-53.
  double Uniform();
  /// Normal with mean 0 and standard deviation 1 (Box and Muller 1958); takes two uniform numbers.
  double Normal();

 private:
  std::uint64_t state_;
};

}  // namespace fourpost
