#include "identify/problems/gear_train.h"

namespace fourpost {
namespace {

Evaluation RatioError(const Eigen::VectorXd& teeth) {
  Evaluation evaluation;
  evaluation.residuals = Eigen::VectorXd::Constant(1, 1 / 6.931 - teeth[0] * teeth[1] / (teeth[2] * teeth[3]));
  return evaluation;
}

LatticeAxis Gear(const char* name) {
  return {.name = name, .lower = 12, .upper = 60, .precision = 1, .discrete = true};
}

}  // namespace

Problem GearTrainProblem() { return {Lattice({Gear("A"), Gear("B"), Gear("C"), Gear("D")}), RatioError, 1}; }

}  // namespace fourpost
