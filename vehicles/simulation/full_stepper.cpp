#include "vehicles/simulation/full_stepper.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include "analysis/numerics/anderson_acceleration.h"
#include "analysis/text/option_check.h"
#include "vehicles/condensed/linear_vehicle.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/simulation/findings.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Of the largest inertia so far: what g is left to err by in a step.
constexpr double kStepTolerance = 1e-5;
constexpr int kMostNewtonSteps = 30;
constexpr int kHistory = 8;

/// Of a force on each coordinate: what acceleration it causes at 10 Hz, as the root of an energy.
Eigen::VectorXd WeightsOf(const LinearVehicle& linear) {
  const double omega = 2 * std::numbers::pi * 10;
  Eigen::VectorXd inertia = linear.stiffness.diagonal().cwiseAbs() / (omega * omega);
  inertia.head(linear.mass.rows()) += linear.mass.diagonal();
  return inertia.cwiseSqrt().cwiseInverse();
}

}  // namespace

FullStepper::FullStepper(Multibody& multibody, const CondensedModel& model, double step_s, long parts)
    : full_(multibody, model),
      parts_(parts),
      stepper_(model, step_s / static_cast<double>(parts), CondensedStepper::Forces::kAdded),
      mass_(model.mass) {
  RequireOption(parts >= 1, "FullStepper: parts", static_cast<double>(parts), "at least 1");
  const LinearVehicle linear(model, LinearVehicle::Rates::kCentre);
  weights_ = WeightsOf(linear);
  posts_.resize(stepper_.post_count());
  const std::vector<Port> ports = PortsOf(model);
  for (const std::size_t j : full_.hydraulics()) {
    memory_directions_.push_back(ports[j].direction);
    oil_.emplace_back(std::get<HydraulicRemainder>(ports[j].law), stepper_.step_s());
  }
  for (const std::size_t j : full_.frictions()) {
    const DahlFriction& law = std::get<FrictionRemainder>(ports[j].law).law;
    memory_directions_.push_back(ports[j].direction);
    frictions_.emplace_back(law);
    sliding_.push_back(law.force);
  }
  extensions_.resize(parts + 1, static_cast<Index>(memory_directions_.size()));
}

void FullStepper::Start(const PostMotion& posts, double t, const Eigen::VectorXd& released) {
  start_s_ = t;
  steps_ = evaluations_ = 0;
  posts(t, posts_);
  stepper_.Start(posts_);
  if (released.size() > 0) stepper_.SetState(released, posts_);
  added_.setZero(full_.size());
  before_ = added_;
  // A centimetre per second squared of all that moves: of a vehicle at rest what is left of forces is their rounding.
  largest_ = Size(
      (Eigen::VectorXd(full_.size()) << 0.01 * mass_.diagonal(), Eigen::VectorXd::Zero(full_.size() - mass_.rows()))
          .finished());
  StartMemory(released);
  const Eigen::VectorXd lacking = Lacking(t);
  if (released.size() > 0) {
    stepper_.Store(moment_);
    moment_.added = added_ = before_ = -lacking;
    stepper_.Return(moment_);
    Lacking(t);
  }
  readings_ = full_.Readings();
}

void FullStepper::StartMemory(const Eigen::VectorXd& released) {
  const Index strokes = released.size() - stepper_.state().size();
  extra_.setZero(extensions_.cols());
  extensions_.setZero();
  for (HydraulicStep& oil : oil_) oil.Rest();
  for (FrictionStep& friction : frictions_) friction.Rest();
  if (released.size() > 0 && full_.HasMemory()) {
    for (std::size_t i = 0; i < memory_directions_.size(); ++i)
      extensions_.col(static_cast<Index>(i)).setConstant(memory_directions_[i].dot(Position()));
    extra_ = full_.MemoryExtensions(Position()) - extensions_.row(0).transpose();
    for (std::size_t i = 0; i < frictions_.size(); ++i) {
      const auto column = static_cast<Index>(oil_.size() + i);
      const double extension = extensions_(0, column) + extra_[column];
      if (strokes > 0) frictions_[i].Rest(extension - released.tail(strokes)[static_cast<Index>(i)]);
      frictions_[i].Tension(extension);
      frictions_[i].Advance();
    }
  }
  oil_at_start_ = oil_;
  frictions_at_start_ = frictions_;
  extra_at_start_ = extra_;
}

/// [s x] of the reduced model now.
Eigen::VectorXd FullStepper::Position() const {
  Eigen::VectorXd position(full_.size());
  position << stepper_.state().head(mass_.rows()), stepper_.state().tail(full_.size() - mass_.rows());
  return position;
}

void FullStepper::StepParts(const PostMotion& posts, const Eigen::VectorXd& added) {
  const double begin = start_s_ + static_cast<double>(steps_ * parts_) * stepper_.step_s();
  const Index n = mass_.rows();
  for (long part = 1; part <= parts_; ++part) {
    const double share = static_cast<double>(part) / static_cast<double>(parts_);
    posts(begin + static_cast<double>(part) * stepper_.step_s(), posts_);
    stepper_.Step(posts_, added_ + share * (added - added_));
    for (std::size_t i = 0; i < memory_directions_.size(); ++i)
      extensions_(part, static_cast<Index>(i)) =
          memory_directions_[i].head(n).dot(stepper_.state().head(n)) +
          memory_directions_[i].tail(full_.size() - n).dot(stepper_.state().tail(full_.size() - n));
  }
}

/// In the full system, `part` steps of the reduced model after the start: that of the condensed one, and straight from
/// the start to the end what they differ by.
double FullStepper::MemoryExtension(std::size_t element, long part) const {
  const auto column = static_cast<Index>(element);
  const double share = static_cast<double>(part) / static_cast<double>(parts_);
  return extensions_(part, column) + extra_at_start_[column] + share * (extra_[column] - extra_at_start_[column]);
}

/// By the elements' own steps.
Eigen::VectorXd FullStepper::Memory(const Eigen::VectorXd& position) {
  constexpr double kMegapascal = 1e6;
  Eigen::VectorXd memory(2 * static_cast<Index>(oil_.size()) + static_cast<Index>(frictions_.size()));
  if (!full_.HasMemory()) return memory;
  extra_ = full_.MemoryExtensions(position) - extensions_.row(parts_).transpose();
  for (std::size_t i = 0; i < oil_.size(); ++i) {
    oil_[i] = oil_at_start_[i];
    for (long part = 1; part <= parts_; ++part) {
      if (!std::isfinite(oil_[i].Remainder(MemoryExtension(i, part), 0))) throw SimulationError(kChamberCloses);
      oil_[i].Advance();
    }
    const std::array<double, 2> above = oil_[i].PressuresAboveRest();
    for (std::size_t c = 0; c < 2; ++c) memory[static_cast<Index>(2 * i + c)] = above[c] / kMegapascal;
  }
  for (std::size_t i = 0; i < frictions_.size(); ++i) {
    frictions_[i] = frictions_at_start_[i];
    double tension = 0;
    for (long part = 1; part <= parts_; ++part) {
      tension = frictions_[i].Tension(MemoryExtension(oil_.size() + i, part));
      frictions_[i].Advance();
    }
    memory[static_cast<Index>(2 * oil_.size() + i)] = sliding_[i] > 0 ? tension / sliding_[i] : 0;
  }
  return memory;
}

Eigen::VectorXd FullStepper::Lacking(double t) {
  const Index n = mass_.rows();
  const Index series = full_.size() - n;
  const Eigen::VectorXd rate = stepper_.StateRate();
  motion_.position.resize(full_.size());
  motion_.position << stepper_.state().head(n), stepper_.state().tail(series);
  motion_.rate.resize(full_.size());
  motion_.rate << rate.head(n), rate.tail(series);
  motion_.acceleration = rate.segment(n, n);
  motion_.memory = Memory(motion_.position);
  ++evaluations_;
  return full_.At(t, motion_);
}

void FullStepper::Step(const PostMotion& posts) {
  const double end = start_s_ + static_cast<double>((steps_ + 1) * parts_) * stepper_.step_s();
  stepper_.Store(moment_);
  oil_at_start_ = oil_;
  frictions_at_start_ = frictions_;
  extra_at_start_ = extra_;
  extensions_.row(0) = extensions_.row(parts_);
  Eigen::VectorXd added = 2 * added_ - before_;
  AndersonAcceleration acceleration(kHistory);
  for (int iteration = 0; iteration < kMostNewtonSteps; ++iteration) {
    if (iteration > 0) stepper_.Return(moment_);
    StepParts(posts, added);
    const Eigen::VectorXd lacking = Lacking(end);
    Eigen::VectorXd inertia = Eigen::VectorXd::Zero(full_.size());
    inertia.head(mass_.rows()) = mass_ * motion_.acceleration;
    if (!lacking.allFinite()) break;
    if (Size(lacking) <= kStepTolerance * std::max(largest_, Size(inertia))) {
      largest_ = std::max(largest_, Size(inertia));
      readings_ = full_.Readings();
      before_ = std::exchange(added_, std::move(added));
      ++steps_;
      return;
    }
    added = acceleration.Next(added.cwiseProduct(weights_), -lacking.cwiseProduct(weights_)).cwiseQuotient(weights_);
  }
  throw SimulationError(kFullDeparts, {std::to_string(end) + " s"});
}

}  // namespace fourpost
