#include "identify/plan/known_parameters.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "identify/run/run_spread.h"
#include "identify/uncertainty/output_spread.h"

namespace fourpost {
namespace {

/// In logarithms, as parameters that are like each other are.
void AddRatios(const Vehicle& vehicle, KnownParameters& known) {
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    const auto& like = vehicle.parameters[i].like;
    if (!like) continue;
    Eigen::VectorXd ratio = Eigen::VectorXd::Zero(std::ssize(known.places));
    for (std::size_t k = 0; k < known.places.size(); ++k)
      ratio[static_cast<Eigen::Index>(k)] =
          (known.places[k] == i ? 1 : 0) - (known.places[k] == vehicle.IndexOf(like->parameter) ? 1 : 0);
    known.information += ratio * ratio.transpose() / (like->sd * like->sd);
  }
}

}  // namespace

Eigen::MatrixXd InverseOf(const Eigen::MatrixXd& matrix) {
  return matrix.ldlt().solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

KnownParameters KnownByFit(const std::filesystem::path& run, const Vehicle& vehicle) {
  const RunSpread fitted = ReadRunSpread(run);
  const ParameterSpread& spread = fitted.parameters;
  KnownParameters known{
      .slopes = JudgedSlopes(spread), .information = InverseOf(spread.noise), .left_out = fitted.HeldText()};
  for (const Eigen::Index j : spread.judged)
    known.places.push_back(vehicle.IndexOf(spread.lattice.axes()[static_cast<std::size_t>(j)].name).value());
  return known;
}

KnownParameters KnownByRanges(const Vehicle& vehicle) {
  KnownParameters known;
  std::vector<double> slopes;
  std::vector<double> information;
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    const Parameter& parameter = vehicle.parameters[i];
    if (!(parameter.upper > parameter.lower)) continue;
    const double slope = parameter.lower > 0 ? parameter.value : parameter.upper - parameter.lower;
    const double width = parameter.lower > 0 ? std::log(parameter.upper / parameter.lower) : 1;
    double variance = width * width / 12;
    if (parameter.prior_sd) variance = std::min(variance, std::pow(*parameter.prior_sd / slope, 2));
    known.places.push_back(i);
    slopes.push_back(slope);
    information.push_back(1 / variance);
  }
  known.slopes = Eigen::Map<const Eigen::VectorXd>(slopes.data(), std::ssize(slopes));
  known.information = Eigen::Map<const Eigen::VectorXd>(information.data(), std::ssize(information)).asDiagonal();
  AddRatios(vehicle, known);
  return known;
}

}  // namespace fourpost
