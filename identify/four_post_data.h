#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnostics.h"
#include "identify/study.h"
#include "vehicles/description/vehicle.h"
#include "vehicles/response/excitation.h"

namespace fourpost {

/// What was measured for one sensor of the vehicle in one recording; one entry per frequency.
struct MeasuredChannel {
  std::size_t sensor = 0;
  std::string name;
  std::string unit;
  std::vector<std::complex<double>> response;
  /// Standard deviations of the repeats along and across the response's phasor, pooled over neighbouring frequencies;
  /// zero where there were no repeats.
  std::vector<double> radial_sd;
  std::vector<double> tangential_sd;
  /// Mean offset [unit]; empty where not measured.
  std::vector<double> mean;
  /// Amplitude of the second harmonic [unit]; empty where not measured.
  std::vector<double> second_harmonic;
  /// Those that it is the mean or sum of move against each other, which a warning tells.
  bool has_opposed_members = false;
};

struct MeasuredRun {
  std::string name;
  Excitation excitation;
  std::vector<MeasuredChannel> channels;
};

/// Load of a tyre at rest [N].
struct MeasuredLoad {
  std::size_t tyre = 0;
  double load_N = 0;
  double sd_N = 0;
};

/// The recordings of a study in the terms of the vehicle.
struct FourPostData {
  std::vector<MeasuredRun> runs;
  std::vector<MeasuredLoad> static_loads;
};

/// Reads the recordings and maps their channels to the vehicle's sensors. Adds every fault to `diagnostics`; nothing
/// when there was an error.
std::optional<FourPostData> LoadFourPostData(const Study& study, const Vehicle& vehicle, Diagnostics& diagnostics);

/// The runs with only the frequencies from lower to upper.
std::vector<MeasuredRun> InBand(const std::vector<MeasuredRun>& runs, double lower_Hz, double upper_Hz);

}  // namespace fourpost
