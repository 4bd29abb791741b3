#include "vehicles/bench/recording_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "analysis/signals/clipping.h"
#include "analysis/signals/dead_signal.h"
#include "analysis/signals/deviation.h"
#include "analysis/signals/jumps.h"
#include "analysis/signals/signal_levels.h"
#include "analysis/signals/slow_drift.h"
#include "analysis/signals/spikes.h"
#include "analysis/signals/turning_points.h"
#include "analysis/text/short_number.h"
#include "vehicles/bench/findings.h"
#include "vehicles/bench/force_motion.h"

namespace fourpost {
namespace {

using Signal = std::vector<double>;

constexpr double kShortestStroke_m = 2e-5;
/// Of the force's variance: of any damper more than half goes with the motion.
constexpr double kLittleOfMotion = 0.2;
/// Beyond 0 and 90 degrees: more than the two-point slopes and noise make.
constexpr double kPhaseSlack_deg = 5;
/// Of the signal's rms: rounding to levels that is worth a word.
constexpr double kCoarse = 0.05;
/// Of the signal's span.
constexpr double kDrift = 0.05;
/// Of the force in a cycle: a damper's at half the speed is at least an eighth (cubic law), a dead channel's is noise.
constexpr double kDead = 0.03;
/// In a cycle, of the fastest: a spline, which the model follows, has the speed of a sine to 1 % from six samples on,
/// to 2 % from five and to 5 % from four, 3 sin a / (a (2 + cos a)), a = 2 pi / samples.
constexpr double kFewestInCycle = 6;
/// Of two a cycle and less the speed has any sign, of swept sines at 25 to 500 Hz all was judged right from three on.
constexpr double kFewestToJudge = 3;
/// Crests of sines of twelve samples and fewer a cycle were taken for samples that stand out, of fourteen to twenty
/// none.
constexpr double kFewestForCrests = 14;
/// The same of a cubic law's force, 1 - cos^3. Forces at turning points, too, were reported to drift at ten.
constexpr double kFewestForForce = 17;

/// Of 5000 random dampers that resist rebound as hard or harder, with gas, friction, mounts, offsets and noise, one is
/// taken for the other way round by these; with both signs changed, 87 % of those whose sides differ by a factor
/// of 1.5.
constexpr double kHarderInCompression = 1.2;
constexpr double kClearlyOtherSides = 0.2;

/// From a turning point to the next but one.
struct Cycle {
  std::size_t first = 0;
  std::size_t samples = 0;
  double force_N = 0;
  double speed_mps = 0;
};

double SpanOf(const Signal& signal) {
  const auto [least, most] = std::minmax_element(signal.begin(), signal.end());
  return *most - *least;
}

/// Central differences; 0 at the ends.
Signal Rates(const Signal& x, double step) {
  Signal rates(x.size());
  for (std::size_t k = 1; k + 1 < x.size(); ++k) rates[k] = (x[k + 1] - x[k - 1]) / (2 * step);
  return rates;
}

/// Mean power that the damper takes [W].
double PowerOf(const Signal& force, const Signal& rate) {
  const double mean = Mean(force);
  double sum = 0;
  for (std::size_t k = 0; k < force.size(); ++k) sum += (force[k] - mean) * rate[k];
  return sum / static_cast<double>(force.size());
}

/// Phase of force against motion in the fastest part, else in all.
double PhaseOfForce_deg(const Signal& x, const Signal& force, double step_s) {
  const std::optional<MotionPhase> fastest = PhaseOfFastest(x, force, step_s);
  return fastest ? fastest->phase_deg : PhaseOf(x, force, step_s).phase_deg;
}

/// A delay turns the phase bit by bit, the wrong sign by half a turn.
bool IsReversed(double power_W, double phase_deg) { return power_W < 0 && phase_deg < -45; }

class Checker {
 public:
  Checker(const TimeRecording& recording, double longest_stroke_m, const std::string& file, Diagnostics& diagnostics)
      : longest_stroke_m_(longest_stroke_m),
        x_(recording.channels[0]),
        force_(recording.channels[1]),
        rate_(Rates(x_, recording.step_s)),
        recording_(recording),
        file_(file),
        diagnostics_(diagnostics) {}

  bool Check() {
    if (SpanOf(force_) == 0) {
      Fault(kForceDead, {ShortNumber(force_.front()) + " N"});
      return good_;
    }
    if (IsDead(force_)) {
      Fault(kForceDead, {ShortNumber(Mean(force_)) + " N but for noise of its converter"});
      return good_;
    }
    CheckClipping(x_, "displacement", "m");
    CheckClipping(force_, "force", "N");
    turns_ = TurningPoints(x_);
    if (turns_.size() < 2) {
      Fault(kCycleIncomplete,
            {turns_.empty() ? "nowhere" : "only once", ShortNumber(recording_.end_s - recording_.start_s) + " s"});
      return good_;
    }
    CheckSampling();
    CheckJumps();
    // What is swapped or of a wrong unit shows at any rate.
    if (samples_in_cycle_ >= kFewestForCrests) ReportSpikes(x_, "displacement", "m");
    if (samples_in_cycle_ >= kFewestForForce) ReportSpikes(force_, "force", "N");
    CheckStroke();
    if (samples_in_cycle_ < kFewestToJudge) return good_;
    if (good_) CheckAlive();
    if (good_) CheckMotion();
    if (good_) CheckWork();
    if (IsSampledWell()) CheckLevels();
    if (good_ && IsSampledWell()) CheckDrift();
    return good_;
  }

 private:
  void Fault(const Finding& kind, const std::vector<std::string>& words) {
    Warn(kind, words);
    good_ = false;
  }

  void Warn(const Finding& kind, const std::vector<std::string>& words) { diagnostics_.Report(kind, {file_}, words); }

  double Power() const { return PowerOf(force_, rate_); }

  void CheckStroke() {
    const double span = SpanOf(x_);
    // What is swapped has the rate of force times displacement for power: that of force times rate, with the other
    // sign.
    if (span > longest_stroke_m_ && Power() < 0)
      return Fault(kChannelsSwapped, {ShortNumber(span) + " m", ShortNumber(SpanOf(force_)) + " N"});
    if (span > longest_stroke_m_)
      return Fault(kStrokeTooLong, {ShortNumber(span) + " m", ShortNumber(longest_stroke_m_) + " m"});
    if (span < kShortestStroke_m) Warn(kStrokeTooShort, {ShortNumber(span) + " m"});
  }

  double TimeAt(std::size_t k) const { return recording_.start_s + recording_.step_s * static_cast<double>(k); }

  std::vector<Cycle> Cycles() const {
    std::vector<Cycle> cycles;
    for (std::size_t i = 0; i + 2 < turns_.size(); ++i) {
      const auto [first, last] =
          std::pair(static_cast<std::ptrdiff_t>(turns_[i]), static_cast<std::ptrdiff_t>(turns_[i + 2]));
      cycles.push_back({turns_[i], turns_[i + 2] - turns_[i], SpanOf({force_.begin() + first, force_.begin() + last}),
                        SpanOf({rate_.begin() + first, rate_.begin() + last})});
    }
    return cycles;
  }

  bool IsSampledWell() const { return samples_in_cycle_ >= kFewestInCycle; }

  /// By the middle one of the fastest quarter of the cycles.
  void CheckSampling() {
    std::vector<std::size_t> samples;
    for (const Cycle& cycle : Cycles()) samples.push_back(cycle.samples);
    if (samples.empty()) return;
    std::sort(samples.begin(), samples.end());
    const auto count = static_cast<double>(samples[samples.size() / 8]);
    samples_in_cycle_ = count;
    if (IsSampledWell()) return;
    Warn(kSampledSlowly, {ShortNumber(1 / (count * recording_.step_s), 2) + " Hz",
                          ShortNumber(1 / recording_.step_s) + " Hz", ShortNumber(count)});
  }

  void CheckJumps() {
    const std::vector<std::size_t> jumps = Jumps(x_);
    if (jumps.empty()) return;
    const std::size_t at = jumps.front();
    Fault(kDisplacementJumps, {ShortNumber(x_[at + 1] - x_[at]) + " m", ShortNumber(TimeAt(at), 5) + " s",
                               jumps.size() > 1 ? " and " + std::to_string(jumps.size() - 1) + " times more" : ""});
  }

  /// Whether the force lasts as long as the motion: cycles are compared with a strong one, the ninth of ten.
  void CheckAlive() {
    const std::vector<Cycle> cycles = Cycles();
    if (cycles.empty()) return;
    std::vector<Cycle> by_force = cycles;
    std::sort(by_force.begin(), by_force.end(), [](const Cycle& a, const Cycle& b) { return a.force_N < b.force_N; });
    const Cycle& strong = by_force[by_force.size() * 9 / 10];
    const auto dead = std::find_if(cycles.begin(), cycles.end(), [&](const Cycle& cycle) {
      return cycle.force_N < kDead * strong.force_N && cycle.speed_mps > 0.5 * strong.speed_mps;
    });
    if (dead == cycles.end()) return;
    Fault(kForceDeadInCycle,
          {ShortNumber(dead->force_N) + " N", ShortNumber(TimeAt(dead->first), 5) + " s",
           ShortNumber(100 * dead->speed_mps / strong.speed_mps, 2) + " %", ShortNumber(strong.force_N) + " N"});
  }

  void CheckMotion() {
    const double share = ShareOfMotion(x_, rate_, force_);
    if (share < kLittleOfMotion) Warn(kForceUnrelated, {ShortNumber(100 * share, 2) + " %"});
  }

  /// Whether force acts against the motion, and at the time when a damper's does.
  void CheckWork() {
    const double power = Power();
    const std::optional<MotionPhase> fastest = PhaseOfFastest(x_, force_, recording_.step_s);
    const double phase_deg = PhaseOfForce_deg(x_, force_, recording_.step_s);
    if (IsReversed(power, phase_deg)) return Fault(kForceSign, {ShortNumber(-power) + " W"});
    if (IsSampledWell() && fastest && (phase_deg > 90 + kPhaseSlack_deg || phase_deg < -kPhaseSlack_deg))
      ReportDelay(*fastest);
    CheckSides();
  }

  /// Gas pushes, a load cell may have an offset, a mount yields: none of these separates the sides of the law.
  void CheckSides() {
    const ForceSides sides = SidesOf(x_, rate_, force_);
    if (!(sides.compression_over_rebound > kHarderInCompression && sides.share > kClearlyOtherSides)) return;
    Warn(kSidesSwapped, {ShortNumber(sides.compression_over_rebound, 2)});
  }

  void ReportDelay(const MotionPhase& fastest) {
    is_delayed_ = true;
    Warn(fastest.phase_deg > 90 ? kForceAhead : kForceLate,
         {ShortNumber(1e3 * std::abs(fastest.Lead_s()), 2) + " ms", ShortNumber(fastest.frequency_Hz, 2) + " Hz",
          ShortNumber(fastest.phase_deg, 2) + " degrees"});
  }

  void ReportSpikes(const Signal& signal, const std::string& name, const std::string& unit) {
    const std::vector<std::size_t> spikes = Spikes(signal);
    if (spikes.empty()) return;
    const std::string time = ShortNumber(TimeAt(spikes.front()), 5) + " s";
    const std::string value = ShortNumber(signal[spikes.front()]) + " " + unit;
    if (spikes.size() == 1) Warn(kSpike, {name, time, value});
    else Warn(kSpikes, {name, std::to_string(spikes.size()), time, value});
  }

  void CheckClipping(const Signal& signal, const std::string& name, const std::string& unit) {
    const std::optional<ClippedEnds> ends = ClippingAtEnds(signal);
    if (!ends) return;
    const std::vector<std::string> words = {name, ends->Samples(unit, TimeAt(ends->first()))};
    if (ends->is_exact()) Fault(kClipped, words);
    else Warn(kLooksClipped, words);
  }

  void CheckLevels() {
    // A level's rounding has the standard deviation level/sqrt(12); central differences take two of it over two steps.
    const double rounding = LevelOf(x_) / std::sqrt(12.0);
    const double rate_rounding = rounding / (std::sqrt(2.0) * recording_.step_s);
    if (rate_rounding > kCoarse * DeviationOf(rate_))
      Warn(kDisplacementCoarse,
           {ShortNumber(LevelOf(x_)) + " m", ShortNumber(100 * rate_rounding / DeviationOf(rate_)) + " %"});
    if (LevelOf(force_) / std::sqrt(12.0) > kCoarse * DeviationOf(force_))
      Warn(kForceCoarse, {ShortNumber(LevelOf(force_)) + " N", ShortNumber(SpanOf(force_)) + " N"});
  }

  /// Steadily beside the motion, while the displacement does not.
  bool DoesForceDrift() {
    const std::optional<double> drift = SlowDrift(force_);
    if (!drift || SlowDrift(x_)) return false;
    Warn(kSignalDrifts, {"force", ShortNumber(*drift, 2) + " N", ShortNumber(SpanOf(force_)) + " N"});
    return true;
  }

  /// Of what stands at the turning points of the displacement, where the speed is zero.
  void CheckDrift() {
    constexpr std::size_t kFewest = 12;
    if (turns_.size() < kFewest || DoesForceDrift()) return;
    Signal places;
    Signal middles;
    Signal resting;
    for (std::size_t i = 2; i + 1 < turns_.size(); ++i) {
      if (!IsOneOfAlike(i)) continue;
      places.push_back(0.5 * static_cast<double>(turns_[i] + turns_[i - 1]));
      middles.push_back(0.5 * (x_[turns_[i]] + x_[turns_[i - 1]]));
      resting.push_back(0.5 * (force_[turns_[i]] + force_[turns_[i - 1]]));
    }
    if (places.size() + 3 < kFewest) return;
    ReportDrift(places, middles, SpanOf(x_), "displacement", "m");
    // Of a force that is late it is that of some speed.
    if (!is_delayed_ && samples_in_cycle_ >= kFewestForForce)
      ReportDrift(places, resting, SpanOf(force_), "force at the turning points", "N");
  }

  /// Whether the swing to this turning point is as long as those beside it. The middle of one that grows out of a rest
  /// is not the middle of the motion.
  bool IsOneOfAlike(std::size_t i) const {
    constexpr double kChange = 0.2;
    const auto swing = [&](std::size_t k) { return std::abs(x_[turns_[k]] - x_[turns_[k - 1]]); };
    return std::abs(swing(i - 1) / swing(i) - 1) < kChange && std::abs(swing(i + 1) / swing(i) - 1) < kChange;
  }

  /// By a straight line through the values over their places in the recording: turning points crowd where it is fast.
  void ReportDrift(const Signal& places, const Signal& values, double span, const std::string& name,
                   const std::string& unit) {
    const Eigen::Map<const Eigen::ArrayXd> at(places.data(), static_cast<Eigen::Index>(places.size()));
    const Eigen::Map<const Eigen::ArrayXd> value(values.data(), static_cast<Eigen::Index>(values.size()));
    const Eigen::ArrayXd off = at - at.mean();
    const double drift = (off * (value - value.mean())).sum() / off.square().sum() * static_cast<double>(x_.size());
    if (std::abs(drift) < kDrift * span) return;
    Warn(kSignalDrifts, {name, ShortNumber(drift) + " " + unit, ShortNumber(span) + " " + unit});
  }

  double longest_stroke_m_;
  const Signal& x_;
  const Signal& force_;
  Signal rate_;
  const TimeRecording& recording_;
  const std::string& file_;
  Diagnostics& diagnostics_;
  std::vector<std::size_t> turns_;
  double samples_in_cycle_ = std::numeric_limits<double>::infinity();
  bool is_delayed_ = false;
  bool good_ = true;
};

}  // namespace

bool IsForceReversed(const TimeRecording& recording) {
  const Signal& x = recording.channels[0];
  const Signal& force = recording.channels[1];
  if (TurningPoints(x).size() < 2 || SpanOf(force) == 0) return false;
  return IsReversed(PowerOf(force, Rates(x, recording.step_s)), PhaseOfForce_deg(x, force, recording.step_s));
}

bool CheckBenchRecording(const TimeRecording& recording, double longest_stroke_m, const std::string& file,
                         Diagnostics& diagnostics) {
  return Checker(recording, longest_stroke_m, file, diagnostics).Check();
}

}  // namespace fourpost
