#include "identify/experiments/bench/bench_bands.h"

#include <algorithm>
#include <cmath>

#include "identify/experiments/freed_parameters.h"
#include "identify/study_file/result_reader.h"
#include "identify/uncertainty/output_spread.h"

namespace fourpost {
namespace {

using Eigen::Index;

Eigen::VectorXd ComparedForce(const BenchRecording& recording, const std::vector<double>& force) {
  return Eigen::Map<const Eigen::VectorXd>(force.data() + recording.first,
                                           static_cast<Index>(recording.end - recording.first));
}

double RmsOf(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(std::max<Index>(values.size(), 1)));
}

}  // namespace

double ForceDiscrepancy(const std::vector<ModelledRecording>& fitted) {
  constexpr double kShare = 0.95;
  std::vector<double> sizes;
  for (const auto& [recording, force] : fitted) {
    const Eigen::VectorXd model = ComparedForce(recording, force);
    const double rms = RmsOf(model);
    if (!(rms > 0)) continue;
    for (const double error : Eigen::VectorXd(ComparedForce(recording, recording.force) - model))
      sizes.push_back(std::abs(error) / rms);
  }
  if (sizes.empty()) return 0;
  const auto place = sizes.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), place, sizes.end());
  return *place;
}

std::optional<double> ReadForceDiscrepancy(const std::filesystem::path& result) {
  for (const nlohmann::json& entry : ListAt(ReadResultFile(result), "history_discrepancy"))
    if (const double share = NumberAt(entry, "share"); TextAt(entry, "channel") == "force" && share >= 0) return share;
  return std::nullopt;
}

std::optional<BenchBands> BandsOfForce(const BenchDamper& damper, const ModelledRecording& modelled,
                                       const Vehicle& vehicle, const ParameterSpread& spread, double discrepancy) {
  constexpr double kReach95 = 1.959963984540054;
  const FreedParameters freed(spread, vehicle);
  if (!freed.AreKnown()) return std::nullopt;
  BenchBands bands;
  const BenchRecording& recording = modelled.recording;
  const auto force_at = [&](const Eigen::VectorXd& free) -> Eigen::VectorXd {
    ++bands.evaluations;
    const std::vector<double> force = ModelledForce(damper, recording, freed.AllWith(free));
    if (force.empty()) return {};
    return ComparedForce(recording, force);
  };
  const Eigen::VectorXd model = ComparedForce(recording, modelled.force);
  const Eigen::MatrixXd jacobian = OutputJacobian(spread, model.size(), force_at);
  bands.about.parameters = kReach95 * OutputVariances(jacobian, spread.total).cwiseSqrt();
  const double missed = discrepancy * RmsOf(model);
  bands.about.measured = (bands.about.parameters.array().square() + missed * missed).sqrt();
  const Eigen::VectorXd error = ComparedForce(recording, recording.force) - model;
  bands.count = {"force", error.size(), (error.cwiseAbs().array() > bands.about.measured.array()).count()};
  return bands;
}

}  // namespace fourpost
