#include "vehicles/observability.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "vehicles/linear_response.h"

namespace fourpost {
namespace {

constexpr double kLowest_Hz = 0.5;
constexpr double kHighest_Hz = 30;
/// Share of H_most below which a channel gains nothing by reading less.
constexpr double kFloor = 0.2;
/// Per metre of the posts, in SI units of any sensor: rounding, and below any transducer.
constexpr double kNothing = 1e-6;
/// Ten an octave: modes on a vehicle are wider.
constexpr int kFrequencies = 60;

std::vector<double> Band() {
  std::vector<double> band;
  for (int i = 0; i < kFrequencies; ++i)
    band.push_back(kLowest_Hz * std::pow(kHighest_Hz / kLowest_Hz, i / (kFrequencies - 1.0)));
  return band;
}

struct PostPattern {
  const char* name;
  /// One per post, largest 1.
  Eigen::VectorXd shape;
};

/// Heave, and of pitch, roll and warp those that the places of the posts allow.
std::vector<PostPattern> PostPatterns(const Vehicle& vehicle, const Kinematics& pose) {
  const auto posts = static_cast<Eigen::Index>(vehicle.posts.size());
  Eigen::MatrixXd place(posts, 2);
  for (Eigen::Index i = 0; i < posts; ++i) {
    const int tyre = vehicle.posts[static_cast<std::size_t>(i)].tyre;
    place.row(i) = pose.Location(vehicle.tyres[static_cast<std::size_t>(tyre)].point).head<2>();
  }
  if (posts > 0) place.rowwise() -= place.colwise().mean().eval();
  const std::vector<PostPattern> all = {{"heave", Eigen::VectorXd::Ones(posts)},
                                        {"pitch", place.col(0)},
                                        {"roll", place.col(1)},
                                        {"warp", place.col(0).cwiseProduct(place.col(1))}};
  // Centimetres between posts, or between products of theirs: no pattern of its own.
  constexpr double kSamePlace = 0.01;
  std::vector<PostPattern> patterns;
  for (const PostPattern& pattern : all) {
    Eigen::VectorXd rest = pattern.shape;
    for (const PostPattern& other : patterns) rest -= rest.dot(other.shape) / other.shape.squaredNorm() * other.shape;
    if (posts == 0 || rest.lpNorm<Eigen::Infinity>() < kSamePlace) continue;
    patterns.push_back({pattern.name, rest / rest.lpNorm<Eigen::Infinity>()});
  }
  return patterns;
}

/// Per frequency, sensors x patterns.
using Responses = std::vector<Eigen::MatrixXcd>;

class Observer {
 public:
  Observer(const Vehicle& vehicle, const CondensedVehicle& condensed, const Kinematics& pose,
           std::span<const double> parameters)
      : vehicle_(vehicle),
        condensed_(condensed),
        band_(Band()),
        patterns_(PostPatterns(vehicle, pose)),
        values_(parameters.begin(), parameters.end()),
        shapes_(vehicle.posts.size(), patterns_.size()) {
    for (std::size_t i = 0; i < patterns_.size(); ++i) shapes_.col(static_cast<Eigen::Index>(i)) = patterns_[i].shape;
    responses_ = ResponsesAt(values_);
    for (const Eigen::MatrixXcd& response : responses_) most_.push_back(MostOfKind(response));
  }

  ParameterView View(std::size_t parameter) const {
    ParameterView view{.parameter = vehicle_.parameters[parameter].name};
    if (patterns_.empty()) return view;
    const Eigen::MatrixXd sensitivity = Sensitivity(parameter);
    for (Eigen::Index i = 0; i < sensitivity.rows(); ++i) {
      Eigen::Index best = 0;
      const double most = sensitivity.row(i).maxCoeff(&best);
      if (most < kLeastSensitivity) continue;
      view.channels.push_back(
          {vehicle_.sensors[static_cast<std::size_t>(i)].name, patterns_[static_cast<std::size_t>(best)].name, most});
    }
    // Sides of a symmetric car differ by rounding, which shall not order them.
    const auto rank = [](const ParameterView::Channel& channel) { return std::lround(1e4 * channel.sensitivity); };
    std::stable_sort(view.channels.begin(), view.channels.end(),
                     [&](const auto& a, const auto& b) { return rank(a) > rank(b); });
    return view;
  }

 private:
  Responses ResponsesAt(std::span<const double> values) const {
    const CondensedModel model = condensed_.At(values);
    Responses responses;
    for (const double frequency : band_) responses.push_back(LinearResponse(model, frequency) * shapes_);
    return responses;
  }

  /// Of each sensor, H_most of its kind, see ParameterView.
  Eigen::VectorXd MostOfKind(const Eigen::MatrixXcd& response) const {
    std::map<Sensor::Type, double> most;
    for (Eigen::Index i = 0; i < response.rows(); ++i)
      most[TypeOf(i)] = std::max(most[TypeOf(i)], response.row(i).cwiseAbs().maxCoeff());
    Eigen::VectorXd of_sensor(response.rows());
    for (Eigen::Index i = 0; i < of_sensor.size(); ++i) of_sensor[i] = most[TypeOf(i)];
    return of_sensor;
  }

  Sensor::Type TypeOf(Eigen::Index sensor) const { return vehicle_.sensors[static_cast<std::size_t>(sensor)].type; }

  /// Sensors x patterns.
  Eigen::MatrixXd Sensitivity(std::size_t index) const {
    const Parameter& parameter = vehicle_.parameters[index];
    const double size = std::max(std::abs(values_[index]), 0.5 * (parameter.upper - parameter.lower));
    // The error of central differences is about its square, rounding 1e-16 over it times the condition of H.
    constexpr double kStep = 1e-4;
    std::vector<double> below = values_;
    std::vector<double> above = values_;
    below[index] = std::max(parameter.lower, values_[index] - kStep * size);
    above[index] = std::min(parameter.upper, values_[index] + kStep * size);
    const double share = (above[index] - below[index]) / size;
    const Responses low = ResponsesAt(below);
    const Responses high = ResponsesAt(above);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(responses_.front().rows(), responses_.front().cols());
    for (std::size_t f = 0; f < band_.size(); ++f)
      for (Eigen::Index i = 0; i < sum.rows(); ++i)
        for (Eigen::Index j = 0; j < sum.cols(); ++j) {
          if (most_[f][i] < kNothing) continue;
          const double reading = std::hypot(std::abs(responses_[f](i, j)), kFloor * most_[f][i]);
          sum(i, j) += std::abs(high[f](i, j) - low[f](i, j)) / (share * reading);
        }
    return sum / static_cast<double>(band_.size());
  }

  const Vehicle& vehicle_;
  const CondensedVehicle& condensed_;
  std::vector<double> band_;
  std::vector<PostPattern> patterns_;
  std::vector<double> values_;
  Eigen::MatrixXd shapes_;
  Responses responses_;
  /// Per frequency.
  std::vector<Eigen::VectorXd> most_;
};

}  // namespace

std::vector<ParameterView> ParameterViews(const Vehicle& vehicle, const CondensedVehicle& condensed,
                                          const Kinematics& pose, std::span<const double> parameters) {
  const Observer observer(vehicle, condensed, pose, parameters);
  std::vector<ParameterView> views;
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i)
    if (vehicle.parameters[i].upper > vehicle.parameters[i].lower) views.push_back(observer.View(i));
  return views;
}

}  // namespace fourpost
