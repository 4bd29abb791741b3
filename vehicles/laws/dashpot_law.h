#pragma once

#include <cmath>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "vehicles/laws/monotone_curve.h"

namespace fourpost {

/// Force f(v) of a dashpot [N], tension positive; v: extension rate [m/s], rebound positive. f(0) = 0. Rates [N s/m]
/// are finite and not negative, velocities [m/s] and forces [N] of the laws are positive. The functions that make a law
/// throw std::invalid_argument naming the field otherwise.
class DashpotLaw {
 public:
  /// Above `speed` [m/s, > 0] the rate is `rate` [N s/m].
  struct Knee {
    double speed = 0;
    double rate = 0;

    bool operator==(const Knee&) const = default;
  };

  /// No force.
  DashpotLaw() = default;

  /// f = rebound v for v > 0, bump v otherwise (thesis table 3.3.1, model 2); equal rates:
  /// linear (model 1).
  DashpotLaw(double bump, double rebound);

  /// f = [(rebound + bump)/2 + (rebound - bump)/2 tanh(v/speed)] v. The thesis's model 5 passes smoothly
  /// from one rate to the other; tanh is our choice for it. Increasing while one rate is below 11.01 times the other.
  static DashpotLaw Smooth(double bump, double rebound, double speed);

  /// Bilinear up to the knee of each side, the knee's rate beyond; continuous.
  static DashpotLaw Digressive(double bump, double rebound, Knee bump_knee, Knee rebound_knee);

  /// f = rebound v / (1 + v/rebound_speed) for v > 0, bump v / (1 - v/bump_speed) otherwise. At these speeds [m/s] the
  /// force is half of what the rate at rest would give; it stays below rate times speed. Degressive dampers are also
  /// written c v / (1 + d |v|), d = 1/speed.
  static DashpotLaw Saturating(double bump, double rebound, double bump_speed, double rebound_speed);

  /// MonotoneCurve through the points (speed, force); (0, 0) is added where it is missing. Speeds strictly increase,
  /// forces do not fall.
  static DashpotLaw Table(std::vector<double> speed, std::vector<double> force);

  /// This law plus Coulomb friction, f + force tanh(v/speed); replaces any previous friction.
  DashpotLaw WithFriction(double force, double speed) const;

  double Force(double v) const {
    const auto* bilinear = std::get_if<Bilinear>(&law_);
    return bilinear && friction_ == 0 ? bilinear->Force(v) : AnyForce(v);
  }

  /// Forces at many rates at once; spans of one length.
  void Forces(std::span<const double> v, std::span<double> force) const;

  /// df/dv [N s/m]; at a kink the mean of both sides.
  double Slope(double v) const {
    const auto* bilinear = std::get_if<Bilinear>(&law_);
    return bilinear && friction_ == 0 ? bilinear->Slope(v) : AnyForceAndSlope(v).second;
  }

  /// {f, df/dv}, cheaper than two calls.
  std::pair<double, double> ForceAndSlope(double v) const {
    const auto* bilinear = std::get_if<Bilinear>(&law_);
    return bilinear && friction_ == 0 ? std::pair(bilinear->Force(v), bilinear->Slope(v)) : AnyForceAndSlope(v);
  }

  /// The rate at this force. Needs LeastRate() > 0. Closed form for bilinear and digressive laws without friction, else
  /// see IncreasingRoot.
  double Velocity(double force) const;

  /// Bounds of the slope over all v [N s/m], attained or approached, except for friction, whose slope lies between 0
  /// and force/speed.
  double LeastRate() const;
  double GreatestRate() const;

  /// Velocity range of the transition about v = 0 [m/s]: that of friction, or of a smooth law; infinite without either.
  double StepSpeed() const;

  /// A velocity at which the slope jumps [m/s], and the jump towards larger v [N s/m].
  struct Kink {
    double speed = 0;
    double jump = 0;
  };
  /// Corners of the law: none for a smooth law or a table, one at rest for a saturating law.
  std::vector<Kink> Kinks() const;

  /// (f(V) - f(-V)) / 2V at V = 0.1 m/s without friction: the rate in linear models. For a bilinear law the mean of
  /// both rates, which is also its exact first-harmonic rate for a sinusoidal v.
  double MeanRate() const;

  /// Same kind and same numbers.
  bool operator==(const DashpotLaw&) const = default;

 private:
  struct Bilinear {
    double bump;
    double rebound;

    bool operator==(const Bilinear&) const = default;
    double Force(double v) const { return (v > 0 ? rebound : bump) * v; }
    double Slope(double v) const {
      if (v > 0) return rebound;
      if (v < 0) return bump;
      return v == 0 ? 0.5 * (rebound + bump) : v;
    }
    std::pair<double, double> ForceAndSlope(double v) const { return {Force(v), Slope(v)}; }
    double Velocity(double force) const { return force / (force > 0 ? rebound : bump); }
    double LeastSlope() const;
    double GreatestSlope() const;
  };

  /// f = (mean + half_difference tanh(v/speed)) v.
  struct Smoothed {
    double mean;
    double half_difference;
    double speed;

    bool operator==(const Smoothed&) const = default;
    double Force(double v) const { return (mean + half_difference * std::tanh(v / speed)) * v; }
    double Slope(double v) const { return ForceAndSlope(v).second; }
    std::pair<double, double> ForceAndSlope(double v) const;
    double Velocity(double force) const;
    double LeastSlope() const;
    double GreatestSlope() const;
  };

  struct Kneed {
    Bilinear inner;
    Knee bump;
    Knee rebound;

    bool operator==(const Kneed&) const = default;
    double Force(double v) const;
    double Slope(double v) const;
    std::pair<double, double> ForceAndSlope(double v) const { return {Force(v), Slope(v)}; }
    double Velocity(double force) const;
    double LeastSlope() const;
    double GreatestSlope() const;
  };

  struct Saturated {
    Bilinear at_rest;
    double bump_speed;
    double rebound_speed;

    bool operator==(const Saturated&) const = default;
    double Divisor(double v) const { return 1 + std::abs(v) / (v > 0 ? rebound_speed : bump_speed); }
    double Force(double v) const { return at_rest.Force(v) / Divisor(v); }
    double Slope(double v) const { return ForceAndSlope(v).second; }
    std::pair<double, double> ForceAndSlope(double v) const;
    double Velocity(double force) const;
    double LeastSlope() const { return 0; }
    double GreatestSlope() const { return at_rest.GreatestSlope(); }
  };

  struct Tabulated {
    MonotoneCurve curve;

    bool operator==(const Tabulated&) const = default;
    double Force(double v) const { return curve.Value(v); }
    double Slope(double v) const { return curve.Slope(v); }
    std::pair<double, double> ForceAndSlope(double v) const { return {Force(v), Slope(v)}; }
    double Velocity(double force) const { return curve.Argument(force); }
    double LeastSlope() const { return curve.LeastSlope(); }
    double GreatestSlope() const { return curve.GreatestSlope(); }
  };

  using Law = std::variant<Bilinear, Smoothed, Kneed, Saturated, Tabulated>;

  explicit DashpotLaw(Law law);

  double AnyForce(double v) const;
  double ForceWithoutFriction(double v) const;
  std::pair<double, double> AnyForceAndSlope(double v) const;
  double VelocityWithoutFriction(double force) const;

  Law law_ = Bilinear{0, 0};
  double friction_ = 0;        // N
  double friction_speed_ = 1;  // m/s
};

}  // namespace fourpost
