#include "identify/experiments/bench/bench_cycle.h"

#include <algorithm>
#include <numbers>
#include <span>

#include "analysis/files/csv_writer.h"
#include "analysis/signals/fourier.h"
#include "analysis/signals/turning_points.h"

namespace fourpost {
namespace {

/// Extension at the samples.
std::vector<double> Extension(const BenchRecording& recording) {
  std::vector<double> extension(recording.motion.samples());
  for (std::size_t k = 0; k < extension.size(); ++k)
    extension[k] = recording.motion.extension[k * recording.motion.steps];
  return extension;
}

/// As the rig would have recorded it.
std::vector<double> Recorded(const BenchRecording& recording) {
  std::vector<double> extension = Extension(recording);
  if (recording.filter) recording.filter->Apply(extension);
  return extension;
}

/// Greatest extensions, in samples and parts of one: the crest of the parabola through three.
std::vector<double> Crests(const BenchRecording& recording) {
  const std::vector<double> x = Extension(recording);
  std::vector<double> crests;
  for (const std::size_t k : TurningPoints(x)) {
    if (k < std::max<std::size_t>(recording.first, 1) || k + 1 >= recording.end) continue;
    const double bend = x[k - 1] - 2 * x[k] + x[k + 1];
    if (x[k] >= x[k - 1] && x[k] >= x[k + 1] && bend < 0)
      crests.push_back(static_cast<double>(k) + 0.5 * (x[k - 1] - x[k + 1]) / bend);
  }
  return crests;
}

std::complex<double> FirstHarmonic(const std::vector<double>& signal, const BenchCycle& cycle, double per_cycle) {
  return HarmonicsByLeastSquares(std::span(signal).subspan(cycle.first, cycle.end - cycle.first), per_cycle, 1)[1];
}

}  // namespace

std::vector<BenchCycle> CyclesOf(const BenchRecording& recording) {
  std::vector<BenchCycle> cycles;
  const std::vector<double> crests = Crests(recording);
  for (std::size_t i = 1; i < crests.size(); ++i)
    cycles.push_back({.first = static_cast<std::size_t>(crests[i - 1]),
                      .end = std::min(recording.end, static_cast<std::size_t>(crests[i]) + 2),
                      .frequency_Hz = 1 / ((crests[i] - crests[i - 1]) * recording.sample_s)});
  return cycles;
}

double LinearEquivalent::Damping(const std::complex<double>& stiffness) const {
  return stiffness.imag() / (2 * std::numbers::pi * frequency_Hz);
}

std::vector<LinearEquivalent> LinearEquivalents(const ModelledRecording& modelled) {
  constexpr double kFewest = 8;
  const BenchRecording& recording = modelled.recording;
  const std::vector<double> extension = Recorded(recording);
  std::vector<LinearEquivalent> equivalents;
  for (const BenchCycle& cycle : CyclesOf(recording)) {
    const double per_cycle = 1 / (cycle.frequency_Hz * recording.sample_s);
    if (per_cycle < kFewest) continue;
    const std::complex<double> x = FirstHarmonic(extension, cycle, per_cycle);
    equivalents.push_back({.frequency_Hz = cycle.frequency_Hz,
                           .amplitude_m = std::abs(x),
                           .measured = FirstHarmonic(recording.force, cycle, per_cycle) / x,
                           .modelled = FirstHarmonic(modelled.force, cycle, per_cycle) / x});
  }
  return equivalents;
}

std::string CyclesCsv(const std::vector<ModelledRecording>& recordings) {
  CsvWriter csv({"recording", "frequency_Hz", "amplitude_m", "damping_measured_Nspm", "damping_modelled_Nspm",
                 "stiffness_measured_Npm", "stiffness_modelled_Npm"});
  for (const ModelledRecording& recording : recordings) {
    for (const LinearEquivalent& cycle : LinearEquivalents(recording)) {
      csv.Add(recording.recording.name).Add(cycle.frequency_Hz).Add(cycle.amplitude_m);
      csv.Add(cycle.Damping(cycle.measured)).Add(cycle.Damping(cycle.modelled));
      csv.Add(std::abs(cycle.measured)).Add(std::abs(cycle.modelled));
    }
  }
  return csv.text();
}

}  // namespace fourpost
