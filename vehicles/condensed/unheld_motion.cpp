#include "vehicles/condensed/unheld_motion.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "vehicles/condensed/preload_map.h"

namespace fourpost {
namespace {

void Append(const Eigen::VectorXd& column, Eigen::MatrixXd& matrix) {
  matrix.conservativeResize(column.size(), matrix.cols() + 1);
  matrix.rightCols<1>() = column;
}

bool IsPreload(const GivenForce& force) { return force.kind == GivenForce::Kind::kPreload && force.carries; }

/// Orthonormal columns.
Eigen::MatrixXd FeltByNone(const StaticLoads& loads) {
  Eigen::MatrixXd preloads = loads.holders;
  for (const GivenForce& force : loads.forces)
    if (IsPreload(force)) Append(force.direction, preloads);
  const Eigen::Index n = preloads.rows();
  if (preloads.cols() == 0) return Eigen::MatrixXd::Identity(n, n);
  const SingularValues svd = SingularValuesOf(preloads, SingularValues::kLeft);
  const Eigen::VectorXd& sizes = svd.values;
  return svd.left.rightCols(n - (sizes.array() > kHeldShare * std::max(1.0, sizes[0])).count());
}

/// Z' w of the forces that act in the motions Z.
Eigen::MatrixXd Acting(const std::vector<GivenForce>& forces, const Eigen::MatrixXd& motions) {
  Eigen::MatrixXd acting(motions.cols(), 0);
  for (const GivenForce& force : forces) {
    const Eigen::VectorXd share = motions.transpose() * force.Force();
    if (!IsPreload(force) && share.norm() > kHeldShare * force.Force().norm()) Append(share, acting);
  }
  return acting;
}

/// Z (Z' M Z)^-1 Z' w, as columns of unit energy without common energy.
Eigen::MatrixXd Released(const StaticLoads& loads, const Eigen::MatrixXd& motions) {
  // A released motion of a millionth of the energy is not one by itself; far above the rounding of eigenvalues.
  constexpr double kOfItsOwn = 1e-6;
  const Eigen::MatrixXd acting = Acting(loads.forces, motions);
  if (acting.size() == 0) return {motions.rows(), 0};
  const Eigen::MatrixXd moved = EnergyRows(loads.links, motions.rows()) * motions;
  const Eigen::MatrixXd mass = moved.transpose() * moved;
  const Eigen::MatrixXd accelerations = LeastNorm(mass).Solve(acting);
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(acting.transpose() * accelerations);
  const Eigen::VectorXd& energies = pairs.values;
  const Eigen::Index count = (energies.array() > kOfItsOwn * kOfItsOwn * energies.maxCoeff()).count();
  return motions * accelerations * pairs.vectors.rightCols(count) *
         energies.tail(count).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// Whether the forces do work together, and not each only what another one takes.
bool DoWork(const std::vector<GivenForce>& forces, const Eigen::VectorXd& shape) {
  constexpr double kTyped = 1e-6;  // as for preloads of seven digits
  double sum = 0;
  double all = 0;
  for (const GivenForce& force : forces) {
    if (IsPreload(force)) continue;
    const double work = force.Force().dot(shape);
    sum += work;
    all += std::abs(work);
  }
  return std::abs(sum) > kTyped * all;
}

/// Names of links whose numbers are about the greatest: mirror images, but for what is added to one side.
std::vector<std::string> Greatest(const std::vector<LinkMotion>& links, const Eigen::VectorXd& numbers) {
  constexpr double kAbout = 0.9;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (numbers[static_cast<Eigen::Index>(i)] >= kAbout * numbers.maxCoeff()) names.push_back(links[i].name);
  return names;
}

/// Of each link: of its centre of mass [m], or its turn [rad] where that is more.
Eigen::VectorXd Speeds(const std::vector<LinkMotion>& links, const Eigen::VectorXd& shape) {
  Eigen::VectorXd speeds(links.size());
  for (std::size_t i = 0; i < links.size(); ++i)
    speeds[static_cast<Eigen::Index>(i)] =
        std::max((links[i].com_jacobian * shape).norm(), (links[i].spin_jacobian * shape).norm());
  return speeds;
}

std::vector<IdleElement> Moved(const StaticLoads& loads, const Eigen::VectorXd& shape) {
  constexpr double kHand = 0.1;
  std::vector<IdleElement> moved;
  const double speed = Speeds(loads.links, shape).maxCoeff();
  for (const IdleElement& element : loads.idle)
    if (std::abs(element.direction.dot(shape)) > kHand * speed) moved.push_back(element);
  return moved;
}

UnheldMotion Described(const StaticLoads& loads, const NamedMotion& motion) {
  const Eigen::VectorXd moved = EnergyRows(loads.links, motion.shape.size()) * motion.shape;
  const auto direction = static_cast<Eigen::Index>(motion.direction);
  const Eigen::VectorXd energies = moved.reshaped(6, loads.links.size()).row(direction).cwiseAbs2();
  return {.motion = motion,
          .alike = Greatest(loads.links, energies),
          .fastest = Greatest(loads.links, Speeds(loads.links, motion.shape)),
          .idle = Moved(loads, motion.shape)};
}

}  // namespace

/// tension(x) = preload + Force(x) is zero at x = free length - length; Force rises with x but for knees that soften.
std::optional<double> GivenForce::FreeSpring::FreeLengthFor(double preload) const {
  constexpr double kLongest_m = 100;
  double low = -length;
  double high = kLongest_m;
  const auto tension = [&](double x) { return preload + law.Force(x); };
  if (!(tension(low) < 0 && tension(high) >= 0)) return std::nullopt;
  for (double middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high))
    (tension(middle) < 0 ? low : high) = middle;
  return length + high;
}

std::vector<UnheldMotion> UnheldMotions(const StaticLoads& loads) {
  std::vector<NamedMotion> motions = NameMotions(loads.links, Released(loads, FeltByNone(loads)));
  const auto falls = [&](const NamedMotion& motion) { return DoWork(loads.forces, motion.shape); };
  if (std::any_of(motions.begin(), motions.end(), falls)) std::erase_if(motions, std::not_fn(falls));
  std::vector<UnheldMotion> unheld;
  for (const NamedMotion& motion : motions) unheld.push_back(Described(loads, motion));
  return unheld;
}

}  // namespace fourpost
