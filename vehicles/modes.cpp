#include "vehicles/modes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "vehicles/motion_name.h"

namespace fourpost {
namespace {

constexpr std::array<const char*, 6> kBodyNames = {"fore-aft", "lateral", "heave", "roll", "pitch", "yaw"};
constexpr std::array<const char*, 6> kAxleNames = {"fore-aft", "lateral", "hop", "tramp", "wind-up", "yaw"};

std::string NameOf(const std::vector<CondensedVehicle::LinkMotion>& links, const Eigen::VectorXcd& shape) {
  const auto heavier = [](const auto& a, const auto& b) { return a.mass < b.mass; };
  const auto body = std::max_element(links.begin(), links.end(), heavier);
  auto moving = links.begin();
  double most = -1;
  double total = 0;
  for (auto link = links.begin(); link != links.end(); ++link) {
    const double energy = DirectionalEnergy(*link, shape).sum();
    total += energy;
    if (link != body && energy > most) {
      most = energy;
      moving = link;
    }
  }
  Eigen::Index direction = 0;
  if (DirectionalEnergy(*body, shape).sum() >= 0.5 * total) {
    DirectionalEnergy(*body, shape).maxCoeff(&direction);
    return kBodyNames[static_cast<std::size_t>(direction)];
  }
  DirectionalEnergy(*moving, shape).maxCoeff(&direction);
  constexpr double kSameStation_m = 0.1;
  const double ahead = moving->com.x() - body->com.x();
  const std::string where = std::abs(ahead) < kSameStation_m ? "wheel " : ahead > 0 ? "front " : "rear ";
  return where + kAxleNames[static_cast<std::size_t>(direction)];
}

}  // namespace

Eigen::MatrixXd StateMatrix(const CondensedModel& model) {
  const Eigen::Index n = model.mass.rows();
  const std::vector<const CondensedModel::Dashpot*> series = model.SeriesDampers();
  Eigen::MatrixXd damping = model.damping;
  for (const CondensedModel::Dashpot& dashpot : model.dashpots)
    if (!(dashpot.series_stiffness > 0))
      damping += dashpot.law.MeanRate() * dashpot.direction * dashpot.direction.transpose();
  const Eigen::Index size = 2 * n + static_cast<Eigen::Index>(series.size());
  const Eigen::LDLT<Eigen::MatrixXd> mass(model.mass);
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size);
  a.block(0, n, n, n).setIdentity();
  a.block(n, 0, n, n) = -mass.solve(model.stiffness);
  a.block(n, n, n, n) = -mass.solve(damping);
  for (std::size_t j = 0; j < series.size(); ++j) {
    const Eigen::Index x = 2 * n + static_cast<Eigen::Index>(j);
    a.block(n, x, n, 1) = -mass.solve(series[j]->direction) * series[j]->series_stiffness;
    a.block(x, n, 1, n) = series[j]->direction.transpose();
    a(x, x) = -series[j]->series_stiffness / series[j]->law.MeanRate();
  }
  return a;
}

std::vector<Mode> ModesOf(const CondensedVehicle& vehicle, std::span<const double> parameters) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(StateMatrix(vehicle.At(parameters)));
  const std::vector<CondensedVehicle::LinkMotion> links = vehicle.LinkMotions(parameters);
  std::vector<Mode> modes;
  for (Eigen::Index i = 0; i < solver.eigenvalues().size(); ++i) {
    const std::complex<double> pole = solver.eigenvalues()[i];
    if (pole.imag() <= 0) continue;
    Mode mode;
    mode.pole = pole;
    mode.frequency_Hz = std::abs(pole) / (2 * std::numbers::pi);
    mode.damping_ratio = -pole.real() / std::abs(pole);
    mode.shape = solver.eigenvectors().col(i).head(vehicle.size());
    Eigen::Index largest = 0;
    mode.shape.cwiseAbs().maxCoeff(&largest);
    mode.shape /= mode.shape[largest];
    mode.name = NameOf(links, mode.shape);
    modes.push_back(std::move(mode));
  }
  std::sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) { return a.frequency_Hz < b.frequency_Hz; });
  return modes;
}

}  // namespace fourpost
