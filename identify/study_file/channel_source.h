#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fourpost {

/// A measured channel, and what is done to it before it is used.
struct SourceChannel {
  SourceChannel() = default;
  /// As it was measured: a name alone is a channel.
  SourceChannel(std::string channel) : name(std::move(channel)) {}
  SourceChannel(const char* channel) : name(channel) {}
  bool operator==(const SourceChannel&) const = default;

  std::string name;
  /// In place of the unit in its file; empty: that one.
  std::string unit;
  /// Sign and scale, which it is multiplied by.
  double factor = 1;
  /// By which it comes later than what it measures.
  double delay_s = 0;
  /// What it reads at zero, as written: "3 mm"; empty: nothing is taken away.
  std::string offset;
  /// See RecordedChannel.
  bool has_trend = false;
  std::optional<double> high_pass_Hz;
  std::optional<double> integrated_above_Hz;
};

/// Which measured channels a quantity of the model stands for. A planar vehicle stands for both sides: it is compared
/// with the mean of left and right accelerations, or with the sum of left and right tyre forces.
struct ChannelSource {
  enum class Combine { kMean, kSum };
  Combine combine = Combine::kMean;
  std::vector<SourceChannel> channels;
  int line = 0;
};

}  // namespace fourpost
