#include "vehicles/condensed/linear_vehicle.h"

#include <Eigen/Cholesky>

namespace fourpost {

Eigen::MatrixXd DashpotDirections(const CondensedModel& model) {
  const Eigen::Index n = model.mass.rows();
  const auto series = static_cast<Eigen::Index>(model.SeriesDampers().size());
  Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(n + series, static_cast<Eigen::Index>(model.dashpots.size()));
  Eigen::Index x = n;
  for (Eigen::Index j = 0; j < directions.cols(); ++j) {
    const CondensedModel::Dashpot& dashpot = model.dashpots[static_cast<std::size_t>(j)];
    directions.col(j).head(n) = dashpot.direction;
    if (dashpot.HasSeries()) directions(x++, j) = -1;
  }
  return directions;
}

LinearVehicle::LinearVehicle(const CondensedModel& model, Rates rates) : mass(model.mass) {
  const Eigen::MatrixXd directions = DashpotDirections(model);
  const Eigen::Index n = mass.rows();
  const Eigen::Index size = directions.rows();
  damping.setZero(size, size);
  stiffness.setZero(size, size);
  damping.topLeftCorner(n, n) = model.damping;
  stiffness.topLeftCorner(n, n) = model.stiffness;
  Eigen::Index x = n;
  for (Eigen::Index j = 0; j < directions.cols(); ++j) {
    const CondensedModel::Dashpot& dashpot = model.dashpots[static_cast<std::size_t>(j)];
    const double rate = rates == Rates::kMean ? dashpot.law.MeanRate() : dashpot.CentreRate();
    damping.noalias() += (rate * directions.col(j)) * directions.col(j).transpose();
    if (!dashpot.HasSeries()) continue;
    stiffness(x, x) = dashpot.series.Slope(0);
    ++x;
  }
}

Eigen::MatrixXcd LinearVehicle::Impedance(double omega) const {
  const Eigen::Index n = mass.rows();
  Eigen::MatrixXcd impedance(size(), size());
  impedance.real() = stiffness;
  impedance.imag() = omega * damping;
  impedance.topLeftCorner(n, n).real() -= omega * omega * mass;
  return impedance;
}

// x' follows from its own balance: damping_xx is diagonal, each series spring has its dashpot.
Eigen::MatrixXd LinearVehicle::StateMatrix() const {
  const Eigen::Index n = mass.rows();
  const Eigen::Index m = series();
  Eigen::MatrixXd rest = Eigen::MatrixXd::Zero(size(), 2 * n + m);  // of the forces, by [s, s', x]
  rest.leftCols(n) = -stiffness.leftCols(n);
  rest.middleCols(n, n) = -damping.leftCols(n);
  rest.rightCols(m) = -stiffness.rightCols(m);
  Eigen::MatrixXd matrix = StateInput(rest);
  matrix.block(0, n, n, n).setIdentity();
  return matrix;
}

Eigen::MatrixXd LinearVehicle::StateInput(const Eigen::MatrixXd& forces) const {
  const Eigen::Index n = mass.rows();
  const Eigen::Index m = series();
  Eigen::MatrixXd input = Eigen::MatrixXd::Zero(2 * n + m, forces.cols());
  const Eigen::VectorXd rates = damping.diagonal().tail(m).cwiseInverse();
  input.bottomRows(m) = rates.asDiagonal() * forces.bottomRows(m);
  input.middleRows(n, n) = mass.ldlt().solve(forces.topRows(n) - damping.topRightCorner(n, m) * input.bottomRows(m));
  return input;
}

}  // namespace fourpost
