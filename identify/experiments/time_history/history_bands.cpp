#include "identify/experiments/time_history/history_bands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "analysis/signals/median.h"
#include "identify/experiments/freed_parameters.h"
#include "identify/study_file/result_reader.h"
#include "identify/uncertainty/output_spread.h"

namespace fourpost {
namespace {

using Eigen::Index;
using Json = nlohmann::ordered_json;

constexpr double kReach95 = 1.959963984540054;
/// As many samples show a band.
constexpr Index kMostSamples = 4000;

double RmsOf(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(std::max<Index>(values.size(), 1)));
}

double MeanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double ShareOf(const std::vector<HistoryDiscrepancy>& all, const std::string& channel) {
  std::vector<double> shares;
  for (const HistoryDiscrepancy& one : all) {
    if (one.channel == channel) return one.share;
    shares.push_back(one.share);
  }
  return Median(std::move(shares));
}

Eigen::MatrixXd EveryNth(const Eigen::MatrixXd& samples, Index stride) {
  return samples(Eigen::seqN(0, (samples.rows() - 1) / stride + 1, stride), Eigen::all);
}

}  // namespace

std::vector<HistoryDiscrepancy> HistoryDiscrepancies(const std::vector<MeasuredHistory>& histories,
                                                     const std::vector<Eigen::MatrixXd>& modelled) {
  constexpr double kShare = 0.95;
  std::map<std::string, std::vector<double>> errors;
  for (std::size_t h = 0; h < histories.size(); ++h)
    for (std::size_t s = 0; s < histories[h].signals.size(); ++s) {
      const Eigen::VectorXd model = modelled[h].col(static_cast<Index>(s));
      const double rms = RmsOf(model);
      if (!(rms > 0)) continue;
      for (const double error : Eigen::VectorXd(histories[h].signals[s].MeasuredOr(model) - model))
        errors[histories[h].signals[s].name].push_back(std::abs(error) / rms);
    }
  std::vector<HistoryDiscrepancy> all;
  for (auto& [channel, sizes] : errors) {
    const auto place = sizes.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), place, sizes.end());
    all.push_back({channel, *place});
  }
  return all;
}

Json DiscrepancyJson(const std::vector<HistoryDiscrepancy>& all) {
  Json list = Json::array();
  for (const HistoryDiscrepancy& one : all) list.push_back({{"channel", one.channel}, {"share", one.share}});
  return list;
}

std::vector<HistoryDiscrepancy> ReadHistoryDiscrepancies(const std::filesystem::path& result) {
  std::vector<HistoryDiscrepancy> all;
  const nlohmann::json run = ReadResultFile(result);
  for (const nlohmann::json& entry : ListAt(run, "history_discrepancy"))
    if (const double share = NumberAt(entry, "share"); share >= 0) all.push_back({TextAt(entry, "channel"), share});
  if (!all.empty()) return all;
  // Errors along and across a phasor add by squares in its signal; octaves count alike.
  std::map<std::string, std::vector<double>> squares;
  for (const nlohmann::json& entry : ListAt(run, "discrepancy"))
    squares[TextAt(entry, "channel")].push_back(std::pow(NumberAt(entry, "radial"), 2) +
                                                std::pow(NumberAt(entry, "tangential"), 2));
  for (const auto& [channel, octaves] : squares)
    if (const double share = std::sqrt(MeanOf(octaves)); share >= 0) all.push_back({channel, share});
  return all;
}

HistoryBands BandsOfHistory(const HistoryResiduals& reduced, const Vehicle& vehicle, const Eigen::MatrixXd& modelled,
                            const ParameterSpread& spread, const std::vector<HistoryDiscrepancy>& discrepancies) {
  const FreedParameters freed(spread, vehicle);
  if (!freed.AreKnown() || discrepancies.empty()) return {};
  HistoryBands bands;
  bands.stride = (modelled.rows() - 1) / kMostSamples + 1;
  const auto signals_at = [&](const Eigen::VectorXd& free) -> Eigen::VectorXd {
    ++bands.evaluations;
    try {
      return EveryNth(reduced.Modelled(freed.AllWith(free)).front(), bands.stride).reshaped();
    } catch (const std::runtime_error&) {
      return {};
    }
  };
  const Eigen::MatrixXd thinned = EveryNth(modelled, bands.stride);
  const Eigen::VectorXd variances = OutputVariances(OutputJacobian(spread, thinned.size(), signals_at), spread.total);
  bands.parameters = kReach95 * variances.cwiseSqrt().reshaped(thinned.rows(), thinned.cols());
  bands.measured = bands.parameters;
  const std::vector<MeasuredSignal>& signals = reduced.histories().front().signals;
  for (Index s = 0; s < thinned.cols(); ++s) {
    const MeasuredSignal& signal = signals[static_cast<std::size_t>(s)];
    const double missed = ShareOf(discrepancies, signal.name) * RmsOf(modelled.col(s));
    bands.measured.col(s) = (bands.parameters.col(s).array().square() + missed * missed).sqrt();
    const Eigen::VectorXd error = EveryNth(signal.MeasuredOr(modelled.col(s)), bands.stride) - thinned.col(s);
    // Samples that were not measured are neither in the band nor outside.
    const auto outside = (error.cwiseAbs().array() > bands.measured.col(s).array()).count();
    bands.counts.push_back({signal.name, error.size() - signal.UnknownCount(bands.stride), outside});
  }
  return bands;
}

}  // namespace fourpost
