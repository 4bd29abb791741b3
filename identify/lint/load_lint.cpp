#include "identify/lint/load_lint.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "analysis/short_number.h"
#include "identify/covariance.h"
#include "identify/lint/channel_warnings.h"
#include "identify/robust_loss.h"
#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

/// Standard deviations. A load is so far off once in 16 000 of normal errors.
constexpr double kFarOff = 4;

/// Static loads of the fitted vehicle.
class FittedLoads {
 public:
  FittedLoads(const LoadedStudy& study, const FitResult& fit, const CondensedVehicle& condensed)
      : study_(study), fit_(fit), condensed_(condensed) {}

  /// [N], one per measured load.
  Eigen::VectorXd Modelled() const { return At(fit_.values); }

  Eigen::VectorXd Measured() const {
    Eigen::VectorXd loads(Count());
    for (Eigen::Index i = 0; i < Count(); ++i) loads[i] = Load(i).load_N;
    return loads;
  }

  Eigen::VectorXd Deviations() const {
    Eigen::VectorXd sd(Count());
    for (Eigen::Index i = 0; i < Count(); ++i) sd[i] = Load(i).sd_N;
    return sd;
  }

  /// Change of each load by one standard deviation of each free parameter [N].
  Eigen::MatrixXd Slopes() const {
    constexpr double kStep = 1e-3;
    Eigen::MatrixXd slopes(Count(), static_cast<Eigen::Index>(study_.free.size()));
    for (std::size_t i = 0; i < study_.free.size(); ++i) {
      const double sd = fit_.parameters[i].sd;
      std::vector<double> upper = fit_.values;
      std::vector<double> lower = fit_.values;
      upper[study_.free[i]] += kStep * sd;
      lower[study_.free[i]] -= kStep * sd;
      slopes.col(static_cast<Eigen::Index>(i)) = (At(upper) - At(lower)) / (2 * kStep);
    }
    return slopes;
  }

 private:
  Eigen::Index Count() const { return static_cast<Eigen::Index>(study_.data.static_loads.size()); }
  const MeasuredLoad& Load(Eigen::Index i) const { return study_.data.static_loads[static_cast<std::size_t>(i)]; }

  Eigen::VectorXd At(const std::vector<double>& values) const {
    const Preloads preloads = condensed_.PreloadsAt(values);
    Eigen::VectorXd loads(Count());
    for (Eigen::Index i = 0; i < Count(); ++i) loads[i] = preloads.tyre[Load(i).tyre];
    return loads;
  }

  const LoadedStudy& study_;
  const FitResult& fit_;
  const CondensedVehicle& condensed_;
};

/// What all loads add up to where the fit leaves them out [N].
struct WeightInMotion {
  double weight = 0;
  double sd = 0;
};

/// One step of Gauss and Newton's from the optimum without the loads' residuals. With S the deviations of the
/// parameters, R their correlations, and B the derivatives of the loads' residuals by p/S: the rest of the data has the
/// Hessian S^-1 (R^-1 - B'B) S^-1. Nothing where the rest does not tell the weight.
std::optional<WeightInMotion> WeightWithoutLoads(const FitResult& fit, const FittedLoads& loads) {
  const auto is_known = [](const FittedParameter& parameter) {
    return parameter.sd > 0 && std::isfinite(parameter.sd);
  };
  if (!fit.covariance || !std::all_of(fit.parameters.begin(), fit.parameters.end(), is_known)) return std::nullopt;
  const double inflation = fit.covariance->inflation;
  const Eigen::VectorXd residuals = (loads.Modelled() - loads.Measured()).cwiseQuotient(loads.Deviations());
  const RobustLoss& fitted = fit.options.refine.loss;
  const RobustLoss loss =
      fitted.kind() == LossKind::kNone ? RobustLoss() : RobustLoss(fitted.kind(), fitted.scale(), 0);
  // By deviations that are not inflated.
  const Eigen::MatrixXd slopes = loads.Slopes() / inflation;
  const Eigen::MatrixXd b = loads.Deviations().cwiseInverse().asDiagonal() * slopes;
  const Eigen::MatrixXd rest = Correlations(*fit.covariance).inverse() - b.transpose() * b;
  const Eigen::LDLT<Eigen::MatrixXd> solver(rest);
  constexpr double kUntold = 1e-9;
  if (!rest.allFinite() || solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > kUntold))
    return std::nullopt;
  const Eigen::VectorXd sum = slopes.colwise().sum();
  const Eigen::VectorXd step =
      solver.solve(b.transpose() * loss.Transformed(residuals).cwiseProduct(loss.Slopes(residuals)));
  return WeightInMotion{.weight = loads.Modelled().sum() + sum.dot(step),
                        .sd = inflation * std::sqrt(sum.dot(solver.solve(sum)))};
}

/// Corners that were weighed: a load of a planar car is the sum of two.
std::size_t Corners(const LoadedStudy& study) {
  std::size_t corners = 0;
  for (const auto& [tyre, source] : study.study.static_loads) corners += source.channels.size();
  return corners;
}

/// Whether it had something to tell.
bool LintWeight(const LoadedStudy& study, const FitResult& fit, const FittedLoads& loads, Diagnostics& diagnostics) {
  // Models miss forces in motion by more than deviations know. Right recordings of the Land Rover by Models 1 to 3: up
  // to 6.5 deviations, 5.8 %; with wheelpans weighed along on all posts: 8.9 and more, 5.3 %.
  constexpr double kFarOffHere = 8;
  constexpr double kFarOffShare = 0.03;
  const std::optional<WeightInMotion> motion = WeightWithoutLoads(fit, loads);
  if (!motion) return false;
  const double rest = loads.Measured().sum();
  const double more = rest - motion->weight;
  if (std::abs(more) < kFarOffShare * rest || std::abs(more) < kFarOffHere * motion->sd) return false;
  const std::size_t corners = Corners(study);
  const std::string each = ShortNumber(std::abs(more) / kGravity / static_cast<double>(corners), 2);
  diagnostics.Warning(
      study.study.static_loads_file->string(), 0,
      "the static loads add up to " + ShortNumber(rest / kGravity, 4) + " kg, forces in motion alone tell " +
          ShortNumber(motion->weight / kGravity, 4) + " kg (sd " + ShortNumber(motion->sd / kGravity, 2) + "): " +
          (more > 0 ? "some " + each + " kg on each of " + std::to_string(corners) +
                          " loads are weighed along or not tared, such as wheelpans: take them out of the values "
                          "there, or see whether the scale of the load cells in motion is right"
                    : "some " + each + " kg are missing on each of " + std::to_string(corners) +
                          " loads, or the scale of the load cells in motion is wrong"));
  return true;
}

std::string MassesAtBounds(const FitResult& fit) {
  std::string names;
  for (const FittedParameter& parameter : fit.parameters)
    if (parameter.at_bound && parameter.dimension == kMass) names += (names.empty() ? "" : ", ") + parameter.name;
  return names.empty() ? "" : " that hold masses (" + names + ")";
}

void LintEach(const LoadedStudy& study, const FitResult& fit, const FittedLoads& loads, Diagnostics& diagnostics) {
  // Less than a wheelpan, 5 %, and more than what friction in springs and dampers keeps a car at rest from settling by.
  constexpr double kSettled = 0.04;
  const double misfit = std::isfinite(fit.Misfit()) ? std::max(1.0, fit.Misfit()) : 1;
  const Eigen::VectorXd modelled = loads.Modelled();
  std::string text;
  std::string first;
  for (std::size_t i = 0; i < study.data.static_loads.size(); ++i) {
    const MeasuredLoad& load = study.data.static_loads[i];
    const double value = modelled[static_cast<Eigen::Index>(i)];
    const double off = std::abs(value - load.load_N);
    if (off <= kFarOff * misfit * load.sd_N || off <= kSettled * load.load_N) continue;
    const std::string& name = study.vehicle.tyres[load.tyre].name;
    if (first.empty()) first = name;
    text += (text.empty() ? "'" : ", '") + name + "' carries " + ShortNumber(value, 4) + " N for the measured " +
            ShortNumber(load.load_N, 4) + " N (" + ShortNumber(off / load.sd_N, 2) + " standard deviations off)";
  }
  if (text.empty()) return;
  ChannelWarnings(study.study.file.string(), study.study.static_loads, diagnostics)
      .AddAt(first, text +
                        ", at rest after the fit: a load cell not tared, a wheelpan or a load weighed along, bounds" +
                        MassesAtBounds(fit) +
                        " that leave the answer out, an sd that is too small, or other channels that pull the masses "
                        "away for what the model lacks");
}

}  // namespace

void LintLoads(const LoadedStudy& study, const FitResult& fit, const CondensedVehicle& condensed,
               Diagnostics& diagnostics) {
  if (study.data.static_loads.empty()) return;
  const FittedLoads loads(study, fit, condensed);
  if (!LintWeight(study, fit, loads, diagnostics)) LintEach(study, fit, loads, diagnostics);
}

}  // namespace fourpost
