#include "vehicles/harmonic_balance.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>

#include <Eigen/LU>

#include "vehicles/response_recorder.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Real samples of one cycle <-> complex harmonics 0..H with y(t) = Re sum Y_h exp(i h w t).
class CycleTransform {
 public:
  CycleTransform(int harmonics, int samples) : cosine_(samples, harmonics + 1), sine_(samples, harmonics + 1) {
    for (int k = 0; k < samples; ++k)
      for (int h = 0; h <= harmonics; ++h) {
        const double angle = 2 * std::numbers::pi * h * k / samples;
        cosine_(k, h) = std::cos(angle);
        sine_(k, h) = std::sin(angle);
      }
  }

  /// `harmonics`: (H + 1) x signals; `time`: samples x signals.
  void ToTime(const Eigen::MatrixXcd& harmonics, Eigen::MatrixXd& time) const {
    time.noalias() = cosine_ * harmonics.real();
    time.noalias() -= sine_ * harmonics.imag();
  }

  void ToHarmonics(const Eigen::MatrixXd& time, Eigen::MatrixXcd& harmonics) const {
    const double scale = 2.0 / static_cast<double>(time.rows());
    harmonics.real().noalias() = scale * (cosine_.transpose() * time);
    harmonics.imag().noalias() = -scale * (sine_.transpose() * time);
    harmonics.row(0) *= 0.5;
  }

 private:
  Eigen::MatrixXd cosine_;
  Eigen::MatrixXd sine_;
};

/// One frequency at a time; keeps its memory from one to the next.
class CycleSolver {
 public:
  CycleSolver(const CondensedModel& model, const Eigen::VectorXd& shape, const HarmonicBalanceOptions& options)
      : model_(model),
        shape_(shape),
        options_(options),
        transform_(options.harmonics, options.samples),
        dashpots_(static_cast<Eigen::Index>(model.dashpots.size())) {
    directions_.resize(model.mass.rows(), dashpots_);
    for (Eigen::Index j = 0; j < dashpots_; ++j) directions_.col(j) = Dashpot(j).direction;
    const auto harmonics = static_cast<std::size_t>(options.harmonics + 1);
    compliance_.resize(harmonics);
    mobility_.resize(harmonics);
    series_share_.assign(harmonics, Eigen::VectorXcd(dashpots_));
    series_leak_.assign(harmonics, Eigen::VectorXcd(dashpots_));
  }

  /// Whether the iteration converged.
  bool Solve(double frequency_Hz, double amplitude_m) {
    omega_ = 2 * std::numbers::pi * frequency_Hz;
    post_height_ = amplitude_m * shape_;
    Linear();
    return Iterate();
  }

  /// Sensors x (harmonics + 1), for the last solution.
  SensorHarmonics Sensors() const {
    SensorHarmonics out(model_.on_position.rows(), options_.harmonics + 1);
    for (int h = 0; h <= options_.harmonics; ++h) {
      const Complex iw(0, h * omega_);
      const Eigen::VectorXcd motion = Motion(h);
      out.col(h) = model_.on_position * motion + iw * (model_.on_velocity * motion) +
                   iw * iw * (model_.on_acceleration * motion);
    }
    out.col(1) += model_.on_post_height * post_height_ + Complex(0, omega_) * (model_.on_post_velocity * post_height_);
    return out;
  }

 private:
  const CondensedModel::Dashpot& Dashpot(Eigen::Index j) const { return model_.dashpots[static_cast<std::size_t>(j)]; }

  /// Linear vehicle with mean dashpots: motion due to the posts, and to unit remainders of the dashpots.
  void Linear() {
    for (int h = 0; h <= options_.harmonics; ++h) {
      const auto i = static_cast<std::size_t>(h);
      const Complex iw(0, h * omega_);
      impedance_ = model_.stiffness + iw * model_.damping + iw * iw * model_.mass;
      for (Eigen::Index j = 0; j < dashpots_; ++j) {
        const double mean = Dashpot(j).law.Mean();
        const double series = Dashpot(j).series_stiffness;
        // A series spring lets a dashpot of mean rate c carry c / (1 + i w c / k) of the velocity across both.
        series_share_[i][j] = series > 0 ? 1.0 / (1.0 + iw * mean / series) : Complex(1);
        series_leak_[i][j] = series > 0 ? iw / series : Complex(0);
        impedance_ += iw * mean * series_share_[i][j] * directions_.col(j) * directions_.col(j).transpose();
      }
      factors_.compute(impedance_);
      compliance_[i] = factors_.solve(directions_.cast<Complex>());
      mobility_[i] = iw * (directions_.transpose() * compliance_[i]);
      if (h == 1)
        driven_ = factors_.solve(model_.post_stiffness * post_height_ + iw * (model_.post_damping * post_height_));
    }
  }

  /// Velocities across the dashpots themselves, (H + 1) x dashpots, for the present remainders.
  void Velocities(Eigen::MatrixXcd& velocity) const {
    for (int h = 0; h <= options_.harmonics; ++h) {
      const auto i = static_cast<std::size_t>(h);
      const Eigen::VectorXcd remainder = remainder_.row(h).transpose();
      Eigen::VectorXcd across = -(mobility_[i] * series_share_[i].cwiseProduct(remainder));
      if (h == 1) across += Complex(0, omega_) * (directions_.transpose() * driven_);
      velocity.row(h) =
          (series_share_[i].cwiseProduct(across - series_leak_[i].cwiseProduct(remainder))).transpose();
    }
  }

  bool Iterate() {
    remainder_.setZero(options_.harmonics + 1, dashpots_);
    velocity_.setZero(options_.harmonics + 1, dashpots_);
    next_.resize(options_.harmonics + 1, dashpots_);
    if (dashpots_ == 0) return true;
    Velocities(velocity_);
    for (int iteration = 0; iteration < options_.max_iterations; ++iteration) {
      Remainders();
      Velocities(next_);
      const double change = (next_ - velocity_).cwiseAbs().maxCoeff();
      const double scale = next_.cwiseAbs().maxCoeff();
      velocity_.swap(next_);
      if (!(scale < 1e300)) return false;
      if (change <= options_.tolerance * scale) return true;
    }
    return false;
  }

  void Remainders() {
    transform_.ToTime(velocity_, time_);
    for (Eigen::Index j = 0; j < dashpots_; ++j) {
      const BilinearDashpot& law = Dashpot(j).law;
      const double mean = law.Mean();
      for (Eigen::Index k = 0; k < time_.rows(); ++k) time_(k, j) = law.Force(time_(k, j)) - mean * time_(k, j);
    }
    transform_.ToHarmonics(time_, remainder_);
  }

  Eigen::VectorXcd Motion(int h) const {
    const auto i = static_cast<std::size_t>(h);
    Eigen::VectorXcd motion =
        -(compliance_[i] * series_share_[i].cwiseProduct(Eigen::VectorXcd(remainder_.row(h).transpose())));
    if (h == 1) motion += driven_;
    return motion;
  }

  const CondensedModel& model_;
  const Eigen::VectorXd& shape_;
  const HarmonicBalanceOptions& options_;
  CycleTransform transform_;
  Eigen::Index dashpots_;
  Eigen::MatrixXd directions_;
  double omega_ = 0;
  Eigen::VectorXd post_height_;
  Eigen::MatrixXcd impedance_;
  Eigen::PartialPivLU<Eigen::MatrixXcd> factors_;
  std::vector<Eigen::MatrixXcd> compliance_;  // per harmonic, n x dashpots
  std::vector<Eigen::MatrixXcd> mobility_;    // per harmonic, dashpots x dashpots
  std::vector<Eigen::VectorXcd> series_share_;
  std::vector<Eigen::VectorXcd> series_leak_;
  Eigen::VectorXcd driven_;
  Eigen::MatrixXcd remainder_;
  Eigen::MatrixXcd velocity_;
  Eigen::MatrixXcd next_;
  Eigen::MatrixXd time_;
};

void Require(bool holds, const std::string& text) {
  if (!holds) throw std::invalid_argument("HarmonicBalanceOptions: " + text);
}

}  // namespace

void HarmonicBalanceOptions::Validate() const {
  Require(harmonics >= 2, "harmonics = " + std::to_string(harmonics) + " must be at least 2");
  Require(samples > 2 * harmonics, "samples = " + std::to_string(samples) + " must exceed twice the harmonics");
  Require(tolerance > 0, "tolerance = " + std::to_string(tolerance) + " must be positive");
  Require(max_iterations >= 1, "max_iterations = " + std::to_string(max_iterations) + " must be at least 1");
}

PeriodicResponse SolveHarmonicBalance(const CondensedModel& model, const std::vector<Sensor>& sensors,
                                      const Excitation& excitation, const HarmonicBalanceOptions& options) {
  options.Validate();
  const Eigen::VectorXd shape =
      Eigen::Map<const Eigen::VectorXd>(excitation.shape.data(), static_cast<Eigen::Index>(excitation.shape.size()));
  CycleSolver solver(model, shape, options);
  ResponseRecorder recorder(sensors, excitation);
  PeriodicResponse out;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    if (!solver.Solve(excitation.frequency_Hz[i], excitation.amplitude_m[i]))
      out.unconverged_Hz.push_back(excitation.frequency_Hz[i]);
    recorder.Record(i, solver.Sensors());
  }
  out.response = recorder.Take();
  return out;
}

}  // namespace fourpost
