// The state at the first sample of histories, which nobody knows.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "identify/experiments/time_history/history_residuals.h"
#include "identify/experiments/time_history/start_state.h"

namespace fourpost {

using Eigen::Index;

void HistoryResiduals::AddStartTo(const MeasuredHistory& history, const CondensedModel& model,
                                  Eigen::MatrixXd& modelled) const {
  if (!history.release) AddStart(history, model, WeightsOf(history), history.Stride(), modelled);
}

Eigen::VectorXd HistoryResiduals::WeightsOf(const MeasuredHistory& history) const {
  Eigen::VectorXd weights(std::ssize(history.signals));
  for (Index i = 0; i < weights.size(); ++i)
    weights[i] = 1 / std::pow(DeviationOf(history.signals[static_cast<std::size_t>(i)]), 2);
  return weights;
}

double HistoryResiduals::SquaresOf(const MeasuredHistory& history, const Eigen::MatrixXd& modelled) const {
  const Eigen::VectorXd weights = WeightsOf(history);
  const Index stride = history.Stride();
  const auto counted = Eigen::seqN(0, CountOf(history), stride);
  double squares = 0;
  for (Index i = 0; i < weights.size(); ++i) {
    const auto model = modelled.col(i);
    squares +=
        weights[i] * (history.signals[static_cast<std::size_t>(i)].MeasuredOr(model) - model)(counted).squaredNorm();
  }
  return squares;
}

Eigen::MatrixXd HistoryResiduals::MarchedFrom(std::size_t h, const CondensedModel& model,
                                              const Eigen::MatrixXd& modelled) const {
  constexpr int kMostRounds = 8;
  constexpr double kVisible = 1e-4;
  const MeasuredHistory& history = histories_[h];
  const FreeMotion motion = FreeMotionOf(history, model);
  const Eigen::MatrixXd from_rest = simulations_[h].Run(model);
  Eigen::VectorXd offset = Eigen::VectorXd::Zero(motion.states.rows());
  Eigen::MatrixXd best = modelled;
  double least = SquaresOf(history, best);
  for (int round = 0; round < kMostRounds && motion.states.cols() > 0; ++round) {
    offset += motion.states * StartOf(history, motion, WeightsOf(history), history.Stride(), best);
    Eigen::MatrixXd moved = modelled + simulations_[h].RunWithOffset(model, offset) - from_rest;
    const double squares = SquaresOf(history, moved);
    if (!(squares < least)) break;
    const bool is_done = squares > (1 - kVisible) * least;
    best = std::move(moved);
    least = squares;
    if (is_done) break;
  }
  return best;
}

Eigen::MatrixXd HistoryResiduals::WithStart(std::size_t h, const std::vector<double>& values,
                                            const Eigen::MatrixXd& modelled) const {
  constexpr double kWorth = 0.1;
  const MeasuredHistory& history = histories_[h];
  const CondensedModel model = ModelOf(history, values);
  Eigen::MatrixXd best = modelled;
  AddStartTo(history, model, best);
  const std::vector<Damper>& dampers = condensed_->vehicle().dampers;
  const bool has_oil =
      std::any_of(dampers.begin(), dampers.end(), [](const Damper& damper) { return damper.hydraulic.has_value(); });
  try {
    if (!history.release && !has_oil) {
      const Eigen::MatrixXd marched = MarchedFrom(h, model, modelled);
      if (SquaresOf(history, marched) < SquaresOf(history, best)) best = marched;
    }
  } catch (const std::runtime_error&) {
    // A state from which the model cannot go on.
  }
  return SquaresOf(history, best) < (1 - kWorth) * SquaresOf(history, modelled) ? best : modelled;
}

Eigen::MatrixXd HistoryResiduals::Starts() const {
  std::vector<FreeMotion> motions;
  Index columns = 0;
  for (const MeasuredHistory& history : histories_) {
    const CondensedModel model = ModelOf(history, condensed_->vehicle().ParameterValues());
    motions.push_back(history.release ? FreeMotion() : FreeMotionOf(history, model));
    columns += motions.back().later.cols();
  }
  Eigen::MatrixXd starts = Eigen::MatrixXd::Zero(count_, columns);
  Index row = 0;
  Index column = 0;
  for (std::size_t h = 0; h < histories_.size(); ++h) {
    const MeasuredHistory& history = histories_[h];
    const Index each = CountOf(history);
    const Index here = motions[h].later.cols();
    for (std::size_t s = 0; s < history.signals.size(); ++s, row += each) {
      if (here == 0) continue;
      Eigen::MatrixXd rows = motions[h].Rows(static_cast<Index>(s), each, history.Stride());
      history.signals[s].KeepMeasured(history.Stride(), rows);
      starts.block(row, column, each, here) = rows / DeviationOf(history.signals[s]);
    }
    column += here;
  }
  return starts;
}

}  // namespace fourpost
