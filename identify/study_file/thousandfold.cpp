#include "identify/study_file/thousandfold.h"

#include <array>
#include <cmath>

#include "analysis/files/recorded_table.h"
#include "analysis/files/recorded_unit.h"

namespace fourpost {
namespace {

std::string StatedUnit(const SourceChannel& channel, const std::vector<std::filesystem::path>& files) {
  if (!channel.unit.empty()) return channel.unit;
  Diagnostics unheard;
  for (const std::filesystem::path& file : files)
    if (const std::optional<RecordedTable> table = ReadRecordedTable(file, unheard))
      if (const std::optional<std::size_t> column = table->FindColumn(channel.name)) return table->unit(*column);
  return "";
}

/// Of the same dimension, and so many times the size; empty where it has no name.
std::string UnitOfSize(const std::string& stated, double times) {
  constexpr std::array kNames = {"m",  "mm",  "um",  "km",   "in",    "N",      "MN",
                                 "kN", "lbf", "m/s", "mm/s", "m/s^2", "mm/s^2", "g"};
  const std::optional<Unit> unit = ParseRecordedUnit(stated);
  if (!unit) return "";
  constexpr double kRounding = 1e-9;
  for (const char* name : kNames)
    if (const std::optional<Unit> other = ParseRecordedUnit(name);
        other && other->dimension == unit->dimension && std::abs(other->si / (times * unit->si) - 1) < kRounding)
      return name;
  return "";
}

}  // namespace

int ThousandfoldOf(double ratio) {
  // Masses, rates and amplitudes of a vehicle file are guesses, though none is off by as much.
  constexpr double kThousand = 1000;
  constexpr double kNear = 5;
  if (!(ratio > 0)) return 0;
  if (ratio > kThousand / kNear && ratio < kThousand * kNear) return 1;
  return ratio < kNear / kThousand && ratio > 1 / (kThousand * kNear) ? -1 : 0;
}

ChannelSource WithUnitMeant(ChannelSource source, int direction, const std::vector<std::filesystem::path>& files) {
  const double times = direction > 0 ? 1e-3 : 1e3;
  for (SourceChannel& channel : source.channels) {
    const std::string meant = UnitOfSize(StatedUnit(channel, files), times);
    if (meant.empty()) channel.factor *= times;
    else channel.unit = meant;
  }
  return source;
}

std::optional<ChannelSource> WithUnitOfTimes(ChannelSource source, double times,
                                             const std::vector<std::filesystem::path>& files) {
  for (SourceChannel& channel : source.channels) {
    const std::string meant = UnitOfSize(StatedUnit(channel, files), times);
    if (meant.empty()) return std::nullopt;
    channel.unit = meant;
  }
  return source;
}

std::string StatedUnitOf(const ChannelSource& source, const std::vector<std::filesystem::path>& files) {
  return source.channels.empty() ? "" : StatedUnit(source.channels.front(), files);
}

}  // namespace fourpost
