#pragma once

#include <cstdint>

namespace fourpost {

/// 2^64 over the golden ratio, the increment of SplitMix64.
inline constexpr std::uint64_t kSplitMixIncrement = 0x9e3779b97f4a7c15u;

/// Mixes 64 bits one-to-one: output function of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014, "mix64variant13").
constexpr std::uint64_t MixBits(std::uint64_t bits) {
  bits += kSplitMixIncrement;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

}  // namespace fourpost
