#include "vehicles/simulation/port_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <variant>

#include "analysis/numerics/decompositions.h"

namespace fourpost {
namespace {

/// Of the largest remainder so far: some hundred times what its rounding comes to.
constexpr double kTolerance = 1e-11;
constexpr int kMostIterations = 60;
constexpr int kMostHalvings = 12;

/// Gauss with row pivoting, in place: of the first n rows and columns `matrix` is used up, `right` becomes the
/// solution. Of a handful of unknowns, where a general factorisation costs more than its arithmetic.
void SolveInPlace(Eigen::Index n, Eigen::MatrixXd& matrix, Eigen::VectorXd& right) {
  double* const x = right.data();
  const auto column = [&](Eigen::Index k) { return matrix.data() + k * matrix.rows(); };
  for (Eigen::Index k = 0; k < n; ++k) {
    double* const below = column(k);
    Eigen::Index pivot = k;
    for (Eigen::Index i = k + 1; i < n; ++i)
      if (std::abs(below[i]) > std::abs(below[pivot])) pivot = i;
    if (pivot != k) {
      for (Eigen::Index j = k; j < n; ++j) std::swap(column(j)[k], column(j)[pivot]);
      std::swap(x[k], x[pivot]);
    }
    for (Eigen::Index i = k + 1; i < n; ++i) {
      below[i] /= below[k];
      x[i] -= below[i] * x[k];
    }
    for (Eigen::Index j = k + 1; j < n; ++j) {
      double* const to = column(j);
      for (Eigen::Index i = k + 1; i < n; ++i) to[i] -= below[i] * to[k];
    }
  }
  for (Eigen::Index j = n - 1; j >= 0; --j) {
    x[j] /= column(j)[j];
    for (Eigen::Index i = 0; i < j; ++i) x[i] -= column(j)[i] * x[j];
  }
}

std::span<const double> One(const Eigen::VectorXd& values, Eigen::Index j) { return {values.data() + j, 1}; }

}  // namespace

PortSolver::PortSolver(const std::vector<Port>& ports, double step_s) {
  for (const Port& port : ports) {
    laws_.push_back(port.law);
    memory_.emplace_back();
    if (const auto* friction = std::get_if<FrictionRemainder>(&port.law))
      memory_.back().emplace<FrictionStep>(friction->law);
    if (const auto* hydraulic = std::get_if<HydraulicRemainder>(&port.law))
      largest_ = std::max(largest_, memory_.back().emplace<HydraulicStep>(*hydraulic, step_s).Size());
  }
  const auto count = static_cast<Eigen::Index>(ports.size());
  for (Eigen::VectorXd* vector : {&extension_, &rate_, &law_, &residual_, &trial_, &step_, &on_extension_, &on_rate_})
    vector->setZero(count);
  jacobian_.setZero(count, count);
}

void PortSolver::SetCompliance(const Eigen::MatrixXd& by_extension, const Eigen::MatrixXd& by_rate) {
  by_extension_ = by_extension;
  by_rate_ = by_rate;
}

void PortSolver::Rest() {
  for (auto& memory : memory_) {
    if (auto* hydraulic = std::get_if<HydraulicStep>(&memory)) hydraulic->Rest();
    if (auto* friction = std::get_if<FrictionStep>(&memory)) friction->Rest();
  }
}

void PortSolver::RestFriction(Eigen::Index port, double extension) {
  std::get<FrictionStep>(memory_[static_cast<std::size_t>(port)]).Rest(extension);
}

void PortSolver::RememberFriction(const Memory& memory) {
  for (std::size_t j = 0; j < memory.size(); ++j)
    if (const auto* friction = std::get_if<FrictionStep>(&memory[j])) memory_[j] = *friction;
}

double PortSolver::Evaluate(const Eigen::VectorXd& extension, const Eigen::VectorXd& rate,
                            const Eigen::VectorXd& remainder) {
  const auto acting = remainder.head(active_);
  extension_.head(active_) = extension.head(active_);
  extension_.head(active_).noalias() += by_extension_.topLeftCorner(active_, active_) * acting;
  rate_.head(active_) = rate.head(active_);
  rate_.head(active_).noalias() += by_rate_.topLeftCorner(active_, active_) * acting;
  double largest = 0;
  for (Eigen::Index j = 0; j < active_; ++j) {
    const auto port = static_cast<std::size_t>(j);
    if (auto* hydraulic = std::get_if<HydraulicStep>(&memory_[port]))
      law_[j] = hydraulic->Remainder(extension_[j], rate_[j]);
    else if (auto* friction = std::get_if<FrictionStep>(&memory_[port])) law_[j] = friction->Tension(extension_[j]);
    else Remainders(laws_[port], One(extension_, j), One(rate_, j), {law_.data() + j, 1});
    residual_[j] = remainder[j] - law_[j];
    largest = std::max(largest, std::abs(residual_[j]));
  }
  return residual_.head(active_).allFinite() ? largest : std::numeric_limits<double>::quiet_NaN();
}

std::pair<double, double> PortSolver::SlopesOf(Eigen::Index j) const {
  const auto port = static_cast<std::size_t>(j);
  if (const auto* hydraulic = std::get_if<HydraulicStep>(&memory_[port]))
    return {hydraulic->ByExtension(), hydraulic->ByLag()};
  if (const auto* friction = std::get_if<FrictionStep>(&memory_[port])) return {friction->ByExtension(), 0};
  std::pair<double, double> slopes;
  RemainderSlopes(laws_[port], One(extension_, j), One(rate_, j), {&slopes.first, 1}, {&slopes.second, 1});
  return slopes;
}

/// jacobian step = residual, jacobian = 1 - slopes compliance.
void PortSolver::NewtonStep() {
  step_.head(active_) = residual_.head(active_);
  for (Eigen::Index j = 0; j < active_; ++j) std::tie(on_extension_[j], on_rate_[j]) = SlopesOf(j);
  for (Eigen::Index k = 0; k < active_; ++k) {
    const double* const by_extension = by_extension_.col(k).data();
    const double* const by_rate = by_rate_.col(k).data();
    double* const column = jacobian_.col(k).data();
    for (Eigen::Index j = 0; j < active_; ++j)
      column[j] = -on_extension_[j] * by_extension[j] - on_rate_[j] * by_rate[j];
    column[k] += 1;
  }
  SolveInPlace(active_, jacobian_, step_);
}

std::pair<double, double> PortSolver::ByStart(Eigen::Index port) const {
  const auto* friction = std::get_if<FrictionStep>(&memory_[static_cast<std::size_t>(port)]);
  if (!friction) return {0, 0};
  return {-friction->ByExtension(), friction->ByTension()};
}

double PortSolver::Departure(Eigen::Index port, const PortLaw& law) const {
  if (const auto* friction = std::get_if<FrictionStep>(&memory_[static_cast<std::size_t>(port)]))
    return friction->Departure(std::get<FrictionRemainder>(law).law);
  double force = 0;
  Remainders(law, One(extension_, port), One(rate_, port), {&force, 1});
  return force - law_[port];
}

void PortSolver::Change(const Eigen::Ref<const Eigen::MatrixXd>& extension,
                        const Eigen::Ref<const Eigen::MatrixXd>& rate, Eigen::Ref<Eigen::MatrixXd> forces) const {
  const Eigen::Index count = forces.rows();
  Eigen::MatrixXd jacobian(count, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto [by_extension, by_rate] = SlopesOf(j);
    jacobian.row(j) = -by_extension * by_extension_.row(j).head(count) - by_rate * by_rate_.row(j).head(count);
    jacobian(j, j) += 1;
    forces.row(j) += by_extension * extension.row(j) + by_rate * rate.row(j);
  }
  forces = Solved(jacobian, Eigen::MatrixXd(forces));
}

void PortSolver::Advance() {
  for (auto& memory : memory_) {
    if (auto* hydraulic = std::get_if<HydraulicStep>(&memory)) hydraulic->Advance();
    if (auto* friction = std::get_if<FrictionStep>(&memory)) friction->Advance();
  }
}

bool PortSolver::Solve(Eigen::Index count, const Eigen::VectorXd& extension, const Eigen::VectorXd& rate,
                       Eigen::VectorXd& remainder) {
  active_ = count;
  remainder.tail(remainder.size() - count).setZero();
  double miss = Evaluate(extension, rate, remainder);
  for (int i = 0; i < kMostIterations; ++i) {
    // Of the forces so far, not of trials that went astray; and of one newton, for a vehicle at rest.
    const double size = std::max({1.0, largest_, count > 0 ? law_.head(count).cwiseAbs().maxCoeff() : 0.0});
    if (miss <= kTolerance * size) {
      largest_ = size;
      // What the laws make of it, so that an exact law is met exactly.
      remainder.head(count) = law_.head(count);
      return true;
    }
    NewtonStep();
    double share = 1;
    double next = 0;
    for (int k = 0; k <= kMostHalvings; ++k, share /= 2) {
      trial_.head(count) = remainder.head(count) - share * step_.head(count);
      next = Evaluate(extension, rate, trial_);
      if (next < miss) break;
    }
    remainder.head(count) = trial_.head(count);
    miss = next;
    if (!std::isfinite(miss)) return false;
  }
  return false;
}

}  // namespace fourpost
