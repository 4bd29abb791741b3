#include "vehicles/equilibrium.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "analysis/number.h"

namespace fourpost {
namespace {

constexpr const char* kHolder = R"(spring, tyre or bushing with preload="equilibrium")";

/// The part of a generalised force that no combination of the columns can take.
Eigen::VectorXd Rest(const Eigen::VectorXd& force, const Eigen::MatrixXd& columns) {
  return force + columns * (PreloadMap(columns) * force);
}

/// Directions are exact to rounding: projections leave about 1e-15 of them, and what nothing holds leaves a share that
/// the geometry sets, centimetres in metres at the least.
bool IsHeld(const Eigen::VectorXd& direction, const Eigen::MatrixXd& columns) {
  constexpr double kRounding = 1e-9;
  return Rest(direction, columns).norm() <= kRounding * direction.norm();
}

Eigen::MatrixXd WithPreloads(Eigen::MatrixXd columns, const std::vector<GivenForce>& forces) {
  for (const GivenForce& force : forces) {
    if (force.kind != GivenForce::Kind::kPreload) continue;
    columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
    columns.rightCols<1>() = force.direction;
  }
  return columns;
}

/// Whether what the file gives is balanced at the file's values.
bool IsBalanced(const std::vector<GivenForce>& forces, const Eigen::MatrixXd& holders) {
  // Preloads may be typed with seven digits: that leaves the vehicle within 1e-6 of its static deflection, decimetres.
  constexpr double kTyped = 1e-6;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(holders.rows());
  double scale = 0;
  for (const GivenForce& force : forces) {
    sum += force.size * force.direction;
    scale += (force.size * force.direction).norm();
  }
  return Rest(sum, holders).norm() <= kTyped * scale;
}

/// To a thousandth of a newton.
std::string RoundedText(double force) { return FormatNumber(std::round(force * 1e3) / 1e3 + 0.0); }

/// Links that nothing can hold; if there is none, the given preloads, of which one at least must be wrong.
void ReportImbalance(const Vehicle& vehicle, const std::vector<GivenForce>& forces, const Eigen::MatrixXd& holders,
                     Diagnostics& faults) {
  const Eigen::MatrixXd all = WithPreloads(holders, forces);
  bool reported = false;
  for (const GivenForce& force : forces) {
    if (force.kind != GivenForce::Kind::kWeight || force.size == 0 || IsHeld(force.direction, all)) continue;
    faults.Error(vehicle.file, force.line,
                 std::string("no static equilibrium: no ") + kHolder + " can hold the weight of " + force.element +
                     "; add one under it or fix a joint");
    reported = true;
  }
  if (reported) return;
  for (const GivenForce& force : forces)
    if (force.kind == GivenForce::Kind::kPreload && !IsHeld(force.direction, holders))
      faults.Error(vehicle.file, force.line,
                   "no static equilibrium: the preload of " + force.element + ", " + RoundedText(force.size) +
                       " N, is not balanced; correct it or write preload=\"equilibrium\"");
}

/// Elements whose force follows parameter `index`, and that nothing holds.
std::string Followers(int index, const std::vector<GivenForce>& forces, const Eigen::MatrixXd& holders) {
  std::string names;
  for (const GivenForce& force : forces) {
    const bool follows = std::find(force.parameters.begin(), force.parameters.end(), index) != force.parameters.end();
    if (!follows || IsHeld(force.direction, holders)) continue;
    const bool is_weight = force.kind == GivenForce::Kind::kWeight;
    names +=
        (names.empty() ? "" : " and ") + std::string(is_weight ? "the weight of " : "the preload of ") + force.element;
  }
  return names;
}

void ReportFreeParameters(const Vehicle& vehicle, const std::vector<GivenForce>& forces, const Eigen::MatrixXd& holders,
                          Diagnostics& faults) {
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    const Parameter& parameter = vehicle.parameters[i];
    if (!(parameter.lower < parameter.upper)) continue;
    const std::string followers = Followers(static_cast<int>(i), forces, holders);
    if (followers.empty()) continue;
    faults.Error(vehicle.file, parameter.line,
                 "no static equilibrium but at one value of fp:parameter '" + parameter.name + "': " + followers +
                     " follows it, but no " + kHolder +
                     " makes up for that; add one, or remove the parameter's bounds");
  }
}

}  // namespace

Eigen::MatrixXd PreloadMap(const Eigen::MatrixXd& holders) {
  if (holders.size() == 0) return Eigen::MatrixXd::Zero(holders.cols(), holders.rows());
  return -holders.completeOrthogonalDecomposition().pseudoInverse();
}

void CheckEquilibrium(const Vehicle& vehicle, const std::vector<GivenForce>& forces, const Eigen::MatrixXd& holders,
                      Diagnostics& faults) {
  if (IsBalanced(forces, holders)) ReportFreeParameters(vehicle, forces, holders, faults);
  else ReportImbalance(vehicle, forces, holders, faults);
}

}  // namespace fourpost
