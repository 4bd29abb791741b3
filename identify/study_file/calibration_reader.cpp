#include "identify/study_file/calibration_reader.h"

#include "analysis/text/text_table.h"
#include "analysis/text/units.h"
#include "identify/study_file/findings.h"

namespace fourpost {
namespace {

void ReadKind(const StrictMap& map, const char* key, Calibration::Kind kind, const Dimension& dimension,
              const std::string& file, Diagnostics& diagnostics, std::vector<Calibration>& calibrations) {
  if (!map.Has(key)) return;
  const YAML::Node node = map.Get(key);
  if (!node.IsMap() || node.size() == 0) return diagnostics.Report(kCalibrationNotMapped, {file, LineOf(node)}, {key});
  std::vector<std::string> names;
  for (const auto& entry : node) names.push_back(entry.first.as<std::string>());
  // Reports names that stand twice.
  const StrictMap unique(node, "'" + std::string(key) + "'", {names.begin(), names.end()}, file, diagnostics);
  for (const std::string& name : names) {
    const auto sd = ReadQuantity(node[name], dimension, "'" + name + "'", file, diagnostics);
    if (sd && !(*sd > 0)) diagnostics.Report(kCalibrationNotPositive, {file, LineOf(node[name])}, {name});
    constexpr double kWidestGain = 0.5;
    if (sd && kind == Calibration::Kind::kGain && *sd > kWidestGain)
      diagnostics.Report(kCalibrationGainWide, {file, LineOf(node[name])}, {name, Rounded(100 * *sd, 3) + " %"});
    const bool is_offset = kind == Calibration::Kind::kOffset;
    if (is_offset && name != Calibration::kStaticLoads)
      diagnostics.Report(kCalibrationOffset, {file, LineOf(node[name])}, {name});
    if (kind == Calibration::Kind::kDelay && name == Calibration::kStaticLoads)
      diagnostics.Report(kCalibrationDelayAtRest, {file, LineOf(node[name])});
    calibrations.push_back({.kind = kind, .of = name, .sd = sd.value_or(0), .line = LineOf(node[name])});
  }
}

}  // namespace

std::vector<Calibration> ReadCalibrations(const YAML::Node& node, const std::string& file, Diagnostics& diagnostics) {
  const StrictMap map(node, "'calibration'", {"gain", "delay", "offset"}, file, diagnostics);
  std::vector<Calibration> calibrations;
  const auto read = [&](const char* key, Calibration::Kind kind, const Dimension& dimension) {
    ReadKind(map, key, kind, dimension, file, diagnostics, calibrations);
  };
  read("gain", Calibration::Kind::kGain, kDimensionless);
  read("delay", Calibration::Kind::kDelay, kTime);
  read("offset", Calibration::Kind::kOffset, kForce);
  return calibrations;
}

}  // namespace fourpost
