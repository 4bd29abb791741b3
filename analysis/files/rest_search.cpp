#include "analysis/files/rest_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/signals/deviation.h"

namespace fourpost {
namespace {

constexpr double kKept_s = 30;
constexpr double kQuarter_s = 0.25;
/// Quarters.
constexpr std::size_t kShortest = 2;

/// `samples`, but no less than none and no more than these; a record may have any rate.
std::size_t AtMost(double most, double samples) {
  return static_cast<std::size_t>(samples < most ? std::max(0.0, samples) : most);
}

/// Of samples from `begin` on; a quarter with a gap in it or behind it is no rest.
void AddQuarters(const std::vector<double>& part, std::size_t begin, double rate_Hz,
                 std::span<const std::size_t> breaks, std::vector<double>& quarters) {
  const std::size_t quarter = AtMost(static_cast<double>(part.size()) + 1, kQuarter_s * rate_Hz);
  for (std::size_t first = 0; quarter > 0 && first + quarter <= part.size(); first += quarter) {
    const auto next = std::upper_bound(breaks.begin(), breaks.end(), begin + first);
    const bool is_broken = next != breaks.end() && *next <= begin + first + quarter;
    quarters.push_back(is_broken ? std::numeric_limits<double>::infinity()
                                 : DeviationOf({part.begin() + static_cast<std::ptrdiff_t>(first),
                                                part.begin() + static_cast<std::ptrdiff_t>(first + quarter)}));
  }
}

}  // namespace

void RestSearch::Add(std::span<const double> values, double rate_Hz, std::span<const std::size_t> breaks) {
  Channel channel{.rate_Hz = rate_Hz, .count = values.size()};
  // Of a very fast recorder less, so that many channels fit into memory.
  constexpr double kMost = 1e5;
  const std::size_t kept = AtMost(kMost, breaks.empty() ? kKept_s * rate_Hz : kMost);
  const std::size_t begin = std::min(kept, values.size());
  const std::size_t end = std::min(kept, values.size() - begin);
  channel.begin.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(begin));
  channel.end.assign(values.end() - static_cast<std::ptrdiff_t>(end), values.end());
  channel.deviation = DeviationOf({values.begin(), values.end()});
  AddQuarters(channel.begin, 0, rate_Hz, breaks, channel.quarters);
  channel.quarters_of_begin = channel.quarters.size();
  AddQuarters(channel.end, values.size() - end, rate_Hz, breaks, channel.quarters);
  channels_.push_back(std::move(channel));
}

bool RestSearch::Decides(const Channel& channel) const {
  constexpr double kMoves = 10;
  if (channel.quarters.empty() || !std::isfinite(channel.deviation)) return false;
  const double least = *std::min_element(channel.quarters.begin(), channel.quarters.end());
  return channel.deviation > kMoves * least;
}

bool RestSearch::Rests(std::size_t quarter) const {
  constexpr double kQuiet = 2;
  constexpr double kOfAll = 0.1;
  return std::all_of(channels_.begin(), channels_.end(), [&](const Channel& channel) {
    if (!Decides(channel)) return true;
    if (quarter >= channel.quarters.size()) return false;
    const double least = *std::min_element(channel.quarters.begin(), channel.quarters.end());
    // A posts' command may stand exactly.
    return channel.quarters[quarter] <= std::max(kQuiet * least, 1e-9 * channel.deviation) &&
           channel.quarters[quarter] <= kOfAll * channel.deviation;
  });
}

std::optional<RestTime> RestSearch::Longest() const {
  const auto first = std::find_if(channels_.begin(), channels_.end(), [&](const Channel& c) { return Decides(c); });
  if (first == channels_.end()) return std::nullopt;
  std::size_t best = 0;
  std::size_t best_length = 0;
  std::size_t length = 0;
  for (std::size_t quarter = 0; quarter < first->quarters.size(); ++quarter) {
    if (quarter == first->quarters_of_begin) length = 0;
    length = Rests(quarter) ? length + 1 : 0;
    if (length <= best_length) continue;
    best_length = length;
    best = quarter + 1 - length;
  }
  if (best_length < kShortest) return std::nullopt;
  const double end_s = static_cast<double>(first->count - first->end.size()) / first->rate_Hz;
  const bool is_at_end = best >= first->quarters_of_begin;
  const double from_s = is_at_end ? end_s + kQuarter_s * static_cast<double>(best - first->quarters_of_begin)
                                  : kQuarter_s * static_cast<double>(best);
  return RestTime{from_s, from_s + kQuarter_s * static_cast<double>(best_length)};
}

std::vector<double> RestSearch::Samples(std::size_t channel, const RestTime& rest) const {
  const Channel& of = channels_[channel];
  std::vector<double> samples;
  if (of.quarters.empty()) return samples;
  const auto first = static_cast<std::size_t>(std::ceil(rest.from_s * of.rate_Hz));
  const auto last = static_cast<std::size_t>(rest.to_s * of.rate_Hz);
  const std::size_t end_begins = of.count - of.end.size();
  for (std::size_t k = first; k < last && k < of.count; ++k) {
    if (k >= end_begins) samples.push_back(of.end[k - end_begins]);
    else if (k < of.begin.size()) samples.push_back(of.begin[k]);
  }
  if (!std::all_of(samples.begin(), samples.end(), [](double value) { return std::isfinite(value); })) return {};
  return samples;
}

}  // namespace fourpost
