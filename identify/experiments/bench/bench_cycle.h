#pragma once

#include <complex>
#include <string>
#include <vector>

#include "identify/experiments/bench/bench_result.h"

namespace fourpost {

/// One cycle of a bench recording, from a greatest extension to the next.
struct BenchCycle {
  std::size_t first = 0;
  /// One behind its last sample.
  std::size_t end = 0;
  double frequency_Hz = 0;
};

/// Those within the samples that are compared.
std::vector<BenchCycle> CyclesOf(const BenchRecording& recording);

/// The damper in a cycle as a spring beside a dashpot: of the first harmonics of force and extension, F/X = k + i w c.
struct LinearEquivalent {
  double frequency_Hz = 0;
  double amplitude_m = 0;
  /// Dynamic stiffness F/X [N/m].
  std::complex<double> measured;
  std::complex<double> modelled;

  /// c [N s/m].
  double Damping(const std::complex<double>& stiffness) const;
};

/// Of every cycle of 8 samples and more. The extension passes the rig's filter before, as the force did.
std::vector<LinearEquivalent> LinearEquivalents(const ModelledRecording& modelled);

/// A row per cycle: recording, frequency, amplitude, equivalent damping and dynamic stiffness, measured and modelled.
std::string CyclesCsv(const std::vector<ModelledRecording>& recordings);

}  // namespace fourpost
