#pragma once

#include <cstddef>
#include <cstdint>

#include "analysis/signals/mix_bits.h"

namespace fourpost {

/// What a stream of random draws is for; streams of different purpose are independent.
enum class DrawPurpose : std::uint64_t {
  kInitial = 1,
  kFactor = 2,
  kTrial = 3,
  kMigration = 4,
  kStart = 5,
  kBootstrap = 6,
  kLine = 7,
  kNoise = 8,
  kProbe = 9,
  kPosterior = 10,
  kEnsemble = 11
};

/// Random draws that are a pure function of (seed, purpose, generation, individual, number of the draw), whoever draws
/// first: results do not depend on threads. SplitMix64 from a state that is the hash of the first four.
class Draws {
 public:
  Draws(std::uint64_t seed, DrawPurpose purpose, std::int64_t generation, std::size_t individual);

  /// 64 random bits.
  std::uint64_t Bits();
  /// Uniform in [0, 1), multiples of 2^-53.
  double Uniform();
  /// Normal with mean 0 and deviation 1 (Box and Muller, of two uniform ones).
  double Normal();
  /// Uniform in first..last, both included; exact, by rejection. Needs 0 <= last - first < 2^63.
  std::int64_t Integer(std::int64_t first, std::int64_t last);

 private:
  std::uint64_t state_;
};

}  // namespace fourpost
