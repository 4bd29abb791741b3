#include "identify/suggest/first_look.h"

#include <algorithm>
#include <exception>
#include <limits>

#include "analysis/process/deadline.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Of a block that has no such way, each addition's own.
Eigen::MatrixXd Evaluated(std::size_t block, const Eigen::VectorXd& here, std::span<const FirstLook> looks,
                          std::span<const OtherVehicle> others) {
  Eigen::MatrixXd changes(here.size(), std::ssize(others));
  for (std::size_t i = 0; i < others.size(); ++i) {
    const AugmentedStudy& study = *looks[i].study;
    const Evaluation there =
        study.objective().blocks()[block].evaluate(others[i].values, Deadline::In(study.deadline_s()));
    auto change = changes.col(static_cast<Index>(i));
    if (there.ok() && there.residuals.size() == here.size()) change = there.residuals - here;
    else change.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return changes;
}

}  // namespace

std::vector<std::optional<Eigen::VectorXd>> LookAt(const VehicleObjective& objective, const Eigen::VectorXd& values,
                                                   const Eigen::VectorXd& residuals, std::span<const FirstLook> looks) {
  std::vector<std::optional<Eigen::VectorXd>> seen(looks.size());
  const std::vector<ResidualBlock>& blocks = objective.blocks();
  const auto applies = [](const ResidualBlock& block) { return static_cast<bool>(block.toward); };
  if (looks.empty() || std::none_of(blocks.begin(), blocks.end(), applies)) return seen;
  Eigen::MatrixXd all = residuals.replicate(1, std::ssize(looks));
  Index first = 0;
  try {
    std::vector<OtherVehicle> others;
    for (const FirstLook& look : looks) others.push_back(look.study->VehicleAt(look.amount, values).value());
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const Eigen::VectorXd here = residuals.segment(first, blocks[b].count);
      all.middleRows(first, blocks[b].count) += applies(blocks[b])
                                                    ? blocks[b].toward(objective.AllParameters(values), others)
                                                    : Evaluated(b, here, looks, others);
      first += blocks[b].count;
    }
  } catch (const std::exception&) {
    // No motion to follow, or an addition that cannot follow it: the others do.
    for (std::size_t i = 0; looks.size() > 1 && i < looks.size(); ++i)
      seen[i] = LookAt(objective, values, residuals, looks.subspan(i, 1)).front();
    return seen;
  }
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (all.col(static_cast<Index>(i)).allFinite()) seen[i] = all.col(static_cast<Index>(i));
  return seen;
}

}  // namespace fourpost
