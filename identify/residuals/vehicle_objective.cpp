#include "identify/residuals/vehicle_objective.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "analysis/text/option_check.h"

namespace fourpost {

VehicleObjective::VehicleObjective(Vehicle vehicle, std::vector<std::size_t> free, std::vector<ResidualBlock> blocks,
                                   std::vector<Calibration> calibrations)
    : vehicle_(std::move(vehicle)),
      free_(std::move(free)),
      blocks_(std::move(blocks)),
      calibrations_(std::move(calibrations)) {
  CollectPriors();
  residual_count_ = prior_count();
  for (const ResidualBlock& block : blocks_) {
    residual_count_ += block.count;
    for (const ResidualSeries& series : block.structure.series) unmeasured_count_ += series.unmeasured;
  }
}

double VehicleObjective::Prior::At(const std::vector<double>& all) const {
  return other ? std::log(all[parameter] / all[*other]) : all[parameter];
}

double VehicleObjective::Prior::SlopeBy(std::size_t index, const std::vector<double>& all) const {
  if (index == parameter) return other ? 1 / all[parameter] : 1;
  return other == index ? -1 / all[index] : 0;
}

void VehicleObjective::CollectPriors() {
  const auto is_free = [&](std::size_t i) { return std::find(free_.begin(), free_.end(), i) != free_.end(); };
  const auto add = [&](Prior prior, const std::string& name) {
    RequireOption(prior.sd > 0 && std::isfinite(prior.sd), name, prior.sd, "positive and finite");
    prior.value = prior.At(vehicle_.ParameterValues());
    priors_.push_back(prior);
  };
  for (const std::size_t i : free_)
    if (const Parameter& parameter = vehicle_.parameters[i]; parameter.prior_sd)
      add({.parameter = i, .sd = *parameter.prior_sd}, "prior_sd of " + parameter.name);
  for (std::size_t i = 0; i < vehicle_.parameters.size(); ++i) {
    const Parameter& parameter = vehicle_.parameters[i];
    if (!parameter.like) continue;
    const std::optional<std::size_t> other = vehicle_.IndexOf(parameter.like->parameter);
    if (other && (is_free(i) || is_free(*other)))
      add({.parameter = i, .other = other, .sd = parameter.like->sd}, "like_sd of " + parameter.name);
  }
}

Problem VehicleObjective::MakeProblem() const {
  std::vector<LatticeAxis> axes;
  for (const std::size_t index : free_) {
    const Parameter& parameter = vehicle_.parameters[index];
    axes.push_back({parameter.name, parameter.lower, parameter.upper, parameter.precision});
  }
  Problem problem{.lattice = Lattice(std::move(axes)),
                  .evaluate = [this](const Eigen::VectorXd& values,
                                     const Deadline& deadline) { return Evaluate(values, deadline); },
                  .residual_count = residual_count_};
  for (const ResidualBlock& block : blocks_) problem.accuracy = std::max(problem.accuracy, block.accuracy);
  const auto differentiates = [](const ResidualBlock& block) { return static_cast<bool>(block.differentiate); };
  if (std::all_of(blocks_.begin(), blocks_.end(), differentiates))
    problem.differentiate = [this](const Eigen::VectorXd& values) { return Jacobian(values); };
  return problem;
}

std::optional<VehicleObjective> VehicleObjective::Coarse() const {
  std::vector<ResidualBlock> blocks;
  bool is_coarser = false;
  for (const ResidualBlock& block : blocks_) {
    if (!block.coarse && !block.is_cheap) return std::nullopt;
    blocks.push_back(block.coarse ? *block.coarse : block);
    is_coarser = is_coarser || block.coarse;
  }
  if (!is_coarser) return std::nullopt;
  return VehicleObjective(vehicle_, free_, std::move(blocks), calibrations_);
}

Eigen::MatrixXd VehicleObjective::Jacobian(const Eigen::VectorXd& values) const {
  const std::vector<double> all = AllParameters(values);
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(residual_count_, values.size());
  Eigen::Index first = 0;
  for (const ResidualBlock& block : blocks_) {
    jacobian.middleRows(first, block.count) = block.differentiate(all, free_);
    first += block.count;
  }
  for (const Prior& prior : priors_) {
    for (std::size_t j = 0; j < free_.size(); ++j)
      jacobian(first, static_cast<Eigen::Index>(j)) = prior.SlopeBy(free_[j], all) / prior.sd;
    ++first;
  }
  return jacobian;
}

std::vector<double> VehicleObjective::AllParameters(const Eigen::VectorXd& values) const {
  std::vector<double> all = vehicle_.ParameterValues();
  for (std::size_t i = 0; i < free_.size(); ++i) all[free_[i]] = values[static_cast<Eigen::Index>(i)];
  return all;
}

Eigen::VectorXd VehicleObjective::FileValues() const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(free_.size()));
  for (std::size_t i = 0; i < free_.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = vehicle_.parameters[free_[i]].value;
  return values;
}

Evaluation VehicleObjective::Evaluate(const Eigen::VectorXd& values, const Deadline& deadline) const {
  const std::vector<double> all = AllParameters(values);
  Evaluation whole;
  whole.residuals.resize(residual_count_);
  Eigen::Index first = 0;
  for (const ResidualBlock& block : blocks_) {
    Evaluation part = block.evaluate(all, deadline);
    if (!part.ok()) return part;
    if (part.residuals.size() != block.count)
      return Failed(Failure::kWrongSize, block.name + " gave " + std::to_string(part.residuals.size()) +
                                             " residuals in place of " + std::to_string(block.count));
    whole.residuals.segment(first, block.count) = part.residuals;
    first += block.count;
  }
  whole.residuals.tail(prior_count()) = PriorResiduals(values);
  return whole;
}

Eigen::VectorXd VehicleObjective::PriorResiduals(const Eigen::VectorXd& values) const {
  const std::vector<double> all = AllParameters(values);
  Eigen::VectorXd residuals(prior_count());
  double* out = residuals.data();
  for (const Prior& prior : priors_) *out++ = (prior.At(all) - prior.value) / prior.sd;
  return residuals;
}

}  // namespace fourpost
