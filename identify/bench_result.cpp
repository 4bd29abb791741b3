#include "identify/bench_result.h"

#include <cmath>
#include <span>
#include <stdexcept>

#include "analysis/csv_writer.h"
#include "analysis/fit_quality.h"
#include "analysis/short_number.h"

namespace fourpost {
namespace {

/// More than any sensor tells.
constexpr int kSignalDigits = 7;

std::span<const double> Compared(const BenchRecording& recording, const std::vector<double>& signal) {
  return std::span(signal).subspan(recording.first, recording.end - recording.first);
}

}  // namespace

std::vector<ModelledRecording> ModelledRecordings(const BenchDamper& damper,
                                                  const std::vector<BenchRecording>& recordings,
                                                  const std::vector<double>& values) {
  std::vector<ModelledRecording> modelled;
  for (const BenchRecording& recording : recordings) {
    modelled.push_back({recording, ModelledForce(damper, recording, values)});
    if (modelled.back().force.empty())
      throw std::runtime_error("the fitted damper cannot move as recorded in '" + recording.name +
                               "': one of its chambers closes; give it more room");
  }
  return modelled;
}

std::vector<HistoryMisfit> BenchMisfits(const std::vector<ModelledRecording>& recordings) {
  std::vector<HistoryMisfit> misfits;
  for (const auto& [recording, force] : recordings) {
    const std::span<const double> measured = Compared(recording, recording.force);
    const std::span<const double> modelled = Compared(recording, force);
    misfits.push_back({.recording = recording.name,
                       .name = "force",
                       .nmse_percent = NormalisedMse_percent(measured, modelled),
                       .vaf_percent = VarianceAccountedFor_percent(measured, modelled)});
  }
  return misfits;
}

std::string BenchCsv(const std::vector<ModelledRecording>& recordings) {
  CsvWriter csv({"recording", "time_s", "displacement_m", "speed_mps", "measured_N", "modelled_N"});
  for (const auto& [recording, force] : recordings) {
    for (std::size_t k = recording.first; k < recording.end; ++k) {
      const std::size_t at = k * recording.motion.steps;
      csv.Add(recording.name);
      for (const double value : {recording.time_s(k), recording.motion.extension[at], recording.motion.rate[at],
                                 recording.force[k], force[k]})
        csv.Add(AtDigits(value, kSignalDigits));
    }
  }
  return csv.text();
}

}  // namespace fourpost
