#include "identify/search/draws.h"

#include <cmath>
#include <numbers>

namespace fourpost {
Draws::Draws(std::uint64_t seed, DrawPurpose purpose, std::int64_t generation, std::size_t individual)
    : state_(MixBits(seed)) {
  state_ = MixBits(state_ ^ static_cast<std::uint64_t>(purpose));
  state_ = MixBits(state_ ^ static_cast<std::uint64_t>(generation));
  state_ = MixBits(state_ ^ static_cast<std::uint64_t>(individual));
}

std::uint64_t Draws::Bits() {
  const std::uint64_t bits = MixBits(state_);
  state_ += kSplitMixIncrement;
  return bits;
}

double Draws::Uniform() { return static_cast<double>(Bits() >> 11) * 0x1.0p-53; }

double Draws::Normal() {
  const double radius = std::sqrt(-2 * std::log1p(-Uniform()));
  return radius * std::cos(2 * std::numbers::pi * Uniform());
}

std::int64_t Draws::Integer(std::int64_t first, std::int64_t last) {
  const auto count = static_cast<std::uint64_t>(last - first) + 1;
  const std::uint64_t excess = (0 - count) % count;
  std::uint64_t bits = Bits();
  while (bits < excess) bits = Bits();
  return first + static_cast<std::int64_t>(bits % count);
}

}  // namespace fourpost
