#include "vehicles/random_response/random_vehicle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <Eigen/Core>
#include <Eigen/LU>

#include "analysis/numerics/anderson_acceleration.h"
#include "analysis/numerics/decompositions.h"
#include "analysis/text/option_check.h"
#include "vehicles/condensed/linear_vehicle.h"

namespace fourpost {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Iterates kept by Anderson's method.
constexpr int kHistory = 4;
/// Gains that change no extension by more than this share of the tolerance are left out.
constexpr double kSilent = 0.01;

/// Gaussian elimination with partial pivoting in place: right <- matrix^-1 right.
void EliminateInPlace(Eigen::Ref<MatrixXcd> matrix, Eigen::Ref<MatrixXcd> right) {
  const Index n = matrix.rows();
  for (Index k = 0; k < n; ++k) {
    Index pivot = k;
    for (Index i = k + 1; i < n; ++i)
      if (std::norm(matrix(i, k)) > std::norm(matrix(pivot, k))) pivot = i;
    if (pivot != k) {
      matrix.row(k).swap(matrix.row(pivot));
      right.row(k).swap(right.row(pivot));
    }
    const Complex inverse = std::conj(matrix(k, k)) / std::norm(matrix(k, k));
    for (Index i = k + 1; i < n; ++i) {
      const Complex factor = matrix(i, k) * inverse;
      for (Index j = k + 1; j < n; ++j) matrix(i, j) -= factor * matrix(k, j);
      for (Index j = 0; j < right.cols(); ++j) right(i, j) -= factor * right(k, j);
    }
    for (Index j = 0; j < right.cols(); ++j) right(k, j) *= inverse;
    for (Index j = k + 1; j < n; ++j) matrix(k, j) *= inverse;
  }
  for (Index k = n - 1; k-- > 0;)
    for (Index i = k + 1; i < n; ++i)
      for (Index j = 0; j < right.cols(); ++j) right(k, j) -= matrix(k, i) * right(i, j);
}

}  // namespace

void RandomOptions::Validate() const {
  RequirePositive("RandomOptions: tolerance", tolerance);
  RequireOption(most_iterations >= 1, "RandomOptions: most_iterations", most_iterations, "1 or more");
}

RandomVehicle::RandomVehicle(const CondensedModel& model, SpectralGrid grid)
    : grid_(std::move(grid)), ports_(PortsOf(model)), sensors_(model.on_position.rows()) {
  SolveLinearPart(model);
  SolveAtRest(model);
  FindReach();
}

void RandomVehicle::SolveLinearPart(const CondensedModel& model) {
  const LinearVehicle vehicle(model, LinearVehicle::Rates::kCentre);
  const MatrixXd dashpots = DashpotDirections(model);
  const Index n = model.mass.rows();
  const auto ports = static_cast<Index>(ports_.size());
  const Index posts = model.post_stiffness.cols();
  const Index columns = ports + posts;
  MatrixXd directions(vehicle.size(), ports);
  for (Index j = 0; j < ports; ++j) directions.col(j) = ports_[static_cast<std::size_t>(j)].direction;
  MatrixXcd forces = MatrixXcd::Zero(vehicle.size(), columns);
  forces.leftCols(ports) = directions.cast<Complex>();
  MatrixXcd motion(vehicle.size(), columns);
  MatrixXcd impedance(vehicle.size(), vehicle.size());
  MatrixXcd sensing(sensors_, n);
  Eigen::PartialPivLU<MatrixXcd> factors(vehicle.size());
  receptance_.resize(ports + sensors_ + dashpots.cols(), columns * frequencies());
  for (Index k = 0; k < frequencies(); ++k) {
    const double w = 2 * std::numbers::pi * grid_.frequency_Hz[static_cast<std::size_t>(k)];
    impedance.real() = vehicle.stiffness;
    impedance.imag() = w * vehicle.damping;
    impedance.topLeftCorner(n, n).real() -= w * w * vehicle.mass;
    forces.topRightCorner(n, posts).real() = model.post_stiffness;
    forces.topRightCorner(n, posts).imag() = w * model.post_damping;
    factors.compute(impedance);
    motion = factors.solve(forces);
    auto here = receptance_.middleCols(k * columns, columns);
    here.topRows(ports).noalias() = directions.transpose().cast<Complex>().lazyProduct(motion);
    for (Index j = 0; j < ports; ++j)
      if (const int post = ports_[static_cast<std::size_t>(j)].post; post >= 0) here(j, ports + post) += 1.0;
    sensing.real() = model.on_position - w * w * model.on_acceleration;
    sensing.imag() = w * model.on_velocity;
    auto read = here.middleRows(ports, sensors_);
    read.noalias() = sensing.lazyProduct(motion.topRows(n));
    read.rightCols(posts).real() += model.on_post_height - w * w * model.on_post_acceleration;
    read.rightCols(posts).imag() += w * model.on_post_velocity;
    here.bottomRows(dashpots.cols()).noalias() = dashpots.transpose().cast<Complex>().lazyProduct(motion);
  }
}

void RandomVehicle::SolveAtRest(const CondensedModel& model) {
  const LinearVehicle vehicle(model, LinearVehicle::Rates::kCentre);
  const auto ports = static_cast<Index>(ports_.size());
  MatrixXd directions(vehicle.size(), ports);
  for (Index j = 0; j < ports; ++j) directions.col(j) = ports_[static_cast<std::size_t>(j)].direction;
  // Rigid-body modes are not moved by means.
  const MatrixXd motion =
      ports > 0 ? LeastNorm(vehicle.stiffness).Solve(directions) : MatrixXd::Zero(vehicle.size(), 0);
  at_rest_.resize(ports + sensors_, ports);
  at_rest_.topRows(ports) = directions.transpose() * motion;
  at_rest_.bottomRows(sensors_) = model.on_position * motion.topRows(model.mass.rows());
}

void RandomVehicle::FindReach() {
  const auto ports = static_cast<Index>(ports_.size());
  const Index columns = frequencies() > 0 ? receptance_.cols() / frequencies() : 0;
  for (Index j = 0; j < ports; ++j) {
    Reach reach;
    for (Index k = 0; k < frequencies(); ++k) {
      const double own = std::abs(receptance_(j, k * columns + j));
      reach.by_stiffness = std::max(reach.by_stiffness, own);
      reach.by_damping =
          std::max(reach.by_damping, 2 * std::numbers::pi * grid_.frequency_Hz[static_cast<std::size_t>(k)] * own);
    }
    reach_.push_back(reach);
  }
}

/// The state of one solution: motions of the ports, their gains, and amplitudes of the active ones.
class RandomVehicle::Iteration {
 public:
  Iteration(const RandomVehicle& vehicle, const PostSpectra& posts, double silent)
      : vehicle_(vehicle),
        posts_(posts),
        silent_(silent),
        ports_(static_cast<Index>(vehicle.ports_.size())),
        columns_(ports_ + posts.heights.rows()),
        unforced_(ports_, posts.heights.cols()),
        motions_(vehicle.ports_.size()),
        gains_(vehicle.ports_.size()) {
    for (Index k = 0; k < vehicle.frequencies(); ++k)
      unforced_.middleCols(k * sources(), sources()).noalias() =
          At(k).topRightCorner(ports_, posts_.heights.rows()).lazyProduct(posts_.At(k));
  }

  Index sources() const { return posts_.sources; }

  /// Gains at these motions, and which of them count.
  void SetMotions(std::vector<PortMotion> motions) {
    motions_ = std::move(motions);
    for (std::size_t i = 0; i < motions_.size(); ++i) gains_[i] = GainOf(vehicle_.ports_[i].law, motions_[i]);
    FindActive();
  }

  void SetGains(const std::vector<StatisticalGain>& gains) {
    gains_ = gains;
    FindActive();
  }

  /// Deviations of the ports with these gains, and their means.
  std::vector<PortMotion> Answer() {
    std::vector<PortMotion> answer(motions_.size());
    Sweep([&](Index k, double w, const auto& extensions) {
      const double share = vehicle_.grid_.share_Hz[static_cast<std::size_t>(k)];
      for (Index j = 0; j < ports_; ++j) {
        double square = 0;
        for (Index s = 0; s < sources(); ++s) square += std::norm(extensions(j, s));
        answer[static_cast<std::size_t>(j)].extension_sd += share * square;
        answer[static_cast<std::size_t>(j)].rate_sd += share * w * w * square;
      }
    });
    const VectorXd means = Means();
    for (Index j = 0; j < ports_; ++j) {
      PortMotion& motion = answer[static_cast<std::size_t>(j)];
      motion.extension_sd = std::sqrt(motion.extension_sd);
      motion.rate_sd = std::sqrt(motion.rate_sd);
      motion.mean = means[j];
    }
    return answer;
  }

  void Write(RandomResponse& response) {
    const Index dashpots = vehicle_.receptance_.rows() - ports_ - vehicle_.sensors_;
    MatrixXcd outputs(vehicle_.sensors_ + dashpots, posts_.heights.cols());
    Sweep([&](Index k, double w, const auto& extensions) {
      auto here = outputs.middleCols(k * sources(), sources());
      const Eigen::Ref<const MatrixXcd> at = At(k).bottomRows(outputs.rows());
      here.noalias() = at.rightCols(posts_.heights.rows()).lazyProduct(posts_.At(k));
      for (std::size_t a = 0; a < active_.size(); ++a) {
        const auto i = static_cast<std::size_t>(active_[a]);
        const Complex gain(gains_[i].by_extension, w * gains_[i].by_rate);
        for (Index s = 0; s < sources(); ++s) {
          const Complex force = gain * extensions(active_[a], s);
          here.col(s) -= at.col(active_[a]) * force;
          for (const int cell : vehicle_.ports_[i].load_cells) here(cell, s) += force;
        }
      }
    });
    response.readings = outputs.topRows(vehicle_.sensors_);
    response.dashpots = outputs.bottomRows(dashpots);
    response.ports = motions_;
    response.gains = gains_;
    response.mean_readings = VectorXd::Zero(vehicle_.sensors_);
    for (Index j = 0; j < ports_; ++j) {
      const auto i = static_cast<std::size_t>(j);
      response.mean_readings -= gains_[i].mean * vehicle_.at_rest_.bottomRows(vehicle_.sensors_).col(j);
      for (const int cell : vehicle_.ports_[i].load_cells) response.mean_readings[cell] += gains_[i].mean;
    }
  }

 private:
  void FindActive() {
    active_.clear();
    for (Index j = 0; j < ports_; ++j) {
      const StatisticalGain& gain = gains_[static_cast<std::size_t>(j)];
      const Reach& reach = vehicle_.reach_[static_cast<std::size_t>(j)];
      const double loop = std::abs(gain.by_extension) * reach.by_stiffness + std::abs(gain.by_rate) * reach.by_damping;
      if (!(loop <= silent_)) active_.push_back(j);
    }
  }

  Eigen::Ref<const MatrixXcd> At(Index k) const { return vehicle_.receptance_.middleCols(k * columns_, columns_); }

  /// Calls `take` with the extensions of all ports at each frequency.
  template <typename Take>
  void Sweep(const Take& take) {
    const auto count = static_cast<Index>(active_.size());
    matrix_.resize(count, count);
    solved_.resize(count, sources());
    MatrixXcd extensions(ports_, sources());
    for (Index k = 0; k < vehicle_.frequencies(); ++k) {
      const double w = 2 * std::numbers::pi * vehicle_.grid_.frequency_Hz[static_cast<std::size_t>(k)];
      extensions = unforced_.middleCols(k * sources(), sources());
      if (count > 0) {
        const Eigen::Ref<const MatrixXcd> at = At(k);
        for (Index b = 0; b < count; ++b) {
          const StatisticalGain& gain = gains_[static_cast<std::size_t>(active_[static_cast<std::size_t>(b)])];
          const Complex of_port(gain.by_extension, w * gain.by_rate);
          for (Index a = 0; a < count; ++a)
            matrix_(a, b) = at(active_[static_cast<std::size_t>(a)], active_[static_cast<std::size_t>(b)]) * of_port +
                            (a == b ? 1.0 : 0.0);
        }
        for (Index a = 0; a < count; ++a) solved_.row(a) = extensions.row(active_[static_cast<std::size_t>(a)]);
        EliminateInPlace(matrix_, solved_);
        for (Index a = 0; a < count; ++a) {
          const Index port = active_[static_cast<std::size_t>(a)];
          const StatisticalGain& gain = gains_[static_cast<std::size_t>(port)];
          const Complex of_port(gain.by_extension, w * gain.by_rate);
          for (Index s = 0; s < sources(); ++s) {
            const Complex force = of_port * solved_(a, s);
            for (Index j = 0; j < ports_; ++j) extensions(j, s) -= at(j, port) * force;
          }
        }
      }
      take(k, w, extensions);
    }
  }

  /// mean e = -R(0) mean r, with r linear about the last means.
  VectorXd Means() const {
    VectorXd force(ports_);
    MatrixXd matrix = MatrixXd::Identity(ports_, ports_);
    bool is_moved = false;
    for (Index j = 0; j < ports_; ++j) {
      const auto i = static_cast<std::size_t>(j);
      force[j] = gains_[i].mean - gains_[i].by_extension * motions_[i].mean;
      matrix.col(j) += vehicle_.at_rest_.col(j).head(ports_) * gains_[i].by_extension;
      is_moved = is_moved || force[j] != 0;
    }
    if (!is_moved) return VectorXd::Zero(ports_);
    const VectorXd unforced = -(vehicle_.at_rest_.topRows(ports_) * force);
    return Solved(matrix, unforced);
  }

  const RandomVehicle& vehicle_;
  const PostSpectra& posts_;
  /// A gain times the port's own receptance that changes nothing.
  double silent_;
  Index ports_;
  Index columns_;
  /// Extensions without the gains.
  MatrixXcd unforced_;
  std::vector<PortMotion> motions_;
  std::vector<StatisticalGain> gains_;
  /// Ports with a gain.
  std::vector<Index> active_;
  MatrixXcd matrix_;
  MatrixXcd solved_;
};

namespace {

/// Deviations as logarithms, so that they stay positive; means over the deviation at first.
VectorXd Packed(const std::vector<PortMotion>& motions, const std::vector<PortMotion>& first) {
  VectorXd packed(static_cast<Index>(3 * motions.size()));
  for (std::size_t j = 0; j < motions.size(); ++j) {
    const auto at = static_cast<Index>(3 * j);
    const PortMotion& motion = motions[j];
    packed[at] = motion.extension_sd > 0 ? std::log(motion.extension_sd) : 0;
    packed[at + 1] = motion.rate_sd > 0 ? std::log(motion.rate_sd) : 0;
    packed[at + 2] = first[j].extension_sd > 0 ? motion.mean / first[j].extension_sd : 0;
  }
  return packed;
}

std::vector<PortMotion> Unpacked(const VectorXd& packed, const std::vector<PortMotion>& first) {
  std::vector<PortMotion> motions(first.size());
  for (std::size_t j = 0; j < motions.size(); ++j) {
    const auto at = static_cast<Index>(3 * j);
    if (first[j].extension_sd > 0) motions[j].extension_sd = std::exp(packed[at]);
    if (first[j].rate_sd > 0) motions[j].rate_sd = std::exp(packed[at + 1]);
    motions[j].mean = packed[at + 2] * first[j].extension_sd;
  }
  return motions;
}

}  // namespace

void RandomVehicle::RequireFitting(const PostSpectra& posts) const {
  const Index post_count =
      frequencies() > 0 ? receptance_.cols() / frequencies() - static_cast<Index>(ports_.size()) : 0;
  RequireOption(posts.heights.rows() == post_count, "PostSpectra: posts", posts.heights.rows(),
                "as many as the model's");
  RequireOption(posts.heights.cols() == frequencies() * posts.sources, "PostSpectra: columns", posts.heights.cols(),
                "frequencies of the grid times sources");
}

RandomResponse RandomVehicle::Respond(const PostSpectra& posts, const std::vector<StatisticalGain>& gains) const {
  RequireFitting(posts);
  RequireOption(gains.size() == ports_.size(), "RandomVehicle: gains", gains.size(), "one per nonlinear element");
  Iteration iteration(*this, posts, 0);
  iteration.SetGains(gains);
  RandomResponse response{.converged = true};
  iteration.Write(response);
  response.mean_readings.setZero();
  return response;
}

RandomResponse RandomVehicle::Solve(const PostSpectra& posts, const RandomOptions& options) const {
  options.Validate();
  RequireFitting(posts);
  Iteration iteration(*this, posts, kSilent * options.tolerance);
  RandomResponse response;
  const std::vector<PortMotion> first = iteration.Answer();
  VectorXd at = Packed(first, first);
  AndersonAcceleration acceleration(kHistory);
  for (response.iterations = 1; response.iterations <= options.most_iterations; ++response.iterations) {
    iteration.SetMotions(Unpacked(at, first));
    const VectorXd change = Packed(iteration.Answer(), first) - at;
    const double largest = change.size() > 0 ? change.cwiseAbs().maxCoeff() : 0;
    if (!std::isfinite(largest)) break;
    response.converged = largest <= options.tolerance;
    if (response.converged) break;
    at = acceleration.Next(at, change);
  }
  iteration.Write(response);
  return response;
}

}  // namespace fourpost
