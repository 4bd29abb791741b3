#pragma once

#include <cmath>
#include <complex>

#include "identify/archive.h"
#include "identify/dvhde.h"
#include "identify/evaluation.h"
#include "identify/lattice.h"

namespace fourpost {

inline Evaluation OneResidual(double residual) {
  Evaluation evaluation;
  evaluation.residuals = Eigen::VectorXd::Constant(1, residual);
  return evaluation;
}

// Four gears of 12 to 60 teeth for a ratio of 1 / 6.931 (Sandgren, J. Mechanical Design 112, 1990). All 49^4
// enumerated: 2.7008571e-12 for 16, 19, 43, 49 teeth, the next is 2.3e-11.
inline Problem GearTrain() {
  const Lattice lattice({{"A", 12, 60, 1}, {"B", 12, 60, 1}, {"C", 12, 60, 1}, {"D", 12, 60, 1}});
  return {lattice, [](const Eigen::VectorXd& z) { return OneResidual(1 / 6.931 - z[0] * z[1] / (z[2] * z[3])); }};
}
constexpr double kGearTarget = 2.70086e-12;

constexpr std::array<double, 42> kWires_in = {
    0.009, 0.0095, 0.0104, 0.0118, 0.0128, 0.0132, 0.014, 0.015, 0.0162, 0.0173, 0.018, 0.020, 0.023,  0.025,
    0.028, 0.032,  0.035,  0.041,  0.047,  0.054,  0.063, 0.072, 0.080,  0.092,  0.105, 0.120, 0.135,  0.148,
    0.162, 0.177,  0.192,  0.207,  0.225,  0.244,  0.263, 0.283, 0.307,  0.331,  0.362, 0.394, 0.4375, 0.500};

// Volume of wire of a compression spring (Sandgren, as above): number of coils, wire by its place in the catalogue,
// coil diameter; inches and pounds. The cost is the volume, so the residual its root.
inline Evaluation CoilSpring(const Eigen::VectorXd& p) {
  const double coils = p[0];
  const double wire = kWires_in.at(static_cast<std::size_t>(p[1]) - 1);
  const double diameter = p[2];
  const double max_load = 1000;
  const double preload = 300;
  const double index = diameter / wire;
  const double stress_factor = (4 * index - 1) / (4 * index - 4) + 0.615 / index;
  const double rate = 11.5e6 * std::pow(wire, 4) / (8 * coils * std::pow(diameter, 3));
  const double solid = 1.05 * (coils + 2) * wire;
  const double free_length = max_load / rate + solid;
  const std::array<double, 8> constraints = {
      8 * stress_factor * max_load * diameter / (std::numbers::pi * std::pow(wire, 3)) - 189000, free_length - 14,
      0.2 - wire, diameter - 3, 3 - index, preload / rate - 6,
      // Zero by definition, but for rounding.
      preload / rate + (max_load - preload) / rate + solid - free_length - 1e-9, 1.25 - (max_load - preload) / rate};
  for (const double constraint : constraints) {
    if (!(constraint <= 0)) return Failed(Failure::kInfeasible, "a constraint is violated");
  }
  return OneResidual(std::sqrt(std::pow(std::numbers::pi, 2) * diameter * wire * wire * (coils + 2) / 4));
}

inline Problem Spring(double diameter_step) {
  return {Lattice({{"coils", 1, 70, 1}, {"wire", 1, 42, 1}, {"diameter", 0.6, 3, diameter_step}}), CoilSpring};
}

// Transmitted motion and force of m z'' + d (z - u)' + k (z - u) = 0 at 20 frequencies, against those of 200 kg,
// 15000 N/m, 1500 Ns/m, with a noise of 0.01 of the motion and 1 % of the force.
inline Evaluation OneMass(const Eigen::VectorXd& p) {
  using Complex = std::complex<double>;
  Evaluation evaluation;
  evaluation.residuals.resize(80);
  const auto motion = [](double m, double k, double d, double w) {
    return Complex(k, w * d) / Complex(k - m * w * w, w * d);
  };
  for (int i = 0; i < 20; ++i) {
    const double w = 2 * std::numbers::pi * 0.5 * std::pow(10, i / 19.0);
    const Complex z = motion(p[0], p[1], p[2], w);
    const Complex z0 = motion(200, 15000, 1500, w);
    const Complex dz = (z - z0) / 0.01;
    const Complex df = (p[0] * z - 200.0 * z0) / (0.01 * std::abs(200.0 * z0));
    evaluation.residuals.segment(4 * i, 4) << dz.real(), dz.imag(), df.real(), df.imag();
  }
  return evaluation;
}

inline Problem MassSpringDamper() {
  return {Lattice({{"m", 100, 600, 0.01}, {"k", 5000, 25000, 0.2}, {"d", 500, 3000, 0.05}}), OneMass};
}

// Cost 1 everywhere.
inline Problem Flat() {
  return {Lattice({{"a", 0, 1000, 1}, {"b", 0, 1000, 1}}), [](const Eigen::VectorXd&) { return OneResidual(1); }};
}

// Runs over the seeds 1..n, each with an archive of its own.
struct Tally {
  int solved = 0;
  double mean_paid = 0;
  double mean_feasible = 0;
  std::int64_t most_paid = 0;
};

inline Tally Runs(const Problem& problem, DvhdeOptions options, int n, double target) {
  options.target_cost = target;
  Tally tally;
  for (int seed = 1; seed <= n; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    Archive archive(problem);
    tally.solved += SearchDvhde(archive, options).end == SearchEnd::kTarget;
    const EvaluationCounts& counts = archive.counts();
    tally.mean_paid += static_cast<double>(counts.paid) / n;
    tally.mean_feasible += static_cast<double>(counts.paid - counts.failed()) / n;
    tally.most_paid = std::max(tally.most_paid, counts.paid);
  }
  return tally;
}

}  // namespace fourpost
