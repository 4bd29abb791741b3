#include "vehicles/linearised_cycle.h"

#include <complex>
#include <numbers>

namespace fourpost {
namespace {

using Complex = std::complex<double>;

}  // namespace

LinearisedCycle::LinearisedCycle(const CondensedModel& model, const std::vector<double>& shape,
                                 const HarmonicBalanceOptions& options)
    : model_(model),
      shape_(Eigen::Map<const Eigen::VectorXd>(shape.data(), static_cast<Eigen::Index>(shape.size()))),
      options_(options),
      transform_(options.harmonics, options.samples),
      dashpots_(static_cast<Eigen::Index>(model.dashpots.size())) {
  directions_.resize(model.mass.rows(), dashpots_);
  rates_.resize(dashpots_);
  for (Eigen::Index j = 0; j < dashpots_; ++j) {
    directions_.col(j) = Dashpot(j).direction;
    rates_[j] = Dashpot(j).CentreRate();
  }
  const auto harmonics = static_cast<std::size_t>(options.harmonics) + 1;
  compliance_.resize(harmonics);
  mobility_.resize(harmonics);
  series_share_.assign(harmonics, Eigen::VectorXcd(dashpots_));
  series_leak_.assign(harmonics, Eigen::VectorXcd(dashpots_));
}

bool LinearisedCycle::Solve(double frequency_Hz, double amplitude_m) {
  omega_ = 2 * std::numbers::pi * frequency_Hz;
  post_height_ = amplitude_m * shape_;
  Linear();
  return Iterate();
}

SensorHarmonics LinearisedCycle::Sensors() const {
  SensorHarmonics out(model_.on_position.rows(), options_.harmonics + 1);
  for (int h = 0; h <= options_.harmonics; ++h) {
    const Complex iw(0, h * omega_);
    const Eigen::VectorXcd motion = MotionAt(h);
    out.col(h) =
        model_.on_position * motion + iw * (model_.on_velocity * motion) + iw * iw * (model_.on_acceleration * motion);
  }
  const Complex iw(0, omega_);
  out.col(1) += model_.on_post_height * post_height_ + iw * (model_.on_post_velocity * post_height_) +
                iw * iw * (model_.on_post_acceleration * post_height_);
  return out;
}

const CondensedModel::Dashpot& LinearisedCycle::Dashpot(Eigen::Index j) const {
  return model_.dashpots[static_cast<std::size_t>(j)];
}

/// Linear vehicle with mean dashpots: motion due to the posts, and to unit remainders of the dashpots.
void LinearisedCycle::Linear() {
  for (int h = 0; h <= options_.harmonics; ++h) {
    const auto i = static_cast<std::size_t>(h);
    const Complex iw(0, h * omega_);
    impedance_ = model_.stiffness + iw * model_.damping + iw * iw * model_.mass;
    for (Eigen::Index j = 0; j < dashpots_; ++j) {
      const double mean = rates_[j];
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
void LinearisedCycle::Velocities(Eigen::MatrixXcd& velocity) const {
  for (int h = 0; h <= options_.harmonics; ++h) {
    const auto i = static_cast<std::size_t>(h);
    const Eigen::VectorXcd remainder = remainder_.row(h).transpose();
    Eigen::VectorXcd across = -(mobility_[i] * series_share_[i].cwiseProduct(remainder));
    if (h == 1) across += Complex(0, omega_) * (directions_.transpose() * driven_);
    velocity.row(h) = (series_share_[i].cwiseProduct(across - series_leak_[i].cwiseProduct(remainder))).transpose();
  }
}

Eigen::MatrixXcd LinearisedCycle::Motion() const {
  Eigen::MatrixXcd motion(options_.harmonics + 1, model_.mass.rows());
  for (int h = 0; h <= options_.harmonics; ++h) motion.row(h) = MotionAt(h).transpose();
  return motion;
}

// The dashpot's force stretches the spring.
Eigen::MatrixXcd LinearisedCycle::SeriesExtensions() const {
  Eigen::MatrixXcd extensions(options_.harmonics + 1, 0);
  for (Eigen::Index j = 0; j < dashpots_; ++j) {
    const double series = Dashpot(j).series_stiffness;
    if (!(series > 0)) continue;
    extensions.conservativeResize(Eigen::NoChange, extensions.cols() + 1);
    extensions.rightCols<1>() = (rates_[j] * velocity_.col(j) + remainder_.col(j)) / series;
  }
  return extensions;
}

bool LinearisedCycle::Iterate() {
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
    // Past the largest double no iterate means anything: the one before stays.
    if (!next_.allFinite()) return false;
    velocity_.swap(next_);
    if (change <= options_.tolerance * scale) return true;
  }
  return false;
}

void LinearisedCycle::Remainders() {
  transform_.ToTime(velocity_, time_);
  for (Eigen::Index j = 0; j < dashpots_; ++j) {
    const DashpotLaw& law = Dashpot(j).law;
    const double mean = rates_[j];
    for (Eigen::Index k = 0; k < time_.rows(); ++k) time_(k, j) = law.Force(time_(k, j)) - mean * time_(k, j);
  }
  transform_.ToHarmonics(time_, remainder_);
}

Eigen::VectorXcd LinearisedCycle::MotionAt(int h) const {
  const auto i = static_cast<std::size_t>(h);
  Eigen::VectorXcd motion =
      -(compliance_[i] * series_share_[i].cwiseProduct(Eigen::VectorXcd(remainder_.row(h).transpose())));
  if (h == 1) motion += driven_;
  return motion;
}

}  // namespace fourpost
