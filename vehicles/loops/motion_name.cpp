#include "vehicles/loops/motion_name.h"

#include <array>
#include <cmath>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

/// The part of the basis that moves mass, its columns of unit energy and without common energy.
Eigen::MatrixXd Whitened(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& basis) {
  const Eigen::MatrixXd moved = rows * basis;
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(moved.transpose() * moved);
  const Eigen::VectorXd& energy = pairs.values;
  // Rounding of sums of squares.
  constexpr double kMassless = 1e-12;
  const Eigen::Index massless = (energy.array() <= kMassless * energy.maxCoeff()).count();
  const Eigen::Index kept = energy.size() - massless;
  return basis * pairs.vectors.rightCols(kept) * energy.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// Orthonormal columns at right angles to a vector.
Eigen::MatrixXd Across(const Eigen::VectorXd& vector) {
  return SymmetricEigenpairsOf(vector * vector.transpose()).vectors.leftCols(vector.size() - 1);
}

}  // namespace

std::vector<LinkMotion> LinkMotionsOf(const Vehicle& vehicle, const Kinematics& pose) {
  const std::vector<double> values = vehicle.ParameterValues();
  std::vector<LinkMotion> motions;
  for (std::size_t i = 1; i < vehicle.links.size(); ++i) {
    const Link& link = vehicle.links[i];
    const int index = static_cast<int>(i);
    const Point com{index, link.ComAt(values)};
    const auto moment = [&](std::size_t k) { return link.inertia[k].At(values); };
    motions.push_back({.name = link.name,
                       .mass = link.mass.At(values),
                       .inertia = {moment(0), moment(1), moment(2)},
                       .com = pose.Location(com),
                       .com_jacobian = pose.PointJacobian(com),
                       .spin_jacobian = pose.Rotation(index).transpose() * pose.AngularJacobian(index)});
  }
  return motions;
}

Eigen::MatrixXd EnergyRows(const std::vector<LinkMotion>& links, Eigen::Index coordinates) {
  Eigen::MatrixXd rows(6 * links.size(), coordinates);
  Eigen::Index row = 0;
  for (const LinkMotion& link : links) {
    rows.middleRows<3>(row) = std::sqrt(link.mass) * link.com_jacobian;
    rows.middleRows<3>(row + 3) = link.inertia.cwiseMax(0).cwiseSqrt().asDiagonal() * link.spin_jacobian;
    row += 6;
  }
  return rows;
}

std::string Word(NamedMotion::Direction direction) {
  constexpr std::array<const char*, 6> kWords = {"fore-aft motion", "lateral motion", "heave", "roll", "pitch", "yaw"};
  return kWords[static_cast<std::size_t>(direction)];
}

std::string NamedMotion::Text() const { return Word(direction) + " of link '" + link + "'"; }

std::vector<NamedMotion> NameMotions(const std::vector<LinkMotion>& links, Eigen::MatrixXd basis) {
  std::vector<NamedMotion> motions;
  if (basis.cols() == 0 || links.empty()) return motions;
  const Eigen::MatrixXd rows = EnergyRows(links, basis.rows());
  basis = Whitened(rows, basis);
  while (basis.cols() > 0) {
    const Eigen::MatrixXd moved = rows * basis;
    Eigen::Index most = 0;
    moved.rowwise().squaredNorm().maxCoeff(&most);
    const Eigen::VectorXd share = moved.row(most).transpose();
    motions.push_back({.link = links[static_cast<std::size_t>(most / 6)].name,
                       .direction = static_cast<NamedMotion::Direction>(most % 6),
                       .shape = basis * share.normalized()});
    basis = (basis * Across(share)).eval();
  }
  return motions;
}

}  // namespace fourpost
