#include "identify/experiments/kinematics/kinematic_residuals.h"

#include <cmath>
#include <string>
#include <utility>

namespace fourpost {
namespace {

Evaluation Evaluate(const KinematicModel& model, Eigen::Index count, const std::vector<double>& values,
                    const Deadline& deadline) {
  const std::vector<KinematicSweep>& sweeps = model.sweeps();
  const KinematicAnswer answer = model.At(values, deadline);
  if (answer.refusal) {
    const KinematicSweep& sweep = sweeps[answer.refusal->sweep];
    return Infeasible(1,
                      "axle '" + sweep.axle_name + "' cannot follow " + sweep.motion + " of '" + sweep.recording + "'");
  }
  Evaluation evaluation;
  evaluation.residuals.resize(count);
  Eigen::Index next = 0;
  for (std::size_t s = 0; s < sweeps.size(); ++s)
    for (std::size_t c = 0; c < sweeps[s].curves.size(); ++c) {
      const Eigen::VectorXd residuals = CurveResiduals(sweeps[s].curves[c], answer.sweeps[s][c]);
      evaluation.residuals.segment(next, residuals.size()) = residuals;
      next += residuals.size();
    }
  return evaluation;
}

}  // namespace

Eigen::VectorXd CurveResiduals(const KinematicCurve& curve, const Eigen::VectorXd& modelled) {
  const Eigen::Map<const Eigen::VectorXd> measured(curve.measured.data(), std::ssize(curve.measured));
  const Eigen::VectorXd all = (modelled - measured) / curve.sd;
  if (!curve.has_free_offset) return all;
  Eigen::VectorXd contrasts(all.size() - 1);
  double sum = 0;
  for (Eigen::Index i = 0; i < contrasts.size(); ++i) {
    const auto k = static_cast<double>(i + 1);
    sum += all[i];
    contrasts[i] = (sum - k * all[i + 1]) / std::sqrt(k * (k + 1));
  }
  return contrasts;
}

ResidualBlock KinematicResiduals(std::shared_ptr<const KinematicModel> model) {
  ResidualPartition quantities = {"rig quantities", {}, {}};
  ResidualStructure structure;
  Eigen::Index count = 0;
  for (const KinematicSweep& sweep : model->sweeps())
    for (const KinematicCurve& curve : sweep.curves) {
      const auto degrees = static_cast<Eigen::Index>(curve.degrees());
      quantities.Add(std::string(curve.quantity->name), degrees);
      structure.recordings.Add(sweep.recording, degrees);
      count += degrees;
    }
  structure.partitions = {std::move(quantities)};
  return {.name = "kinematics and compliance",
          .count = count,
          // Poses at rest are found to 1e-11 m and rad, which is this share of what rigs measure.
          .accuracy = 1e-8,
          .evaluate = [model, count](const std::vector<double>& values,
                                     const Deadline& deadline) { return Evaluate(*model, count, values, deadline); },
          .structure = std::move(structure)};
}

}  // namespace fourpost
