#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "vehicles/condensed/condensed_model.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/engine/engine.h"
#include "vehicles/multibody/multibody.h"
#include "vehicles/response/excitation.h"
#include "vehicles/response/harmonic_balance.h"
#include "vehicles/response/motion_from_rest.h"

namespace fourpost {

/// A difference of two responses, and where it is.
struct LargestDifference {
  double value = 0;
  double frequency_Hz = 0;
  std::string channel;
};

/// Error of kinematics linearised about the design pose: the largest differences of gain and phase between the
/// linearised and the full harmonic balance. Omitted are values of a channel below 3 % of its largest, because a ratio
/// has no meaning next to a node, and silent channels: below a hundredth of the loudest of their unit, and of one unit
/// per metre, so that a unit may be silent as a whole.
struct KinematicsError {
  LargestDifference gain_dB;
  LargestDifference phase_deg;

  /// The larger of both differences over the visible one.
  double Size() const { return std::max(gain_dB.value / kVisible_dB, phase_deg.value / kVisible_deg); }
  bool IsVisible() const { return Size() > 1; }
};

/// Compares responses to one excitation; frequencies without a finite value are left out.
KinematicsError CompareKinematics(const FrequencyResponse& linearised, const FrequencyResponse& full);

/// A frequency without a result.
struct Unanswered {
  double frequency_Hz = 0;
  std::string why;
};

struct SteadyResponse {
  /// NaN where no periodic motion was found.
  FrequencyResponse response;
  /// The requested engine, or the one that kAuto chose; engine_at states which frequencies were integrated in time.
  Engine engine = Engine::kReduced;
  /// One per frequency. Where harmonic balance does not converge, kTimeIntegration is used, on the reduced model if
  /// `engine` is kReduced. If no engine succeeded, the last one tried.
  std::vector<Engine> engine_at;
  /// Whether all frequencies are integrated in time because of the model's hysteresis, see HasHysteresis.
  bool is_hysteretic = false;
  std::vector<Unanswered> unanswered;
  /// Where the linearised harmonic balance found another motion than that from rest; not checked by kFull and
  /// kTimeIntegration.
  std::vector<OtherMotion> other_motions;
  /// For kAuto, over the frequencies at which both harmonic balances converged, if there are any.
  std::optional<KinematicsError> kinematics_error;
  /// Result of the linearised harmonic balance; for kAuto if the full one was used.
  std::optional<FrequencyResponse> linearised;
  /// For kAuto, why there is no kinematics_error; else empty.
  std::string not_estimated;
};

/// A vehicle, at its file's values, whose responses to stepped sines any engine can solve.
class SteadySolver {
 public:
  /// The vehicle must outlive this object. Throws FaultyInput if it cannot be assembled or held in its design pose.
  explicit SteadySolver(const Vehicle& vehicle);

  const CondensedModel& model() const { return model_; }

  /// Number of frequencies done, by "full balance", "from rest" or "time integration".
  struct Stage {
    const char* work = "";
    std::size_t done = 0;
    std::size_t total = 0;
  };
  /// Called with the current stage; false ends the work. The remaining frequencies are then reported as unanswered.
  using Progress = std::function<bool(const Stage& stage)>;

  /// Frequencies in the order of the sweep, see SolveHarmonicBalance. Time integration starts each of them from rest.
  /// `options`: of the linearised harmonic balance. Throws std::invalid_argument for an excitation that does not fit.
  SteadyResponse Solve(const Excitation& excitation, Engine engine, const HarmonicBalanceOptions& options = {},
                       const Progress& progress = {});

  /// kAuto without the search for other motions and without time integration: the error of linear kinematics. Throws as
  /// Solve() does.
  SteadyResponse Check(const Excitation& excitation, const HarmonicBalanceOptions& options = {},
                       const Progress& progress = {});

 private:
  /// Results, and the indices of the frequencies that have none.
  struct Answer {
    FrequencyResponse response;
    std::vector<bool> converged;
  };
  Answer Linearised(const Excitation& excitation, const HarmonicBalanceOptions& options);
  Answer Full(const Excitation& excitation, const Progress& progress);
  SteadyResponse Chosen(const Excitation& excitation, Engine engine, const HarmonicBalanceOptions& options,
                        const Progress& progress);
  SteadyResponse Balanced(const Excitation& excitation, Engine engine, const HarmonicBalanceOptions& options,
                          const Progress& progress);
  /// Over the frequencies at which both converged.
  static KinematicsError Compare(Answer linearised, const Answer& full);
  void FindOtherMotions(const Excitation& excitation, const HarmonicBalanceOptions& options, const Progress& progress,
                        SteadyResponse& response);
  void MarchMissing(const Excitation& excitation, const Progress& progress, SteadyResponse& response);
  std::string MarchOne(const Excitation& excitation, std::size_t index, const std::function<bool()>& stop,
                       SteadyResponse& response);
  Multibody& FullSystem();

  const Vehicle& vehicle_;
  CondensedModel model_;
  /// Made when needed.
  std::optional<Multibody> multibody_;
};

}  // namespace fourpost
