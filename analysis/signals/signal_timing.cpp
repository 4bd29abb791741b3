#include "analysis/signals/signal_timing.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Of samples k of the one and k - lag of the other.
struct Overlap {
  Index first = 0;
  Index count = 0;
};

Overlap OverlapAt(Index lag, Index size) { return {std::max<Index>(0, lag), size - std::abs(lag)}; }

Index BestLag(const Eigen::VectorXd& measured, const Eigen::VectorXd& modelled, Index most) {
  Index best = 0;
  double largest = -1;
  for (Index lag = -most; lag <= most; ++lag) {
    const Overlap part = OverlapAt(lag, measured.size());
    const auto ours = measured.segment(part.first, part.count);
    const auto theirs = modelled.segment(part.first - lag, part.count);
    const double correlation = std::abs(ours.dot(theirs)) / std::max(1e-300, ours.norm() * theirs.norm());
    if (correlation <= largest) continue;
    largest = correlation;
    best = lag;
  }
  return best;
}

}  // namespace

SignalTiming TimingOf(const Eigen::VectorXd& measured, const Eigen::VectorXd& modelled, double rate_Hz) {
  RequireOption(measured.size() >= 16, "TimingOf: samples", static_cast<double>(measured.size()), "16 at least");
  RequireOption(modelled.size() == measured.size(), "TimingOf: modelled samples", static_cast<double>(modelled.size()),
                "as many as measured ones");
  const auto most = std::min<Index>(std::lround(rate_Hz / 4), measured.size() / 4);
  const Index lag = BestLag(measured, modelled, most);
  const Overlap part = OverlapAt(lag, measured.size());
  const Index inner = part.count - 2;
  const Index at = part.first - lag;
  Eigen::MatrixX2d columns(inner, 2);
  columns.col(0) = modelled.segment(at + 1, inner);
  columns.col(1) = 0.5 * rate_Hz * (modelled.segment(at + 2, inner) - modelled.segment(at, inner));
  const Eigen::VectorXd ours = measured.segment(part.first + 1, inner);
  const Eigen::Vector2d solution = columns.colPivHouseholderQr().solve(ours);
  const double spread = (ours.array() - ours.mean()).square().sum();
  return {.gain = solution[0],
          .delay_s = static_cast<double>(lag) / rate_Hz - solution[1] / solution[0],
          .nmse_percent = 100 * (ours - columns * solution).squaredNorm() / spread};
}

}  // namespace fourpost
