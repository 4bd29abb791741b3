#include "identify/draws.h"

namespace fourpost {
namespace {

// 2^64 over the golden ratio, the increment of SplitMix64.
constexpr std::uint64_t kIncrement = 0x9e3779b97f4a7c15u;

}  // namespace

std::uint64_t MixBits(std::uint64_t bits) {
  bits += kIncrement;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

Draws::Draws(std::uint64_t seed, DrawPurpose purpose, std::int64_t generation, std::size_t individual)
    : state_(MixBits(seed)) {
  state_ = MixBits(state_ ^ static_cast<std::uint64_t>(purpose));
  state_ = MixBits(state_ ^ static_cast<std::uint64_t>(generation));
  state_ = MixBits(state_ ^ static_cast<std::uint64_t>(individual));
}

std::uint64_t Draws::Bits() {
  const std::uint64_t bits = MixBits(state_);
  state_ += kIncrement;
  return bits;
}

double Draws::Uniform() { return static_cast<double>(Bits() >> 11) * 0x1.0p-53; }

std::int64_t Draws::Integer(std::int64_t first, std::int64_t last) {
  const auto count = static_cast<std::uint64_t>(last - first) + 1;
  const std::uint64_t excess = (0 - count) % count;
  std::uint64_t bits = Bits();
  while (bits < excess) bits = Bits();
  return first + static_cast<std::int64_t>(bits % count);
}

}  // namespace fourpost
