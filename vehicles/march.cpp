#include "vehicles/march.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "analysis/fourier.h"
#include "analysis/option_check.h"
#include "vehicles/response_recorder.h"

namespace fourpost {
namespace {

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

/// One frequency: collects windows of samples until their means and first harmonics repeat.
class SteadyState {
 public:
  SteadyState(Eigen::Index sensors, double frequency_Hz, const MarchOptions& options)
      : options_(options),
        cycles_(std::max(1, static_cast<int>(std::ceil(options.window_s * frequency_Hz)))),
        step_(1 / (frequency_Hz * options.samples_per_cycle)),
        window_(cycles_ * options.samples_per_cycle, sensors) {}

  double step() const { return step_; }
  double window_duration() const { return step_ * static_cast<double>(window_.rows()); }
  double time() const { return time_; }
  bool steady() const { return steady_; }
  const SensorHarmonics& harmonics() const { return harmonics_; }

  void Add(double t, const Eigen::VectorXd& sensors) {
    time_ = t;
    window_.row(filled_++) = sensors.transpose();
    if (filled_ == window_.rows()) CloseWindow();
  }

  bool Done() const { return steady_ || (filled_ == 0 && time_ >= options_.longest_s); }

 private:
  void CloseWindow() {
    filled_ = 0;
    SensorHarmonics latest(window_.cols(), kHarmonics + 1);
    for (Eigen::Index i = 0; i < window_.cols(); ++i) {
      const std::span<const double> samples(window_.col(i).data(), static_cast<std::size_t>(window_.rows()));
      latest.row(i) = Harmonics(samples, cycles_, kHarmonics).transpose();
    }
    // The first window holds the ramp.
    const bool comparable = ++windows_ > 2;
    steady_ = comparable && Repeats(latest);
    harmonics_ = latest;
  }

  /// Whether mean and first harmonic of each sensor are those of the window before. A mean may be next to nothing: it
  /// is compared with the first harmonic where that is larger.
  bool Repeats(const SensorHarmonics& latest) const {
    const Eigen::ArrayXXd change = (latest - harmonics_).leftCols<2>().cwiseAbs();
    const Eigen::ArrayXXd size = latest.leftCols<2>().cwiseAbs();
    return (change.col(1) <= options_.tolerance * size.col(1)).all() &&
           (change.col(0) <= options_.tolerance * size.col(0).max(size.col(1))).all();
  }

  const MarchOptions& options_;
  int cycles_;
  double step_;
  /// Samples x sensors.
  Eigen::MatrixXd window_;
  Eigen::Index filled_ = 0;
  int windows_ = 0;
  double time_ = 0;
  bool steady_ = false;
  SensorHarmonics harmonics_;
};

}  // namespace

void MarchOptions::Validate() const {
  RequireOption(accuracy > 0 && accuracy < 1, "accuracy", accuracy, "between 0 and 1");
  RequireOption(tolerance > 0 && tolerance < 1, "tolerance", tolerance, "between 0 and 1");
  RequireOption(window_s > 0 && std::isfinite(window_s), "window_s", window_s, "positive and finite");
  RequireOption(longest_s > window_s && std::isfinite(longest_s), "longest_s", longest_s,
                "longer than window_s and finite");
  RequireOption(samples_per_cycle > 2 * kHarmonics, "samples_per_cycle", samples_per_cycle, "at least 5");
}

MarchedResponse March(Multibody& multibody, const Excitation& excitation, const MarchOptions& options,
                      const std::function<void(std::size_t done)>& progress) {
  options.Validate();
  excitation.Validate(multibody.vehicle().posts.size());
  const std::vector<Sensor>& sensors = multibody.vehicle().sensors;
  ResponseRecorder recorder(sensors, excitation);
  MarchedResponse out;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    const double frequency = excitation.frequency_Hz[i];
    SteadyState run(static_cast<Eigen::Index>(sensors.size()), frequency, options);
    multibody.SetPostMotion(SteppedSine(excitation.shape, excitation.amplitude_m[i], 2 * std::numbers::pi * frequency,
                                        Ramp{run.window_duration()}));
    multibody.Integrate(
        multibody.RestState(), 0, run.step(), options.accuracy,
        [&](double t, const Eigen::VectorXd&, const Eigen::VectorXd& readings) { run.Add(t, readings); },
        [&] { return run.Done(); });
    if (!run.steady()) out.unsteady_Hz.push_back(frequency);
    out.simulated_s += run.time();
    recorder.Record(i, run.harmonics());
    if (progress) progress(i + 1);
  }
  multibody.SetPostMotion(nullptr);
  out.response = recorder.Take();
  return out;
}

}  // namespace fourpost
