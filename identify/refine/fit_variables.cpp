#include "identify/refine/fit_variables.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "analysis/text/option_check.h"

namespace fourpost {

FitVariables::FitVariables(const Lattice& lattice) {
  const auto size = static_cast<Eigen::Index>(lattice.size());
  for (Eigen::VectorXd* vector : {&lower_, &upper_, &lower_x_, &upper_x_}) vector->resize(size);
  for (Eigen::Index j = 0; j < size; ++j) {
    const LatticeAxis& axis = lattice.axes()[static_cast<std::size_t>(j)];
    names_.push_back(axis.name);
    lower_[j] = axis.lower;
    upper_[j] = axis.upper;
    lower_x_[j] = Forward(j, axis.lower);
    upper_x_[j] = Forward(j, axis.upper);
  }
}

Eigen::VectorXd FitVariables::FromValues(const Eigen::VectorXd& values) const {
  RequireOption(values.size() == size(), "number of values", values.size(), std::to_string(size()));
  Eigen::VectorXd x(size());
  for (Eigen::Index j = 0; j < size(); ++j) {
    std::ostringstream bound;
    bound << "in [" << lower_[j] << ", " << upper_[j] << "]";
    RequireOption(values[j] >= lower_[j] && values[j] <= upper_[j], names_[static_cast<std::size_t>(j)], values[j],
                  bound.str());
    x[j] = Forward(j, values[j]);
  }
  return x;
}

Eigen::VectorXd FitVariables::ToValues(const Eigen::VectorXd& x) const {
  Eigen::VectorXd values(size());
  for (Eigen::Index j = 0; j < size(); ++j) values[j] = Backward(j, x[j]);
  return values;
}

Eigen::VectorXd FitVariables::Slopes(const Eigen::VectorXd& values) const {
  Eigen::VectorXd slopes(size());
  for (Eigen::Index j = 0; j < size(); ++j) slopes[j] = is_logarithmic(j) ? values[j] : upper_[j] - lower_[j];
  return slopes;
}

double FitVariables::Forward(Eigen::Index j, double value) const {
  return is_logarithmic(j) ? std::log(value) : (value - lower_[j]) / (upper_[j] - lower_[j]);
}

double FitVariables::Backward(Eigen::Index j, double x) const {
  if (x <= lower_x_[j]) return lower_[j];
  if (x >= upper_x_[j]) return upper_[j];
  const double value = is_logarithmic(j) ? std::exp(x) : lower_[j] + x * (upper_[j] - lower_[j]);
  return std::clamp(value, lower_[j], upper_[j]);
}

}  // namespace fourpost
