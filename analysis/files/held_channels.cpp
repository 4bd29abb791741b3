#include "analysis/files/held_channels.h"

#include <algorithm>
#include <limits>
#include <string>

#include "analysis/files/findings.h"
#include "analysis/files/sample_times.h"
#include "analysis/signals/held_samples.h"
#include "analysis/text/counted.h"
#include "analysis/text/enumeration.h"

namespace fourpost {
namespace {

using Held = std::vector<HeldSamples>;

std::size_t SamplesOf(const Held& held) {
  std::size_t samples = 0;
  for (const HeldSamples& one : held) samples += one.last - one.first + 1;
  return samples;
}

bool AreAlike(const Held& a, const Held& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const HeldSamples& one, const HeldSamples& other) {
    return one.first == other.first && one.last == other.last;
  });
}

}  // namespace

std::vector<std::vector<BridgedGap>> LeaveOutHeld(const RecordedTable& table, std::span<const RecordedChannel> wanted,
                                                  std::span<const double> times,
                                                  std::vector<std::vector<double>>& channels,
                                                  Diagnostics& diagnostics) {
  std::vector<Held> all = HeldStretches(channels);
  std::vector<std::vector<BridgedGap>> gaps(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i)
    for (const HeldSamples& held : all[i]) {
      gaps[i].push_back({times[held.first - 1], times[held.last + 1]});
      std::fill_n(channels[i].begin() + static_cast<std::ptrdiff_t>(held.first), held.last - held.first + 1,
                  std::numeric_limits<double>::quiet_NaN());
    }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].empty()) continue;
    const Held here = all[i];
    std::vector<std::string> names;
    for (std::size_t j = i; j < all.size(); ++j) {
      if (!AreAlike(all[j], here)) continue;
      names.push_back("'" + wanted[j].names.front() + "'");
      all[j].clear();
    }
    diagnostics.Report(kChannelHeld, {table.file(), table.line(here.front().first)},
                       {Enumeration(names), SecondsText(gaps[i].front().from_s), SecondsText(gaps[i].front().to_s),
                        here.size() > 1 ? ", and in " + Counted(here.size() - 1, "later place") : "",
                        std::to_string(SamplesOf(here))});
  }
  return gaps;
}

double NotHeld_s(const BridgedGap& gap, const std::vector<BridgedGap>& held) {
  double open_s = gap.to_s - gap.from_s;
  for (const BridgedGap& one : held)
    open_s -= std::max(0.0, std::min(gap.to_s, one.to_s) - std::max(gap.from_s, one.from_s));
  return open_s;
}

}  // namespace fourpost
