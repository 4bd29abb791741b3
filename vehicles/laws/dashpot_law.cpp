#include "vehicles/laws/dashpot_law.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "analysis/numerics/increasing_root.h"
#include "analysis/text/count_check.h"
#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

void RequireRate(const char* field, double value) {
  RequireOption(value >= 0 && std::isfinite(value), std::string("DashpotLaw: ") + field, value,
                "finite and not negative");
}

void RequireSpeed(const char* field, double value) {
  RequireOption(value > 0 && std::isfinite(value), std::string("DashpotLaw: ") + field, value, "finite and positive");
}

/// Largest slope of x tanh(x), at x = this number, where x tanh(x) = 1.
constexpr double kSteepestSmooth = 1.1996786402577339;

}  // namespace

double DashpotLaw::Bilinear::LeastSlope() const { return std::min(bump, rebound); }

double DashpotLaw::Bilinear::GreatestSlope() const { return std::max(bump, rebound); }

std::pair<double, double> DashpotLaw::Smoothed::ForceAndSlope(double v) const {
  const double x = v / speed;
  const double t = std::tanh(x);
  return {(mean + half_difference * t) * v, mean + half_difference * (t + x * (1 - t * t))};
}

double DashpotLaw::Smoothed::Velocity(double force) const {
  // The rate lies between the mean and that of the force's side.
  const double side = force > 0 ? mean + half_difference : mean - half_difference;
  const auto [lower, upper] = std::minmax({force / mean, force / side});
  if (!std::isfinite(upper - lower)) return force / side;
  return IncreasingRoot([this](double v) { return ForceAndSlope(v); }, force, lower, upper, force / side);
}

double DashpotLaw::Smoothed::LeastSlope() const { return mean - kSteepestSmooth * std::abs(half_difference); }

double DashpotLaw::Smoothed::GreatestSlope() const { return mean + kSteepestSmooth * std::abs(half_difference); }

double DashpotLaw::Kneed::Force(double v) const {
  const Knee& knee = v > 0 ? rebound : bump;
  const double beyond = std::abs(v) - knee.speed;
  if (!(beyond > 0)) return inner.Force(v);
  const double at_knee = inner.Force(std::copysign(knee.speed, v));
  return at_knee + knee.rate * std::copysign(beyond, v);
}

double DashpotLaw::Kneed::Slope(double v) const {
  const Knee& knee = v > 0 ? rebound : bump;
  const double beyond = std::abs(v) - knee.speed;
  if (beyond == 0) return 0.5 * (inner.Slope(v) + knee.rate);
  return beyond > 0 ? knee.rate : inner.Slope(v);
}

double DashpotLaw::Kneed::Velocity(double force) const {
  const Knee& knee = force > 0 ? rebound : bump;
  const double at_knee = inner.Force(std::copysign(knee.speed, force));
  const double beyond = std::abs(force) - std::abs(at_knee);
  if (!(beyond > 0)) return inner.Velocity(force);
  return std::copysign(knee.speed + beyond / knee.rate, force);
}

double DashpotLaw::Kneed::LeastSlope() const { return std::min({inner.bump, inner.rebound, bump.rate, rebound.rate}); }

double DashpotLaw::Kneed::GreatestSlope() const {
  return std::max({inner.bump, inner.rebound, bump.rate, rebound.rate});
}

std::pair<double, double> DashpotLaw::Saturated::ForceAndSlope(double v) const {
  const double divisor = Divisor(v);
  return {at_rest.Force(v) / divisor, at_rest.Slope(v) / (divisor * divisor)};
}

double DashpotLaw::Saturated::Velocity(double force) const {
  const double straight = at_rest.Velocity(force);
  const double left = 1 - std::abs(straight) / (force > 0 ? rebound_speed : bump_speed);
  return left > 0 ? straight / left : std::copysign(std::numeric_limits<double>::infinity(), force);
}

DashpotLaw::DashpotLaw(Law law) : law_(std::move(law)) {}

DashpotLaw::DashpotLaw(double bump, double rebound) : law_(Bilinear{bump, rebound}) {
  RequireRate("bump", bump);
  RequireRate("rebound", rebound);
}

DashpotLaw DashpotLaw::Smooth(double bump, double rebound, double speed) {
  RequireRate("bump", bump);
  RequireRate("rebound", rebound);
  RequireSpeed("speed", speed);
  return DashpotLaw(Smoothed{0.5 * (rebound + bump), 0.5 * (rebound - bump), speed});
}

DashpotLaw DashpotLaw::Digressive(double bump, double rebound, Knee bump_knee, Knee rebound_knee) {
  RequireRate("bump", bump);
  RequireRate("rebound", rebound);
  RequireSpeed("bump_knee.speed", bump_knee.speed);
  RequireRate("bump_knee.rate", bump_knee.rate);
  RequireSpeed("rebound_knee.speed", rebound_knee.speed);
  RequireRate("rebound_knee.rate", rebound_knee.rate);
  return DashpotLaw(Kneed{{bump, rebound}, bump_knee, rebound_knee});
}

DashpotLaw DashpotLaw::Saturating(double bump, double rebound, double bump_speed, double rebound_speed) {
  RequireRate("bump", bump);
  RequireRate("rebound", rebound);
  RequireSpeed("bump_speed", bump_speed);
  RequireSpeed("rebound_speed", rebound_speed);
  return DashpotLaw(Saturated{{bump, rebound}, bump_speed, rebound_speed});
}

DashpotLaw DashpotLaw::Table(std::vector<double> speed, std::vector<double> force) {
  RequireCount("DashpotLaw: force", "speeds", speed.size(), force.size());
  const auto origin = std::lower_bound(speed.begin(), speed.end(), 0.0) - speed.begin();
  const auto i = static_cast<std::size_t>(origin);
  if (i == speed.size() || speed[i] != 0) {
    speed.insert(speed.begin() + origin, 0);
    force.insert(force.begin() + origin, 0);
  }
  RequireOption(force[i] == 0, "DashpotLaw: force", force[i], "0 at speed 0");
  return DashpotLaw(
      Tabulated{MonotoneCurve(std::move(speed), std::move(force), "DashpotLaw: speed", "DashpotLaw: force")});
}

DashpotLaw DashpotLaw::WithFriction(double force, double speed) const {
  RequireRate("friction force", force);
  RequireSpeed("friction speed", speed);
  DashpotLaw law = *this;
  law.friction_ = force;
  law.friction_speed_ = speed;
  return law;
}

double DashpotLaw::ForceWithoutFriction(double v) const {
  return std::visit([v](const auto& law) { return law.Force(v); }, law_);
}

double DashpotLaw::VelocityWithoutFriction(double force) const {
  return std::visit([force](const auto& law) { return law.Velocity(force); }, law_);
}

double DashpotLaw::AnyForce(double v) const {
  const double force = ForceWithoutFriction(v);
  return friction_ == 0 ? force : force + friction_ * std::tanh(v / friction_speed_);
}

void DashpotLaw::Forces(std::span<const double> v, std::span<double> force) const {
  std::visit(
      [&](const auto& law) {
        for (std::size_t k = 0; k < v.size(); ++k) force[k] = law.Force(v[k]);
      },
      law_);
  if (friction_ == 0) return;
  for (std::size_t k = 0; k < v.size(); ++k) force[k] += friction_ * std::tanh(v[k] / friction_speed_);
}

std::pair<double, double> DashpotLaw::AnyForceAndSlope(double v) const {
  const auto [force, slope] = std::visit([v](const auto& law) { return law.ForceAndSlope(v); }, law_);
  if (friction_ == 0) return {force, slope};
  const double t = std::tanh(v / friction_speed_);
  return {force + friction_ * t, slope + friction_ / friction_speed_ * (1 - t * t)};
}

double DashpotLaw::Velocity(double force) const {
  double fastest = VelocityWithoutFriction(force);
  if (friction_ == 0) return fastest;
  // Friction carries part of the force, at most all of its own.
  const double size = std::abs(force);
  const double slowest = size > friction_ ? VelocityWithoutFriction(std::copysign(size - friction_, force)) : 0;
  if (size < friction_) {
    const double by_friction_alone = std::copysign(friction_speed_ * std::atanh(size / friction_), force);
    if (!(std::abs(fastest) <= std::abs(by_friction_alone))) fastest = by_friction_alone;
  }
  if (!std::isfinite(fastest)) return fastest;
  const auto [lower, upper] = std::minmax({slowest, fastest});
  return IncreasingRoot([this](double v) { return AnyForceAndSlope(v); }, force, lower, upper, fastest);
}

double DashpotLaw::LeastRate() const {
  return std::visit([](const auto& law) { return law.LeastSlope(); }, law_);
}

double DashpotLaw::GreatestRate() const {
  return std::visit([](const auto& law) { return law.GreatestSlope(); }, law_) + friction_ / friction_speed_;
}

double DashpotLaw::StepSpeed() const {
  const auto* smooth = std::get_if<Smoothed>(&law_);
  const double speed = smooth ? smooth->speed : std::numeric_limits<double>::infinity();
  return friction_ > 0 ? std::min(speed, friction_speed_) : speed;
}

std::vector<DashpotLaw::Kink> DashpotLaw::Kinks() const {
  if (const auto* law = std::get_if<Bilinear>(&law_)) return {{0, law->rebound - law->bump}};
  if (const auto* law = std::get_if<Saturated>(&law_)) return {{0, law->at_rest.rebound - law->at_rest.bump}};
  if (const auto* law = std::get_if<Kneed>(&law_))
    return {{-law->bump.speed, law->inner.bump - law->bump.rate},
            {0, law->inner.rebound - law->inner.bump},
            {law->rebound.speed, law->rebound.rate - law->inner.rebound}};
  return {};
}

double DashpotLaw::MeanRate() const {
  if (const auto* bilinear = std::get_if<Bilinear>(&law_)) return bilinear->Slope(0);
  constexpr double kSpeed = 0.1;
  return (ForceWithoutFriction(kSpeed) - ForceWithoutFriction(-kSpeed)) / (2 * kSpeed);
}

}  // namespace fourpost
