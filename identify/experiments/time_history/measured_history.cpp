#include "identify/experiments/time_history/measured_history.h"

#include <algorithm>
#include <cmath>

namespace fourpost {
namespace {

using Eigen::Index;

bool Changes(const std::vector<double>& signal) {
  return std::any_of(signal.begin(), signal.end(), [&](double value) { return value != signal.front(); });
}

}  // namespace

double MeasuredSignal::Deviation() const { return std::sqrt((values.array() - values.mean()).square().mean()); }

void MeasuredSignal::LeaveOut(Index k) {
  is_unknown.resize(static_cast<std::size_t>(values.size()));
  is_unknown[static_cast<std::size_t>(k)] = true;
}

Eigen::VectorXd MeasuredSignal::MeasuredOr(const Eigen::Ref<const Eigen::VectorXd>& modelled) const {
  if (is_unknown.empty()) return values;
  double sum = 0;
  double known = 0;
  for (Index k = 0; k < values.size(); ++k) {
    if (is_unknown[static_cast<std::size_t>(k)]) continue;
    sum += values[k] - modelled[k];
    ++known;
  }
  Eigen::VectorXd measured = values.array() - sum / std::max(1.0, known);
  for (Index k = 0; k < values.size(); ++k)
    if (is_unknown[static_cast<std::size_t>(k)]) measured[k] = modelled[k];
  return measured;
}

Index MeasuredSignal::UnknownCount(Index stride) const {
  Index count = 0;
  for (Index k = 0; k < std::ssize(is_unknown); k += stride) count += is_unknown[static_cast<std::size_t>(k)] ? 1 : 0;
  return count;
}

void MeasuredSignal::KeepMeasured(Index stride, Eigen::MatrixXd& rows) const {
  if (is_unknown.empty()) return;
  Eigen::VectorXd known(rows.rows());
  for (Index k = 0; k < known.size(); ++k) known[k] = is_unknown[static_cast<std::size_t>(k * stride)] ? 0 : 1;
  const Eigen::RowVectorXd mean = known.transpose() * rows / std::max(1.0, known.sum());
  rows = known.asDiagonal() * (rows.rowwise() - mean);
}

MeasuredHistory::Stretch MeasuredHistory::LongestMeasured() const {
  const auto is_measured = [](const MeasuredSignal& signal) { return signal.is_unknown.empty(); };
  if (std::all_of(signals.begin(), signals.end(), is_measured)) return {0, count};
  Stretch longest;
  Stretch here;
  for (Index k = 0; k < count; ++k) {
    const bool is_unknown = std::any_of(signals.begin(), signals.end(), [&](const MeasuredSignal& signal) {
      return !signal.is_unknown.empty() && signal.is_unknown[static_cast<std::size_t>(k)];
    });
    here = is_unknown ? Stretch{k + 1, 0} : Stretch{here.first, here.count + 1};
    if (here.count > longest.count) longest = here;
  }
  return longest;
}

bool MeasuredHistory::HasMovingActuator() const { return std::any_of(tensions.begin(), tensions.end(), Changes); }

bool MeasuredHistory::HasMovingPost() const { return std::any_of(heights.begin(), heights.end(), Changes); }

Index MeasuredHistory::Stride() const {
  constexpr double kSamplesPerPeriod = 3;
  if (!filter) return 1;
  return std::max<Index>(1, static_cast<Index>(rate_Hz / (kSamplesPerPeriod * filter->cutoff_Hz)));
}

}  // namespace fourpost
