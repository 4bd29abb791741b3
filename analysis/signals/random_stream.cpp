#include "analysis/signals/random_stream.h"

#include <cmath>
#include <numbers>

#include "analysis/signals/mix_bits.h"

namespace fourpost {

namespace {

/// FNV-1a (Fowler, Noll, Vo).
std::uint64_t Hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3u;
  return hash;
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view purpose, std::uint64_t stream)
    : state_(MixBits(MixBits(MixBits(seed) ^ Hash(purpose)) ^ stream)) {}

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
