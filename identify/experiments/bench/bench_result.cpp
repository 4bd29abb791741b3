#include "identify/experiments/bench/bench_result.h"

#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "analysis/files/csv_writer.h"
#include "analysis/signals/deviation.h"
#include "analysis/signals/fit_quality.h"
#include "analysis/text/short_number.h"
#include "identify/experiments/bench/bench_residuals.h"
#include "identify/experiments/bench/findings.h"
#include "vehicles/multibody/simulation_error.h"

namespace fourpost {
namespace {

/// More than any sensor resolves.
constexpr int kSignalDigits = 7;

std::span<const double> Compared(const BenchRecording& recording, const std::vector<double>& signal) {
  return std::span(signal).subspan(recording.first, recording.end - recording.first);
}

/// Measured less modelled, of the samples that are fitted.
Eigen::VectorXd Residual(const BenchRecording& recording, std::span<const double> measured,
                         std::span<const double> modelled) {
  const std::size_t stride = ResidualStride(recording);
  std::vector<double> differences;
  for (std::size_t k = 0; k < measured.size(); k += stride) differences.push_back(measured[k] - modelled[k]);
  return Eigen::Map<const Eigen::VectorXd>(differences.data(), static_cast<Eigen::Index>(differences.size()));
}

}  // namespace

ModelledRecording Modelled(const BenchDamper& damper, const BenchRecording& recording,
                           const std::vector<double>& values) {
  std::vector<double> force = ModelledForce(damper, recording, values);
  if (force.empty()) throw SimulationError(kBenchChamberCloses, {recording.name});
  // What was not measured weighs nothing.
  BenchRecording compared = recording;
  for (std::size_t k = 0; k < force.size(); ++k)
    if (recording.IsUnknown(k)) compared.force[k] = force[k];
  return {std::move(compared), std::move(force)};
}

std::vector<ModelledRecording> ModelledRecordings(const BenchDamper& damper,
                                                  const std::vector<BenchRecording>& recordings,
                                                  const std::vector<double>& values) {
  std::vector<ModelledRecording> modelled;
  for (const BenchRecording& recording : recordings) modelled.push_back(Modelled(damper, recording, values));
  return modelled;
}

double IntegrationError(const BenchDamper& damper, const ModelledRecording& modelled,
                        const std::vector<double>& values) {
  const BenchRecording& recording = modelled.recording;
  std::vector<double> finer = damper.FinerTensions(recording.motion, recording.setting.At(values));
  if (finer.empty()) throw SimulationError(kBenchChamberCloses, {recording.name});
  if (recording.filter) recording.filter->Apply(finer);
  // Per cent of the finer one's variance.
  return std::sqrt(NormalisedMse_percent(Compared(recording, finer), Compared(recording, modelled.force)) / 100);
}

std::vector<HistoryMisfit> BenchMisfits(const std::vector<ModelledRecording>& recordings) {
  std::vector<HistoryMisfit> misfits;
  for (const auto& [recording, force] : recordings) {
    const std::span<const double> measured = Compared(recording, recording.force);
    const std::span<const double> modelled = Compared(recording, force);
    misfits.push_back({.recording = recording.name,
                       .name = "force",
                       .nmse_percent = NormalisedMse_percent(measured, modelled),
                       .vaf_percent = VarianceAccountedFor_percent(measured, modelled),
                       .measured_squares = std::pow(DeviationOf(measured), 2) * static_cast<double>(measured.size())});
    JudgeNoise(Residual(recording, measured, modelled), misfits.back());
  }
  return misfits;
}

std::vector<YardstickRecord> YardstickRecords(const std::vector<ModelledRecording>& recordings) {
  std::vector<YardstickRecord> records;
  for (const auto& [recording, force] : recordings) {
    const auto count = static_cast<Eigen::Index>(recording.end - recording.first);
    YardstickRecord record{.name = recording.name,
                           .rate_Hz = 1 / recording.sample_s,
                           .setting = recording.setting,
                           .has_means = true};
    record.inputs.resize(count, 1);
    for (Eigen::Index k = 0; k < count; ++k)
      record.inputs(k, 0) =
          recording.motion.extension[(recording.first + static_cast<std::size_t>(k)) * recording.motion.steps];
    record.channels.push_back(
        {"force", Eigen::Map<const Eigen::VectorXd>(recording.force.data() + recording.first, count)});
    records.push_back(std::move(record));
  }
  return records;
}

std::string BenchCsv(const std::vector<ModelledRecording>& recordings, const HalfWidths* about) {
  std::vector<std::string> head = {"recording", "time_s", "displacement_m", "speed_mps", "measured_N", "modelled_N"};
  if (about) head.insert(head.end(), {"half_95_parameters_N", "half_95_measured_N"});
  CsvWriter csv(head);
  for (const auto& [recording, force] : recordings) {
    for (std::size_t k = recording.first; k < recording.end; ++k) {
      const std::size_t at = k * recording.motion.steps;
      csv.Add(recording.name);
      std::vector<double> row = {recording.time_s(k), recording.motion.extension[at], recording.motion.rate[at],
                                 recording.force[k], force[k]};
      const auto place = static_cast<Eigen::Index>(k - recording.first);
      if (about) row.insert(row.end(), {about->parameters[place], about->measured[place]});
      for (const double value : row) csv.Add(AtDigits(value, kSignalDigits));
    }
  }
  return csv.text();
}

}  // namespace fourpost
