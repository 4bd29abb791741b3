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

/// A difference of two answers, and where it is.
struct LargestDifference {
  double value = 0;
  double frequency_Hz = 0;
  std::string channel;
};

/// By how much kinematics linearised about the design pose are off: the largest differences of gain and phase between
/// the linearised and the full balance. Values of a channel below 3 % of its largest are left out, as next to a node a
/// ratio says nothing, and channels that are silent: below a hundredth of the loudest of their unit, and of one unit
/// per metre, so that a unit may be silent as a whole.
struct KinematicsError {
  LargestDifference gain_dB;
  LargestDifference phase_deg;

  /// The larger of both differences over what is visible.
  double Size() const { return std::max(gain_dB.value / kVisible_dB, phase_deg.value / kVisible_deg); }
  bool IsVisible() const { return Size() > 1; }
};

/// Compares answers to one excitation, frequencies without a finite value left out.
KinematicsError CompareKinematics(const FrequencyResponse& linearised, const FrequencyResponse& full);

/// A frequency without an answer.
struct Unanswered {
  double frequency_Hz = 0;
  std::string why;
};

struct SteadyResponse {
  /// NaN where no periodic motion was found.
  FrequencyResponse response;
  /// The one asked for, or of kAuto the one it chose; what it left to the march is told by engine_at.
  Engine engine = Engine::kReduced;
  /// One per frequency: a balance that does not converge leaves it to kMarch, of the reduced model where `engine` is
  /// kReduced. The one that tried last where none did.
  std::vector<Engine> engine_at;
  /// Whether all frequencies are left to the march for the model's hysteresis, see HasHysteresis.
  bool is_hysteretic = false;
  std::vector<Unanswered> unanswered;
  /// Where the linearised balance found another motion than that from rest; not looked for by kFull and kMarch.
  std::vector<OtherMotion> other_motions;
  /// Of kAuto, over the frequencies at which both balances converged, if there are any.
  std::optional<KinematicsError> kinematics_error;
  /// What the linearised balance found; of kAuto when the full one answered.
  std::optional<FrequencyResponse> linearised;
  /// Of kAuto, why there is no kinematics_error; else empty.
  std::string not_estimated;
};

/// A vehicle, at its file's values, that answers stepped sines by any engine.
class SteadySolver {
 public:
  /// The vehicle must outlive this object. Throws FaultyInput when it cannot be assembled or held in its design pose.
  explicit SteadySolver(const Vehicle& vehicle);

  const CondensedModel& model() const { return model_; }

  /// So many of the frequencies, by "full balance", "from rest" or "march".
  struct Stage {
    const char* work = "";
    std::size_t done = 0;
    std::size_t total = 0;
  };
  /// Hears what is being done, and says whether to go on. Where it does not, the frequencies that are left are told
  /// unanswered.
  using Progress = std::function<bool(const Stage& stage)>;

  /// Frequencies in the order of the sweep, see SolveHarmonicBalance. A march starts each of them from rest.
  /// `options`: of the linearised balance.
  /// Throws std::invalid_argument for an excitation that does not fit.
  SteadyResponse Solve(const Excitation& excitation, Engine engine, const HarmonicBalanceOptions& options = {},
                       const Progress& progress = {});

  /// Of kAuto, without a look for other motions and without a march: what linear kinematics are off by. Throws as
  /// Solve() does.
  SteadyResponse Check(const Excitation& excitation, const HarmonicBalanceOptions& options = {},
                       const Progress& progress = {});

 private:
  /// Answers and the frequencies that have none, by number.
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
