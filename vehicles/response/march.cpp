#include "vehicles/response/march.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string_view>

#include "analysis/signals/fourier.h"
#include "analysis/text/found.h"
#include "analysis/text/number.h"
#include "analysis/text/option_check.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/response/findings.h"
#include "vehicles/response/response_recorder.h"
#include "vehicles/ride/vehicle_summary.h"

namespace fourpost {
namespace {

double LargestShare(const Excitation& excitation) {
  double largest = 0;
  for (const double share : excitation.shape) largest = std::max(largest, std::abs(share));
  return largest;
}

/// Mean, first and second harmonic are recorded.
constexpr int kHarmonics = 2;

/// Raised cosine from 0 to 1, so that the posts start at rest, and its derivatives.
struct Ramp {
  double duration;

  double Angle(double t) const { return std::numbers::pi * t / duration; }
  double Value(double t) const { return t >= duration ? 1 : 0.5 * (1 - std::cos(Angle(t))); }
  double Rate(double t) const { return t >= duration ? 0 : 0.5 * Angle(1) * std::sin(Angle(t)); }
  double Curvature(double t) const { return t >= duration ? 0 : 0.5 * Angle(1) * Angle(1) * std::cos(Angle(t)); }
};

/// Posts that move as Re(amplitude exp(i w t)) once the ramp is over.
PostMotion SteppedSine(const std::vector<double>& shape, double amplitude, double omega, Ramp ramp) {
  return [=](double t, std::span<PostState> posts) {
    const double c = std::cos(omega * t);
    const double s = std::sin(omega * t);
    const double z = amplitude * ramp.Value(t) * c;
    const double v = amplitude * (ramp.Rate(t) * c - omega * ramp.Value(t) * s);
    const double a = amplitude * (ramp.Curvature(t) * c - 2 * omega * ramp.Rate(t) * s) - omega * omega * z;
    for (std::size_t p = 0; p < shape.size(); ++p) posts[p] = {shape[p] * z, shape[p] * v, shape[p] * a};
  };
}

/// First harmonic that posts of amplitude 1 m impose on each sensor, in its unit, as MarchOptions::tolerance says.
class Imposed {
 public:
  explicit Imposed(const RigView& rig) : rig_(rig) {}

  Eigen::ArrayXd At(double omega) const {
    Eigen::ArrayXd imposed(static_cast<Eigen::Index>(rig_.sensors.size()));
    for (std::size_t i = 0; i < rig_.sensors.size(); ++i)
      imposed[static_cast<Eigen::Index>(i)] = PerMetre(rig_.sensors[i].type, omega);
    return imposed;
  }

 private:
  double PerMetre(Sensor::Type type, double omega) const {
    switch (type) {
      case Sensor::Type::kAccelerometer: return omega * omega;
      case Sensor::Type::kDisplacement:
      case Sensor::Type::kStrut: return 1;
      case Sensor::Type::kGyro: return omega / rig_.post_lever_m;
      case Sensor::Type::kLoadCell: return rig_.tyre_stiffness;
    }
    return 0;
  }

  const RigView& rig_;
};

/// Size of the loudest first harmonic among the sensors of each one's unit; `imposed` where all of them are silent.
Eigen::ArrayXd Loudest(const std::vector<Sensor>& sensors, const Eigen::ArrayXd& size, const Eigen::ArrayXd& imposed) {
  constexpr double kSilent = 1e-3;
  Eigen::ArrayXd loudest = size;
  for (Eigen::Index i = 0; i < size.size(); ++i) {
    const std::string unit = UnitOf(sensors[static_cast<std::size_t>(i)].type);
    for (Eigen::Index j = 0; j < size.size(); ++j)
      if (UnitOf(sensors[static_cast<std::size_t>(j)].type) == unit) loudest[i] = std::max(loudest[i], size[j]);
  }
  return (loudest < kSilent * imposed).select(imposed, loudest);
}

/// One frequency: collects windows of samples until their means and first harmonics repeat.
class SteadyState {
 public:
  /// `imposed`: the posts' own motion in each sensor's unit.
  SteadyState(const std::vector<Sensor>& sensors, const Eigen::ArrayXd& imposed, double frequency_Hz,
              int samples_per_cycle, const MarchOptions& options)
      : options_(options),
        sensors_(sensors),
        imposed_(imposed),
        cycles_(std::max(1, static_cast<int>(std::ceil(options.window_s * frequency_Hz)))),
        step_(1 / (frequency_Hz * samples_per_cycle)),
        window_(cycles_ * samples_per_cycle, static_cast<Eigen::Index>(sensors.size())) {}

  double step() const { return step_; }
  double window_duration() const { return step_ * static_cast<double>(window_.rows()); }
  double time() const { return time_; }
  bool steady() const { return steady_; }
  const SensorHarmonics& harmonics() const { return harmonics_; }

  /// What changed most in the last window.
  UnsteadyMotion Worst() const {
    UnsteadyMotion worst{.cycles = cycles_};
    if (change_.size() == 0) return worst;
    Eigen::Index sensor = 0;
    Eigen::Index harmonic = 0;
    worst.change = change_.maxCoeff(&sensor, &harmonic);
    worst.sensor = sensors_[static_cast<std::size_t>(sensor)].name;
    worst.is_mean = harmonic == 0;
    return worst;
  }

  void Add(double t, const Eigen::VectorXd& sensors) {
    time_ = t;
    window_.row(filled_++) = sensors.transpose();
    if (filled_ == window_.rows()) CloseWindow();
  }

  bool Done() const { return steady_ || (filled_ == 0 && windows_ > 2 && time_ >= options_.longest_s); }

  /// The motion of the first window is no longer that of the ramp.
  void TakeForSettled() { windows_ = 1; }

 private:
  void CloseWindow() {
    filled_ = 0;
    SensorHarmonics latest(window_.cols(), kHarmonics + 1);
    for (Eigen::Index i = 0; i < window_.cols(); ++i) {
      const std::span<const double> samples(window_.col(i).data(), static_cast<std::size_t>(window_.rows()));
      latest.row(i) = Harmonics(samples, cycles_, kHarmonics).transpose();
    }
    change_ = Change(latest);
    // The first window holds the ramp.
    steady_ = ++windows_ > 2 && (change_ <= options_.tolerance).all();
    harmonics_ = latest;
  }

  /// Changes of mean (0) and first harmonic (1) of each sensor since the window before, as shares of what
  /// MarchOptions::tolerance compares them with. A mean may be next to nothing.
  Eigen::ArrayXXd Change(const SensorHarmonics& latest) const {
    constexpr double kFaint = 0.1;
    const Eigen::ArrayXd first = latest.col(1).cwiseAbs();
    const Eigen::ArrayXd least = kFaint * Loudest(sensors_, first, imposed_);
    Eigen::ArrayXXd size(latest.rows(), 2);
    size.col(1) = first.max(least);
    size.col(0) = latest.col(0).cwiseAbs().array().max(size.col(1));
    const Eigen::ArrayXXd change = (latest - harmonics_).leftCols<2>().cwiseAbs();
    // No change of nothing: posts that stand still.
    return (change == 0).select(0, change / size);
  }

  const MarchOptions& options_;
  const std::vector<Sensor>& sensors_;
  Eigen::ArrayXd imposed_;
  int cycles_;
  double step_;
  /// Samples x sensors.
  Eigen::MatrixXd window_;
  Eigen::Index filled_ = 0;
  int windows_ = 0;
  double time_ = 0;
  bool steady_ = false;
  SensorHarmonics harmonics_ = SensorHarmonics::Zero(window_.cols(), kHarmonics + 1);
  Eigen::ArrayXXd change_;
};

/// Posts that move at one frequency.
struct Sine {
  const std::vector<Sensor>& sensors;
  const MarchOptions& options;
  double frequency_Hz;
  Eigen::ArrayXd imposed;
  PostMotion posts;
  /// At each reading; throws where the integration is to end.
  std::function<void()> ask;

  SteadyState Begin(int samples_per_cycle) const {
    return {sensors, imposed, frequency_Hz, samples_per_cycle, options};
  }
};

/// `march` takes each frequency to its steady state.
MarchedResponse MarchEach(const RigView& rig, const Excitation& excitation, const MarchOptions& options,
                          const std::function<void(std::size_t done)>& progress,
                          const std::function<SteadyState(const Sine&)>& march) {
  options.Validate();
  excitation.Validate(rig.post_count);
  const Imposed imposed(rig);
  ResponseRecorder recorder(rig.sensors, excitation);
  MarchedResponse out;
  // Some milliseconds of work.
  constexpr int kSamplesPerQuestion = 64;
  int samples = 0;
  const auto ask = [&] {
    options.deadline.Check();
    if (options.stop && ++samples % kSamplesPerQuestion == 0 && options.stop()) throw MarchStopped();
  };
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    const double frequency = excitation.frequency_Hz[i];
    const double amplitude = excitation.amplitude_m[i];
    const double omega = 2 * std::numbers::pi * frequency;
    Sine sine{rig.sensors, options, frequency, LargestShare(excitation) * amplitude * imposed.At(omega), {}, ask};
    const Ramp ramp{sine.Begin(options.samples_per_cycle).window_duration()};
    sine.posts = SteppedSine(excitation.shape, amplitude, omega, ramp);
    const SteadyState run = march(sine);
    if (!run.steady()) {
      out.unsteady.push_back(run.Worst());
      out.unsteady.back().frequency_Hz = frequency;
      out.unsteady.back().amplitude_m = amplitude;
    }
    out.simulated_s += run.time();
    recorder.Record(i, run.harmonics());
    if (progress) progress(i + 1);
  }
  out.response = recorder.Take();
  return out;
}

/// Of so many samples, which each cost as much as a step of the integrator, one is enough while the motion settles.
int SamplesPerSettlingSample(int samples_per_cycle, double frequency_Hz) {
  // Means and first harmonics, by which it settles, take a few; of fewer they would take in harmonics of stops.
  constexpr int kFewest = 16;
  // The integrator's own steps are a few milliseconds.
  constexpr double kStep_s = 0.004;
  int stride = 1;
  while (samples_per_cycle % (2 * stride) == 0 && samples_per_cycle / (2 * stride) >= kFewest &&
         2 * stride <= kStep_s * frequency_Hz * samples_per_cycle)
    stride *= 2;
  return stride;
}

/// Settles with few samples, and with all of them from the settled state on.
SteadyState MarchMultibody(Multibody& multibody, const Sine& sine, const MarchOptions& options) {
  double start = 0;
  Eigen::VectorXd state = multibody.RestState();
  // `skipped` samples are of the cycle before.
  const auto march = [&](SteadyState& run, int skipped) {
    const Eigen::VectorXd from = state;
    multibody.SetPostMotion(sine.posts);
    multibody.Integrate(
        from, start, run.step(), options.accuracy,
        [&](double t, const Eigen::VectorXd& reached, const Eigen::VectorXd& readings) {
          sine.ask();
          if (skipped-- > 0) return;
          run.Add(t, readings);
          if (run.Done()) state = reached;
        },
        [&] { return run.Done(); });
    start = run.time();
    multibody.SetPostMotion(nullptr);
  };
  const int stride = SamplesPerSettlingSample(options.samples_per_cycle, sine.frequency_Hz);
  SteadyState settling = sine.Begin(options.samples_per_cycle / stride);
  march(settling, 0);
  if (stride == 1 || !settling.steady()) return settling;
  SteadyState settled = sine.Begin(options.samples_per_cycle);
  settled.TakeForSettled();
  march(settled, stride);
  return settled;
}

/// "roll", or what each post does: "posts 1, 0.5".
std::string ShapeText(const Vehicle& vehicle, const std::vector<double>& shape) {
  for (const std::string_view pattern : kPostPatterns) {
    try {
      if (PostPattern(vehicle, pattern) == shape) return std::string(pattern);
    } catch (const std::invalid_argument&) {
      // These posts cannot make this one.
    }
  }
  std::string text = "posts";
  for (std::size_t p = 0; p < shape.size(); ++p) text += (p == 0 ? " " : ", ") + FormatNumber(shape[p]);
  return text;
}

/// Three significant digits, for people.
std::string Short(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

/// The mode that decays last; null for a vehicle without one.
const Mode* SlowestMode(const std::vector<Mode>& modes) {
  const auto slower = [](const Mode& a, const Mode& b) { return a.pole.real() > b.pole.real(); };
  const auto slowest = std::min_element(modes.begin(), modes.end(), slower);
  return slowest == modes.end() ? nullptr : &*slowest;
}

/// Why the motion may not repeat; `words`: the motion, the time, the channel that still changes.
Found Unsteady(const Vehicle& vehicle, const MarchOptions& options, std::vector<std::string> words) {
  const VehicleSummary summary = Summarise(vehicle, vehicle.ParameterValues());
  const Mode* mode = SlowestMode(summary.modes);
  if (!mode) return {&kUnsteady, words};
  words.push_back(mode->name);
  if (mode->kind == Mode::Kind::kFree || mode->kind == Mode::Kind::kDiverging) {
    words.push_back(KindName(mode->kind));
    return {&kUnsteadyMode, words};
  }
  const double settling_s = -std::log(options.tolerance) / -mode->pole.real();
  words.insert(words.end(), {Short(mode->frequency_Hz) + " Hz", Short(mode->damping_ratio),
                             FormatNumber(std::ceil(settling_s)) + " s"});
  return {settling_s < options.longest_s / 2 ? &kUnsteadyAmplitude : &kUnsteadyDamping, words};
}

}  // namespace

void MarchOptions::Validate() const {
  RequireOption(accuracy > 0 && accuracy < 1, "accuracy", accuracy, "between 0 and 1");
  RequireOption(tolerance > 0 && tolerance < 1, "tolerance", tolerance, "between 0 and 1");
  RequireOption(window_s > 0 && std::isfinite(window_s), "window_s", window_s, "positive and finite");
  RequireOption(longest_s > window_s && std::isfinite(longest_s), "longest_s", longest_s,
                "longer than window_s and finite");
  RequireOption(samples_per_cycle > 2 * kHarmonics, "samples_per_cycle", samples_per_cycle, "at least 5");
}

MarchedResponse March(TimeSystem& system, const Excitation& excitation, const MarchOptions& options,
                      const std::function<void(std::size_t done)>& progress) {
  return MarchEach(system.rig(), excitation, options, progress, [&](const Sine& sine) {
    SteadyState run = sine.Begin(options.samples_per_cycle);
    system.Run(
        sine.posts, 0, run.step(),
        [&](double t, const Eigen::VectorXd& readings) {
          sine.ask();
          run.Add(t, readings);
        },
        [&] { return run.Done(); });
    return run;
  });
}

MarchedResponse March(Multibody& multibody, const Excitation& excitation, const MarchOptions& options,
                      const std::function<void(std::size_t done)>& progress) {
  const RigView rig = RigViewOf(multibody.vehicle());
  return MarchEach(rig, excitation, options, progress,
                   [&](const Sine& sine) { return MarchMultibody(multibody, sine, options); });
}

std::string UnsteadyMessage(const Vehicle& vehicle, const Excitation& excitation, const UnsteadyMotion& motion,
                            const MarchOptions& options) {
  const std::string what = ShapeText(vehicle, excitation.shape) + " at " + Short(motion.frequency_Hz) + " Hz, " +
                           Short(1e3 * motion.amplitude_m) + " mm";
  const std::string changes =
      motion.sensor.empty() ? ""
                            : " ('" + motion.sensor + "' still changes its " +
                                  (motion.is_mean ? "mean" : "first harmonic") + " by " + Short(motion.change) +
                                  " per " + (motion.cycles == 1 ? "cycle" : std::to_string(motion.cycles) + " cycles") +
                                  ", tolerance " + Short(options.tolerance) + ")";
  return Unsteady(vehicle, options, {what, FormatNumber(options.longest_s) + " s", changes}).Text();
}

}  // namespace fourpost
