#include "identify/experiments/static_loads/static_load_data.h"

#include <cmath>
#include <optional>

#include "analysis/files/static_loads.h"
#include "analysis/text/named.h"
#include "analysis/text/nearest.h"
#include "identify/experiments/static_loads/findings.h"

namespace fourpost {
namespace {

MeasuredLoad SumLoads(const StaticLoadPlan& plan, const ChannelSource& source,
                      const std::vector<StaticMeasurement>& table, Diagnostics& diagnostics) {
  const std::vector<std::string> quantities = NamesOf(table);
  MeasuredLoad load;
  for (const SourceChannel& channel : source.channels) {
    const std::string& name = channel.name;
    const std::optional<std::size_t> row = IndexOf(name, quantities);
    if (!row || table[*row].dimension != kForce) {
      diagnostics.Report(kStaticLoadMissing, {plan.file, source.line},
                         {plan.table.filename().string(), name, DidYouMean(name, quantities)});
      continue;
    }
    load.load_N += channel.factor * table[*row].value;
    load.sd_N = std::hypot(load.sd_N, channel.factor * table[*row].sd);
  }
  if (!(load.load_N > 0) && load.sd_N > 0) diagnostics.Report(kStaticLoadNotPositive, {plan.file, source.line});
  if (!(load.sd_N > 0)) diagnostics.Report(kStaticLoadWithoutDeviation, {plan.file, source.line});
  if (source.combine == ChannelSource::Combine::kMean) {
    load.load_N /= static_cast<double>(source.channels.size());
    load.sd_N /= static_cast<double>(source.channels.size());
  }
  return load;
}

/// Loads are linear in masses and smooth in all else, and exact to rounding.
Eigen::MatrixXd LoadSlopes(const CondensedVehicle& vehicle, const std::vector<MeasuredLoad>& loads,
                           const std::vector<double>& values, const std::vector<std::size_t>& parameters) {
  Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(loads.size()), static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const double value = values[parameters[p]];
    const double step = 1e-5 * (value != 0 ? std::abs(value) : 1);
    std::vector<double> moved = values;
    moved[parameters[p]] = value + step;
    const Preloads above = vehicle.PreloadsAt(moved);
    moved[parameters[p]] = value - step;
    const Preloads below = vehicle.PreloadsAt(moved);
    for (std::size_t i = 0; i < loads.size(); ++i)
      jacobian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(p)) =
          (above.tyre[loads[i].tyre] - below.tyre[loads[i].tyre]) / (2 * step * loads[i].sd_N);
  }
  return jacobian;
}

/// What one standard deviation of each calibration would change.
Eigen::MatrixXd LoadCalibrations(const CondensedVehicle& vehicle, const std::vector<MeasuredLoad>& loads,
                                 const std::vector<Calibration>& calibrations, const std::vector<double>& values) {
  const Preloads preloads = vehicle.PreloadsAt(values);
  Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(std::ssize(loads), std::ssize(calibrations));
  for (std::size_t c = 0; c < calibrations.size(); ++c) {
    if (!calibrations[c].IsOfStaticLoads()) continue;
    const bool is_gain = calibrations[c].kind == Calibration::Kind::kGain;
    for (std::size_t i = 0; i < loads.size(); ++i)
      changes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)) =
          calibrations[c].sd * (is_gain ? preloads.tyre[loads[i].tyre] : 1) / loads[i].sd_N;
  }
  return changes;
}

}  // namespace

std::vector<MeasuredLoad> LoadStaticLoads(const StaticLoadPlan& plan, const Vehicle& vehicle,
                                          Diagnostics& diagnostics) {
  const std::optional<std::vector<StaticMeasurement>> table = ReadStaticLoads(plan.table, diagnostics);
  const std::vector<std::string> tyres = NamesOf(vehicle.tyres);
  std::vector<MeasuredLoad> loads;
  for (const auto& [name, source] : plan.tyres) {
    const std::optional<std::size_t> tyre = IndexOf(name, tyres);
    if (!tyre)
      diagnostics.Report(kStaticLoadTyreUnknown, {plan.file, source.line}, {name, DidYouMeanOrAll(name, tyres)});
    if (!table) continue;
    MeasuredLoad load = SumLoads(plan, source, *table, diagnostics);
    load.tyre = tyre.value_or(0);
    loads.push_back(load);
  }
  return loads;
}

ResidualBlock StaticLoadResiduals(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredLoad> loads,
                                  const std::vector<Calibration>& calibrations) {
  const auto count = static_cast<Eigen::Index>(loads.size());
  ResidualBlock block = {
      .name = "static loads",
      .count = count,
      .evaluate =
          [vehicle, loads](const std::vector<double>& values, const Deadline&) {
            const Preloads preloads = vehicle->PreloadsAt(values);
            Evaluation evaluation;
            evaluation.residuals.resize(static_cast<Eigen::Index>(loads.size()));
            double* out = evaluation.residuals.data();
            for (const MeasuredLoad& load : loads) *out++ = (preloads.tyre[load.tyre] - load.load_N) / load.sd_N;
            return evaluation;
          },
      .differentiate =
          [vehicle, loads](const std::vector<double>& values, const std::vector<std::size_t>& parameters) {
            return LoadSlopes(*vehicle, loads, values, parameters);
          },
      .is_cheap = true};
  if (!calibrations.empty())
    block.by_calibrations = [vehicle, loads, calibrations](const std::vector<double>& values) {
      return LoadCalibrations(*vehicle, loads, calibrations, values);
    };
  return block;
}

}  // namespace fourpost
