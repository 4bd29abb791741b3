#pragma once

#include <cmath>
#include <functional>
#include <stdexcept>

#include <Eigen/Dense>

/// A position solver for linkages that shares nothing with the program: a body's place is x + exp(w) p, and Newton's
/// method with differences finds the (x, w) at which all lengths are as drawn.
namespace newton {

using Vec = Eigen::Vector3d;

struct Place {
  Vec shift = Vec::Zero();
  Vec turn = Vec::Zero();

  Eigen::Matrix3d Rotation() const {
    const double angle = turn.norm();
    if (angle == 0) return Eigen::Matrix3d::Identity();
    const Vec axis = turn / angle;
    Eigen::Matrix3d cross;
    cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
    return Eigen::Matrix3d::Identity() + std::sin(angle) * cross + (1 - std::cos(angle)) * cross * cross;
  }
  /// Where a point, drawn at `p`, has gone.
  Vec operator()(const Vec& p) const { return shift + Rotation() * p; }
};

using Errors = std::function<Eigen::VectorXd(const Place&)>;

/// As many equations as there are unknowns, six.
inline Place Solve(const Errors& errors, Place place = {}) {
  const auto at = [](const Eigen::VectorXd& x) { return Place{x.head<3>(), x.tail<3>()}; };
  Eigen::VectorXd x(6);
  x << place.shift, place.turn;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const Eigen::VectorXd error = errors(at(x));
    if (error.lpNorm<Eigen::Infinity>() < 1e-14) return at(x);
    Eigen::MatrixXd jacobian(error.size(), 6);
    for (int i = 0; i < 6; ++i) {
      const Eigen::VectorXd step = 1e-6 * Eigen::VectorXd::Unit(6, i);
      jacobian.col(i) = (errors(at(x + step)) - errors(at(x - step))) / 2e-6;
    }
    const Eigen::VectorXd change = jacobian.fullPivLu().solve(error);
    x -= change;
    if (change.lpNorm<Eigen::Infinity>() < 1e-15) return at(x);
  }
  const Eigen::VectorXd last = errors(at(x));
  if (last.lpNorm<Eigen::Infinity>() < 1e-12) return at(x);
  throw std::runtime_error("no position found");
}

/// Error of a length between a fixed point and one of the body.
inline double Rod(const Place& place, const Vec& fixed, const Vec& moving) {
  return (place(moving) - fixed).norm() - (moving - fixed).norm();
}

}  // namespace newton
