#include "identify/experiments/band_count.h"

#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

std::string PercentOutside(const BandCount& count) {
  return count.points > 0 ? Rounded(100.0 * static_cast<double>(count.outside) / static_cast<double>(count.points), 2)
                          : "-";
}

BandCount SumOf(const std::vector<BandCount>& counts) {
  BandCount sum;
  for (const BandCount& count : counts) {
    sum.points += count.points;
    sum.outside += count.outside;
  }
  return sum;
}

}  // namespace

std::string BandCountsText(const std::vector<BandCount>& counts, std::int64_t evaluations) {
  TextTable table({"channel", "points", "outside 95 % band", "%"});
  for (const BandCount& count : counts)
    table.Add({count.channel, std::to_string(count.points), std::to_string(count.outside), PercentOutside(count)});
  const BandCount sum = SumOf(counts);
  return table.Format() + std::to_string(sum.outside) + " of " + std::to_string(sum.points) + " points (" +
         PercentOutside(sum) + " %) are outside the 95 % band of new measurements; " + std::to_string(evaluations) +
         " evaluations\n";
}

nlohmann::ordered_json BandCountsJson(const std::vector<BandCount>& counts, std::int64_t evaluations) {
  nlohmann::ordered_json channels = nlohmann::ordered_json::array();
  for (const BandCount& count : counts)
    channels.push_back({{"name", count.channel}, {"points", count.points}, {"outside", count.outside}});
  const BandCount sum = SumOf(counts);
  return {{"points", sum.points}, {"outside", sum.outside}, {"evaluations", evaluations}, {"channels", channels}};
}

}  // namespace fourpost
