#include "identify/search/lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

namespace fourpost {
namespace {

// Indices beyond 2^53 would not survive a double.
constexpr double kLargestCount = 9007199254740992.0;

// floor() with room for the rounding of the bounds: (0.3 - 0) / 0.1 is 2.9999999999999996.
double StepsInRange(const LatticeAxis& axis) {
  const double size = std::max({std::abs(axis.lower), std::abs(axis.upper), axis.upper - axis.lower});
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * size / axis.precision;
  return std::floor((axis.upper - axis.lower) / axis.precision + std::min(rounding, 0.5));
}

std::string AxisFault(const LatticeAxis& axis) {
  std::ostringstream fault;
  fault.precision(15);
  if (!std::isfinite(axis.lower) || !std::isfinite(axis.upper) || !std::isfinite(axis.upper - axis.lower)) {
    fault << "bounds " << axis.lower << " .. " << axis.upper << " are not finite";
  } else if (axis.lower == axis.upper) {
    fault << "lower and upper bound are both " << axis.lower << "; fix the parameter instead";
  } else if (axis.lower > axis.upper) {
    fault << "lower bound " << axis.lower << " is above upper bound " << axis.upper;
  } else if (!std::isfinite(axis.precision) || !(axis.precision > 0)) {
    fault << "precision " << axis.precision << " is not a positive number";
  } else if (StepsInRange(axis) < 1) {
    fault << "precision " << axis.precision << " exceeds the range " << axis.upper - axis.lower;
  } else if (StepsInRange(axis) >= kLargestCount) {
    fault << "precision " << axis.precision << " splits the range into more than 2^53 steps";
  }
  return fault.str();
}

}  // namespace

std::vector<std::string> LatticeFaults(const std::vector<LatticeAxis>& axes) {
  std::vector<std::string> faults;
  if (axes.empty()) faults.push_back("there is no parameter to search for");
  std::set<std::string> names;
  for (std::size_t j = 0; j < axes.size(); ++j) {
    const std::string& name = axes[j].name;
    const std::string label = name.empty() ? "parameter " + std::to_string(j + 1) : name;
    if (name.empty()) faults.push_back(label + ": has no name");
    if (!name.empty() && !names.insert(name).second) faults.push_back(label + ": is there twice");
    if (const std::string fault = AxisFault(axes[j]); !fault.empty()) faults.push_back(label + ": " + fault);
  }
  return faults;
}

Lattice::Lattice(std::vector<LatticeAxis> axes) : axes_(std::move(axes)) {
  std::string message;
  for (const std::string& fault : LatticeFaults(axes_)) message += (message.empty() ? "" : "\n") + fault;
  if (!message.empty()) throw std::invalid_argument(message);
  for (const LatticeAxis& axis : axes_) counts_.push_back(static_cast<std::int64_t>(StepsInRange(axis)) + 1);
}

bool Lattice::Contains(const LatticePoint& point) const {
  if (point.size() != size()) return false;
  for (std::size_t j = 0; j < size(); ++j) {
    if (point[j] < 1 || point[j] > counts_[j]) return false;
  }
  return true;
}

Eigen::VectorXd Lattice::Values(const LatticePoint& point) const {
  if (!Contains(point)) throw std::invalid_argument("the point is not on the lattice");
  Eigen::VectorXd values(static_cast<Eigen::Index>(size()));
  for (std::size_t j = 0; j < size(); ++j) {
    const double value = axes_[j].lower + static_cast<double>(point[j] - 1) * axes_[j].precision;
    values[static_cast<Eigen::Index>(j)] = std::min(value, axes_[j].upper);
  }
  return values;
}

LatticePoint Lattice::Nearest(const Eigen::VectorXd& values) const {
  if (values.size() != static_cast<Eigen::Index>(size())) {
    throw std::invalid_argument("expected " + std::to_string(size()) + " values, got " + std::to_string(values.size()));
  }
  LatticePoint point(size());
  for (std::size_t j = 0; j < size(); ++j) {
    const double steps = (values[static_cast<Eigen::Index>(j)] - axes_[j].lower) / axes_[j].precision;
    if (std::isnan(steps)) throw std::invalid_argument(axes_[j].name + ": the value is not a number");
    const double last = static_cast<double>(counts_[j] - 1);
    point[j] = static_cast<std::int64_t>(std::round(std::clamp(steps, 0.0, last))) + 1;
  }
  return point;
}

Eigen::VectorXd Lattice::RoundDiscrete(const Eigen::VectorXd& values) const {
  const Eigen::VectorXd on_lattice = Values(Nearest(values));
  Eigen::VectorXd rounded = values;
  for (std::size_t j = 0; j < size(); ++j) {
    const auto k = static_cast<Eigen::Index>(j);
    if (axes_[j].discrete) rounded[k] = on_lattice[k];
  }
  return rounded;
}

double LatticeDistance(const Lattice& lattice, const LatticePoint& a, const LatticePoint& b) {
  double distance = 0;
  for (std::size_t j = 0; j < lattice.size(); ++j) {
    const double steps = static_cast<double>(std::abs(a[j] - b[j]));
    distance = std::max(distance, steps / static_cast<double>(lattice.count(j) - 1));
  }
  return distance;
}

}  // namespace fourpost
