#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace fourpost {

/// Measured points of a channel, and how many lie outside a band of 95 %.
struct BandCount {
  std::string channel;
  std::int64_t points = 0;
  std::int64_t outside = 0;
};

/// A table by channel, and of all "94 of 1200 points (7.8 %)"; `evaluations`: what the bands took.
std::string BandCountsText(const std::vector<BandCount>& counts, std::int64_t evaluations);
nlohmann::ordered_json BandCountsJson(const std::vector<BandCount>& counts, std::int64_t evaluations);

}  // namespace fourpost
