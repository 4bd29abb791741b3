#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fourpost {

/// Deflate packs zeros no closer (zlib.net, "Maximum Compression Factor").
inline constexpr std::uint64_t kClosestDeflated = 1032;

/// What zlib packed into these bytes; empty where it is not `size` bytes. Takes memory only for what is there.
std::string Inflated(std::string_view packed, std::uint64_t size);

}  // namespace fourpost
