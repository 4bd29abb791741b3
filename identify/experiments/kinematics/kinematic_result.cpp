#include "identify/experiments/kinematics/kinematic_result.h"

#include <cmath>

#include "analysis/files/csv_writer.h"
#include "analysis/files/json_text.h"
#include "analysis/text/text_table.h"
#include "identify/experiments/kinematics/kinematic_residuals.h"

namespace fourpost {
namespace {

double SizeOf(const std::string& unit) { return unit.empty() ? 1 : ParseUnit(unit)->si; }

std::string UnitOf(const KinematicCurve& curve) { return std::string(curve.quantity->unit); }

Eigen::VectorXd MeasuredOf(const KinematicCurve& curve) {
  return Eigen::Map<const Eigen::VectorXd>(curve.measured.data(), std::ssize(curve.measured));
}

}  // namespace

std::vector<KinematicMisfit> KinematicMisfits(std::span<const KinematicSweep> sweeps, const KinematicAnswer& answer) {
  std::vector<KinematicMisfit> misfits;
  for (std::size_t s = 0; s < sweeps.size(); ++s)
    for (std::size_t c = 0; c < sweeps[s].curves.size(); ++c) {
      const KinematicCurve& curve = sweeps[s].curves[c];
      KinematicMisfit one{.sweep = &sweeps[s], .curve = &curve, .modelled = answer.sweeps[s][c]};
      one.offset = FittedOffset(curve, one.modelled);
      const Eigen::ArrayXd off = (MeasuredOf(curve) - one.modelled).array() - one.offset;
      one.rms = std::sqrt(off.square().mean());
      const Eigen::VectorXd residuals = CurveResiduals(curve, one.modelled);
      one.misfit = std::sqrt(residuals.squaredNorm() / static_cast<double>(curve.degrees()));
      misfits.push_back(std::move(one));
    }
  return misfits;
}

std::string KinematicTable(std::span<const KinematicMisfit> misfits) {
  if (misfits.empty()) return "";
  TextTable table(
      {"rig table", "motion", "quantity", "of", "unit", "points", "rms error", "noise", "misfit", "offset"});
  for (const KinematicMisfit& one : misfits) {
    const std::string unit = UnitOf(*one.curve);
    table.Add({one.sweep->recording + (one.sweep->is_validation ? " (validation)" : ""), one.sweep->motion,
               std::string(one.curve->quantity->name), one.curve->of_name, unit,
               std::to_string(one.curve->measured.size()), InUnit(one.rms, unit, 3), InUnit(one.curve->sd, unit, 3),
               Rounded(one.misfit, 3), one.curve->has_free_offset ? InUnit(one.offset, unit, 3) : ""});
  }
  return table.Format() + '\n';
}

nlohmann::ordered_json KinematicJson(std::span<const KinematicMisfit> misfits) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const KinematicMisfit& one : misfits) {
    const std::string unit = UnitOf(*one.curve);
    const double size = SizeOf(unit);
    nlohmann::ordered_json item = {{"recording", one.sweep->recording},
                                   {"use", one.sweep->is_validation ? "validation" : "fit"},
                                   {"axle", one.sweep->axle_name},
                                   {"motion", one.sweep->motion},
                                   {"quantity", one.curve->quantity->name},
                                   {"of", one.curve->of_name},
                                   {"unit", unit},
                                   {"points", one.curve->measured.size()},
                                   {"noise", one.curve->sd / size},
                                   {"rms", one.rms / size},
                                   {"misfit", NumberOrNull(one.misfit)}};
    if (one.curve->has_free_offset) item["offset"] = one.offset / size;
    list.push_back(std::move(item));
  }
  return list;
}

std::string KinematicCsv(std::span<const KinematicMisfit> misfits) {
  CsvWriter csv({"recording", "axle", "motion", "quantity", "of", "position", "position_unit", "measured", "modelled",
                 "offset", "unit", "sd"});
  for (const KinematicMisfit& one : misfits) {
    const std::string unit = UnitOf(*one.curve);
    const double size = SizeOf(unit);
    const std::string position_unit = one.sweep->position_unit();
    for (std::size_t i = 0; i < one.curve->measured.size(); ++i) {
      csv.Add(one.sweep->recording).Add(one.sweep->axle_name).Add(one.sweep->motion);
      csv.Add(one.curve->quantity->name).Add(one.curve->of_name);
      csv.Add(one.sweep->positions[one.curve->places[i]] / SizeOf(position_unit)).Add(position_unit);
      csv.Add(one.curve->measured[i] / size).Add(one.modelled[static_cast<Eigen::Index>(i)] / size);
      csv.Add(one.offset / size).Add(unit).Add(one.curve->sd / size);
    }
  }
  return csv.text();
}

std::vector<ErrorShare> KinematicShares(std::span<const KinematicMisfit> misfits) {
  std::vector<ErrorShare> shares;
  for (const KinematicMisfit& one : misfits) {
    if (one.sweep->is_validation) continue;
    const Eigen::ArrayXd measured = MeasuredOf(*one.curve).array();
    const auto count = static_cast<double>(measured.size());
    // Noise about a constant that nothing moves would count as an error of all that was measured.
    const double noise = count * one.curve->sd * one.curve->sd;
    shares.push_back({.channel = std::string(one.curve->quantity->name) + " of " + one.curve->of_name,
                      .recording = one.sweep->recording,
                      .kind = "rig " + std::string(one.curve->quantity->name),
                      .unit = UnitOf(*one.curve),
                      .error = std::max(0.0, one.rms * one.rms * count - noise),
                      .measured = (measured - measured.mean()).square().sum()});
  }
  return shares;
}

}  // namespace fourpost
