#include "analysis/random_stream.h"

#include <cmath>
#include <numbers>

#include "analysis/mix_bits.h"

namespace fourpost {

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream) : state_(MixBits(MixBits(seed) ^ stream)) {}

double RandomStream::Uniform() {
  const std::uint64_t bits = MixBits(state_);
  state_ += kSplitMixIncrement;
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

double RandomStream::Normal() {
  // 1 - u is never 0.
  const double radius = std::sqrt(-2 * std::log(1 - Uniform()));
  return radius * std::cos(2 * std::numbers::pi * Uniform());
}

}  // namespace fourpost
