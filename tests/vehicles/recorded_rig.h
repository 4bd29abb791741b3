#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/files/frequency_response_file.h"
#include "analysis/signals/decibel.h"
#include "analysis/text/diagnostics.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/response/full_balance.h"
#include "vehicles/response/harmonic_balance.h"
#include "vehicles/response/march.h"

namespace fourpost {

/// The agreement of the engines that is promised, over all channels and frequencies of the recordings.
inline constexpr double kPromised_dB = 0.05;
inline constexpr double kPromised_deg = 0.3;

/// The 64 frequencies of a recording, 0.5 to 30 Hz, at `scale` times the rig's own amplitudes.
inline Excitation RecordedExcitation(const std::string& file, std::vector<double> shape, double scale = 1) {
  Diagnostics diagnostics;
  const auto measured = ReadFrequencyResponse(
      std::filesystem::path(FOURPOST_SOURCE_DIR) / "studies" / "landrover110" / file, diagnostics);
  EXPECT_EQ(diagnostics.Format(), "");
  Excitation excitation{measured->frequency_Hz, measured->amplitude_m, std::move(shape)};
  for (double& amplitude : excitation.amplitude_m) amplitude *= scale;
  return excitation;
}

inline Excitation Only(const Excitation& all, const std::vector<std::size_t>& indices) {
  Excitation some{.shape = all.shape};
  for (const std::size_t i : indices) {
    some.frequency_Hz.push_back(all.frequency_Hz[i]);
    some.amplitude_m.push_back(all.amplitude_m[i]);
  }
  return some;
}

/// Every fourth frequency and the last: what a march can afford.
inline Excitation Sparse(const Excitation& all) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < all.frequency_Hz.size(); i += 4) indices.push_back(i);
  indices.push_back(all.frequency_Hz.size() - 1);
  return Only(all, indices);
}

/// A vehicle at its file's values, as all engines take it.
struct Prepared {
  explicit Prepared(const Vehicle& v) : vehicle(v), multibody(v) {
    const std::vector<double> values = vehicle.ParameterValues();
    model = CondensedVehicle(vehicle).At(values);
    multibody.SetParameters(values, model.preloads);
  }

  PeriodicResponse Linearised(const Excitation& excitation, const HarmonicBalanceOptions& options = {}) const {
    return SolveHarmonicBalance(model, vehicle.sensors, excitation, options);
  }
  PeriodicResponse Full(const Excitation& excitation, const FullBalanceOptions& options = {}) {
    return SolveFullBalance(multibody, model, excitation, options);
  }
  /// As good as a march and a thousand times as cheap: full_balance_test.cpp compares the two.
  FrequencyResponse Reference(const Excitation& excitation) {
    const PeriodicResponse reference = Full(excitation, {.harmonics = 15, .samples = 64});
    EXPECT_TRUE(reference.unconverged_Hz.empty());
    return reference.response;
  }
  FrequencyResponse Marched(const Excitation& excitation, int samples_per_cycle) {
    // Amplitudes of millimetres need no more accuracy of the integrator.
    const MarchedResponse marched =
        March(multibody, excitation, {.accuracy = 1e-7, .tolerance = 1e-4, .samples_per_cycle = samples_per_cycle});
    EXPECT_TRUE(marched.unsteady.empty());
    return marched.response;
  }

  Vehicle vehicle;
  Multibody multibody;
  CondensedModel model;
};

/// Largest deviation of a response from another, over frequencies.
struct Deviation {
  double gain_dB = 0;
  double phase_deg = 0;
};

inline Deviation LargestDeviation(const ChannelResponse& a, const ChannelResponse& b) {
  Deviation largest;
  for (std::size_t i = 0; i < a.response.size(); ++i) {
    const std::complex<double> ratio = a.response[i] / b.response[i];
    largest.gain_dB = std::max(largest.gain_dB, std::abs(DecibelFromGain(std::abs(ratio))));
    largest.phase_deg = std::max(largest.phase_deg, std::abs(DegreesFromRadians(std::arg(ratio))));
  }
  return largest;
}

inline void ExpectAgreement(const FrequencyResponse& a, const FrequencyResponse& b, double gain_dB = kPromised_dB,
                            double phase_deg = kPromised_deg) {
  ASSERT_EQ(a.channels.size(), b.channels.size());
  for (std::size_t c = 0; c < a.channels.size(); ++c) {
    const Deviation deviation = LargestDeviation(a.channels[c], b.channels[c]);
    EXPECT_LT(deviation.gain_dB, gain_dB) << a.channels[c].name;
    EXPECT_LT(deviation.phase_deg, phase_deg) << a.channels[c].name;
  }
}

}  // namespace fourpost
