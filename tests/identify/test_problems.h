#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <optional>

#include "identify/problems/coil_spring.h"
#include "identify/problems/gear_train.h"
#include "identify/search/archive.h"
#include "identify/search/dvhde.h"
#include "identify/search/evaluation.h"
#include "identify/search/lattice.h"
#include "identify/search/run_search.h"

namespace fourpost {

inline Evaluation OneResidual(double residual) {
  Evaluation evaluation;
  evaluation.residuals = Eigen::VectorXd::Constant(1, residual);
  return evaluation;
}

inline Problem GearTrain() { return GearTrainProblem(); }
constexpr double kGearTarget = kGearTrainTarget;

inline Problem CoilSpring(double diameter_step) { return CoilSpringProblem(diameter_step); }

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

/// Differential evolution of 40 with the thesis's two hybrid operators, to test each mechanism by itself.
inline DvhdeOptions ClassicDvhde() {
  DvhdeOptions options = ThesisDvhde();
  options.population = 40;
  options.base = MutationBase::kRandom;
  options.factor = 0.5;
  options.crossover = 0.9;
  options.forced_gene = true;
  options.rank_violations = true;
  options.migrate_after = 100;
  options.migrate_below_diversity = 0;
  options.diversity_measure = DiversityMeasure::kRange;
  return options;
}

/// dvHDE with all that a search needs.
struct DvhdeSearch : DvhdeOptions {
  DvhdeSearch() : DvhdeOptions(ClassicDvhde()) {}
  explicit DvhdeSearch(const DvhdeOptions& options) : DvhdeOptions(options) {}

  std::uint64_t seed = 1;
  std::int64_t max_evaluations = 10000;
  int max_generations = 1000;
  std::optional<double> target_cost;
  int candidates = 5;
  double candidate_separation = 0.05;
};

inline SearchResult SearchDvhde(Archive& archive, const DvhdeSearch& options, const SearchHooks& hooks = {}) {
  Dvhde method(archive.lattice(), options, options.seed);
  const StopRules rules = {.target_cost = options.target_cost,
                           .max_evaluations = options.max_evaluations,
                           .max_generations = options.max_generations};
  return RunSearch(archive, method, rules, {options.candidates, options.candidate_separation}, hooks);
}

// Runs over the seeds 1..n, each with an archive of its own.
struct Tally {
  int solved = 0;
  double mean_paid = 0;
  double mean_feasible = 0;
  std::int64_t most_paid = 0;
};

inline Tally Runs(const Problem& problem, DvhdeSearch options, int n, double target) {
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
