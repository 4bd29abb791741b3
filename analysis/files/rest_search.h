#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fourpost {

/// A time in which nothing moves, from the begin of a record.
struct RestTime {
  double from_s = 0;
  double to_s = 0;
};

/// Finds where all channels of a record rest, of its first and last half minute, of one with gaps in all of it, from
/// what they look like in quarters of a second; channels are looked at one after the other and need not be kept. Times
/// are those of samples without gaps.
class RestSearch {
 public:
  /// Of one channel, all samples; no finite ones do not count. `breaks`: samples before which there is a gap, in order.
  void Add(std::span<const double> values, double rate_Hz, std::span<const std::size_t> breaks = {});

  /// The longest time, of half a second at least, in which every channel that moves by ten times its least quarter
  /// second elsewhere moves by no more than twice that, without a gap; nothing without such a channel.
  std::optional<RestTime> Longest() const;

  /// Samples of the channel that was added as the n-th, in that time; empty where it has none.
  std::vector<double> Samples(std::size_t channel, const RestTime& rest) const;
  double rate_Hz(std::size_t channel) const { return channels_[channel].rate_Hz; }

 private:
  struct Channel {
    double rate_Hz = 0;
    std::size_t count = 0;
    /// Of the record's begin and end; of a short record the begin is all of it.
    std::vector<double> begin;
    std::vector<double> end;
    /// Standard deviation of each quarter second of these, the begin's first; and of the whole record.
    std::vector<double> quarters;
    std::size_t quarters_of_begin = 0;
    double deviation = 0;
  };

  bool Decides(const Channel& channel) const;
  bool Rests(std::size_t quarter) const;

  std::vector<Channel> channels_;
};

}  // namespace fourpost
