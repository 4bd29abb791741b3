#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "analysis/frequency_response.h"
#include "vehicles/excitation.h"
#include "vehicles/multibody.h"

namespace fourpost {

struct MarchOptions {
  /// Relative accuracy of the Runge-Kutta-Merson integrator. Simbody weighs states by about 1 (m, rad) while the rig
  /// moves them by millimetres, hence the small number.
  double accuracy = 1e-8;
  /// Steady when, from one window to the next, the first harmonic of no sensor changes by more than this share of
  /// itself, and no mean by more than this share of itself or of the sensor's first harmonic, whichever is larger.
  double tolerance = 1e-5;
  /// Shortest window of whole cycles [s]: long against the decay of body modes within one cycle at high frequency.
  double window_s = 0.5;
  /// Gives up after this long [s].
  double longest_s = 60;
  /// The kinks of bilinear forces alias into accelerations: 64 samples left 1.5 % at a sensor near a node, 256 leave
  /// 0.04 %.
  int samples_per_cycle = 256;

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

struct MarchedResponse {
  FrequencyResponse response;
  /// Frequencies at which the motion was not periodic within the time allowed.
  std::vector<double> unsteady_Hz;
  /// Simulated time over all frequencies [s].
  double simulated_s = 0;
};

/// Steady response of the full nonlinear multibody system to a stepped sine, found as the rig finds it: run until the
/// motion repeats, then Fourier coefficients over whole cycles. The reference for SolveHarmonicBalance.
/// Throws std::invalid_argument for options or an excitation that do not fit, std::runtime_error when the integration
/// fails.
/// `progress` hears how many frequencies are done.
MarchedResponse March(Multibody& multibody, const Excitation& excitation, const MarchOptions& options = {},
                      const std::function<void(std::size_t done)>& progress = {});

}  // namespace fourpost
