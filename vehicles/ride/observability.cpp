#include "vehicles/ride/observability.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "vehicles/condensed/linear_response.h"
#include "vehicles/description/element_list.h"
#include "vehicles/description/moved_points.h"
#include "vehicles/description/post_pattern.h"

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

struct Test {
  std::string name;
  /// One per post.
  std::vector<double> shape;
};

/// All posts in heave, pitch, roll and warp, as far as they can; each post alone where that leaves motions untried.
std::vector<Test> TestsOf(const Vehicle& vehicle) {
  std::vector<Test> tests;
  if (vehicle.posts.empty()) return tests;
  for (const std::string_view name : kPostPatterns) {
    try {
      tests.push_back({std::string(name), PostPattern(vehicle, name)});
    } catch (const std::invalid_argument&) {
      // These posts cannot make it.
    }
  }
  for (std::size_t i = 0; i < vehicle.posts.size() && tests.size() < vehicle.posts.size(); ++i) {
    std::vector<double> alone(vehicle.posts.size(), 0.0);
    alone[i] = 1;
    tests.push_back({vehicle.posts[i].name, alone});
  }
  return tests;
}

/// Per frequency, sensors x tests.
using Responses = std::vector<Eigen::MatrixXcd>;

class Observer {
 public:
  Observer(const Vehicle& vehicle, const CondensedVehicle& condensed, std::span<const double> parameters)
      : vehicle_(vehicle),
        condensed_(condensed),
        band_(Band()),
        tests_(TestsOf(vehicle)),
        values_(parameters.begin(), parameters.end()),
        shapes_(vehicle.posts.size(), tests_.size()) {
    for (std::size_t i = 0; i < tests_.size(); ++i)
      shapes_.col(static_cast<Eigen::Index>(i)) =
          Eigen::Map<const Eigen::VectorXd>(tests_[i].shape.data(), shapes_.rows());
    if (tests_.empty()) return;
    responses_ = ResponsesAt(values_);
    for (const Eigen::MatrixXcd& response : responses_) most_.push_back(MostOfKind(response));
  }

  ParameterView View(std::size_t parameter) const {
    ParameterView view{.parameter = vehicle_.parameters[parameter].name, .channels = {}};
    if (tests_.empty()) return view;
    const Eigen::MatrixXd sensitivity = Sensitivity(parameter);
    for (Eigen::Index i = 0; i < sensitivity.rows(); ++i) {
      Eigen::Index best = 0;
      const double most = sensitivity.row(i).maxCoeff(&best);
      if (most < kLeastSensitivity) continue;
      view.channels.push_back(
          {vehicle_.sensors[static_cast<std::size_t>(i)].name, tests_[static_cast<std::size_t>(best)].name, most});
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

  /// Sensors x tests.
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
  std::vector<Test> tests_;
  std::vector<double> values_;
  Eigen::MatrixXd shapes_;
  Responses responses_;
  /// Per frequency.
  std::vector<Eigen::VectorXd> most_;
};

}  // namespace

std::vector<ParameterView> ParameterViews(const Vehicle& vehicle, const CondensedVehicle& condensed,
                                          std::span<const double> parameters) {
  const Observer observer(vehicle, condensed, parameters);
  const std::vector<bool> are_in_curved_laws = AreInCurvedLaws(vehicle);
  const std::vector<bool> move_points = MovePoints(vehicle);
  std::vector<ParameterView> views;
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i)
    if (vehicle.parameters[i].upper > vehicle.parameters[i].lower) {
      views.push_back(observer.View(i));
      views.back().in_curved_law = are_in_curved_laws[i] || move_points[i];
    }
  return views;
}

}  // namespace fourpost
