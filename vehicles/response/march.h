#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "analysis/process/deadline.h"
#include "analysis/signals/frequency_response.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/response/excitation.h"
#include "vehicles/simulation/time_system.h"

namespace fourpost {

struct MarchOptions {
  /// Relative accuracy of the Runge-Kutta-Merson integrator of a Multibody; other systems have their own. Simbody
  /// weights states by about 1 (m, rad) while the rig moves them by millimetres, hence the small number.
  double accuracy = 1e-8;
  /// Steady if, from one window to the next, no sensor's first harmonic changes by more than this share of itself, nor
  /// its mean by more than this share of itself or of the first harmonic, whichever is larger. For a sensor below a
  /// tenth of the loudest of its unit, that tenth is the reference: a channel that symmetry keeps silent shows only
  /// integrator noise, about 20 `accuracy` of the loudest, which never repeats. If all sensors of a unit read less than
  /// a thousandth of the imposed post motion, that motion replaces the loudest: for displacements and struts the posts'
  /// amplitude a, for accelerations a w^2, for angular velocities a w over half the largest distance of two posts (over
  /// 1 m for a lone post), for tyre forces a times the stiffest tyre.
  double tolerance = 1e-5;
  /// Shortest window of whole cycles [s]: long compared with the decay of body modes within one cycle at high
  /// frequency.
  double window_s = 0.5;
  /// Time limit [s].
  double longest_s = 60;
  /// The kinks of bilinear forces alias into accelerations: 64 samples left 1.5 % at a sensor near a node, 256 leave
  /// 0.04 %.
  int samples_per_cycle = 256;
  /// Checked at each sample; throws TimedOut.
  Deadline deadline;
  /// Called regularly; true ends the integration by MarchStopped.
  std::function<bool()> stop = {};

  /// Throws std::invalid_argument naming the field, its value and its bound.
  void Validate() const;
};

/// Thrown when MarchOptions::stop requests it.
struct MarchStopped {};

/// A frequency at which the motion was not periodic within the time allowed.
struct UnsteadyMotion {
  double frequency_Hz = 0;
  double amplitude_m = 0;
  /// The sensor that changed most from the last window but one to the last; empty for a vehicle without sensors.
  std::string sensor;
  /// The value that changed: its mean, or its first harmonic.
  bool is_mean = false;
  /// Relative change, with the reference of MarchOptions::tolerance.
  double change = 0;
  /// Cycles in a window.
  int cycles = 0;
};

struct MarchedResponse {
  FrequencyResponse response;
  std::vector<UnsteadyMotion> unsteady;
  /// Simulated time over all frequencies [s].
  double simulated_s = 0;
};

/// Steady response to a stepped sine, found as on the rig: time integration to steady state, then Fourier coefficients
/// over whole cycles. For the full nonlinear multibody system the reference of SolveHarmonicBalance. Throws
/// std::invalid_argument for options or an excitation that do not fit, std::runtime_error if the integration fails.
/// `progress` is called with the number of frequencies done.
MarchedResponse March(TimeSystem& system, const Excitation& excitation, const MarchOptions& options = {},
                      const std::function<void(std::size_t done)>& progress = {});
MarchedResponse March(Multibody& multibody, const Excitation& excitation, const MarchOptions& options = {},
                      const std::function<void(std::size_t done)>& progress = {});

/// Message on a motion that did not settle, its change, and the mode that decays slowly: "roll at 2.4 Hz, 5 mm: no
/// periodic motion within 60 s; ...". For the integrated vehicle and excitation.
std::string UnsteadyMessage(const Vehicle& vehicle, const Excitation& excitation, const UnsteadyMotion& motion,
                            const MarchOptions& options = {});

}  // namespace fourpost
