#include "identify/experiments/time_history/start_state.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

#include "analysis/numerics/decompositions.h"
#include "analysis/signals/low_pass.h"
#include "vehicles/condensed/linear_vehicle.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr double kLongest_s = 10;

/// Dashpots as linear ones.
CondensedModel AtSpeed(CondensedModel model) {
  constexpr double kSpeed = 0.1;  // m/s
  for (CondensedModel::Dashpot& dashpot : model.dashpots) {
    const double rate = (dashpot.law.Force(kSpeed) - dashpot.law.Force(-kSpeed)) / (2 * kSpeed);
    dashpot.law = DashpotLaw(rate, rate);
  }
  for (const CondensedModel::Rubbing& friction : model.rubbings)
    model.damping += friction.law.force / kSpeed * friction.direction * friction.direction.transpose();
  return model;
}

/// A mode by what the signals have of it at the first sample, and its eigenvalue.
struct FreeMode {
  std::complex<double> eigenvalue;
  Eigen::VectorXcd readings;
  Eigen::VectorXcd state;
};

std::vector<FreeMode> ModesOf(const MeasuredHistory& history, const CondensedModel& model) {
  const LinearVehicle linear(AtSpeed(model), LinearVehicle::Rates::kCentre);
  const Eigen::MatrixXd states = linear.StateMatrix();
  const Index n = model.mass.rows();
  Eigen::MatrixXd sensors = model.on_acceleration * states.middleRows(n, n);
  sensors.leftCols(n) += model.on_position;
  sensors.middleCols(n, n) += model.on_velocity;
  const Eigenpairs pairs = EigenpairsOf(states);
  std::vector<FreeMode> modes;
  if (!pairs.converged) return modes;
  for (Index i = 0; i < pairs.values.size(); ++i) {
    const std::complex<double> value = pairs.values[i];
    const bool is_short = value.real() < -history.rate_Hz;
    if (value.imag() < 0 || is_short) continue;
    FreeMode mode = {.eigenvalue = value,
                     .readings = Eigen::VectorXcd(static_cast<Index>(history.signals.size())),
                     .state = pairs.vectors.col(i)};
    for (std::size_t s = 0; s < history.signals.size(); ++s)
      mode.readings[static_cast<Index>(s)] =
          (sensors.row(static_cast<Index>(history.signals[s].sensor)) * pairs.vectors.col(i))(0);
    modes.push_back(std::move(mode));
  }
  return modes;
}

/// How long a filter rings on: its slowest pole falls by 1e-13 in this time.
double RingingOf(const std::optional<LowPassDesign>& filter) {
  constexpr double kTimeConstants = 30;
  if (!filter) return 0;
  const double slowest = 2 * std::numbers::pi * filter->cutoff_Hz * std::sin(std::numbers::pi / (2 * filter->order));
  return kTimeConstants / slowest;
}

/// From a record's first sample on, as far as something is left.
Index LastingSamples(const MeasuredHistory& history) {
  const double lasting = (kLongest_s + RingingOf(history.filter)) * history.rate_Hz;
  return std::min(history.first + history.count, static_cast<Index>(std::lround(lasting)));
}

/// Of one signal from the record's first sample on: what is left of it in the window.
Eigen::VectorXd InWindow(const MeasuredHistory& history, Eigen::VectorXd all) {
  if (const auto& filter = history.filter)
    LowPass(filter->order, filter->cutoff_Hz, history.rate_Hz)
        .Apply({all.data(), static_cast<std::size_t>(all.size())});
  return all.tail(std::max<Index>(0, all.size() - history.first));
}

/// Columns of a mode: what its real and imaginary part show of it.
Index ColumnsOf(const FreeMode& mode) { return mode.eigenvalue.imag() != 0 ? 2 : 1; }

/// A mode in one signal, from the record's first sample on.
Eigen::VectorXcd Decaying(const MeasuredHistory& history, const FreeMode& mode, Index signal) {
  const auto longest = static_cast<Index>(std::lround(kLongest_s * history.rate_Hz));
  const std::complex<double> step = std::exp(mode.eigenvalue / history.rate_Hz);
  Eigen::VectorXcd all = Eigen::VectorXcd::Zero(LastingSamples(history));
  std::complex<double> now = mode.readings[signal];
  for (Index k = 0; k < std::min(longest, all.size()); ++k, now *= step) all[k] = now;
  return all;
}

}  // namespace

Eigen::MatrixXd FreeMotion::Rows(Index signal, Index count, Index stride) const {
  const Eigen::MatrixXd& held = first[static_cast<std::size_t>(signal)];
  Eigen::MatrixXd rows(count, held.cols());
  for (Index k = 0; k < count; ++k) rows.row(k) = k * stride < held.rows() ? held.row(k * stride) : later.row(signal);
  return rows;
}

FreeMotion FreeMotionOf(const MeasuredHistory& history, const CondensedModel& model) {
  const std::vector<FreeMode> modes = ModesOf(history, model);
  const auto signals = static_cast<Index>(history.signals.size());
  Index columns = 0;
  for (const FreeMode& mode : modes) columns += ColumnsOf(mode);
  const Index held = std::max<Index>(0, LastingSamples(history) - history.first);
  FreeMotion motion = {.first = std::vector<Eigen::MatrixXd>(history.signals.size(), Eigen::MatrixXd(held, columns)),
                       .later = Eigen::MatrixXd(signals, columns),
                       .states = Eigen::MatrixXd(modes.empty() ? 0 : modes.front().state.size(), columns)};
  Index next = 0;
  for (const FreeMode& mode : modes) {
    motion.states.col(next++) = mode.state.real();
    if (ColumnsOf(mode) == 2) motion.states.col(next++) = mode.state.imag();
  }
  for (Index s = 0; s < signals; ++s) {
    Eigen::MatrixXd& first = motion.first[static_cast<std::size_t>(s)];
    Index column = 0;
    for (const FreeMode& mode : modes) {
      const Eigen::VectorXcd all = Decaying(history, mode, s);
      first.col(column) = InWindow(history, all.real());
      if (ColumnsOf(mode) == 2) first.col(column + 1) = InWindow(history, all.imag());
      column += ColumnsOf(mode);
    }
    motion.later.row(s) = -first.colwise().sum() / static_cast<double>(history.count);
    first.rowwise() += motion.later.row(s);
  }
  return motion;
}

Eigen::VectorXd StartOf(const MeasuredHistory& history, const FreeMotion& motion, const Eigen::VectorXd& weights,
                        Index stride, const Eigen::MatrixXd& modelled) {
  // Of normalised columns: motions that no signal tells apart share what there is.
  constexpr double kRidge = 1e-9;
  const Index columns = motion.later.cols();
  const Index held = motion.first.empty() ? 0 : motion.first.front().rows();
  const Index rows = (history.count + stride - 1) / stride;
  const Index first_rows = std::min(rows, (held + stride - 1) / stride);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(columns, columns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(columns);
  for (Index s = 0; s < modelled.cols(); ++s) {
    const MeasuredSignal& signal = history.signals[static_cast<std::size_t>(s)];
    const Eigen::VectorXd missing =
        (signal.MeasuredOr(modelled.col(s)) - modelled.col(s))(Eigen::seqN(0, rows, stride));
    if (!signal.is_unknown.empty()) {
      Eigen::MatrixXd all = motion.Rows(s, rows, stride);
      signal.KeepMeasured(stride, all);
      normal += weights[s] * (all.transpose() * all);
      right += weights[s] * (all.transpose() * missing);
      continue;
    }
    const Eigen::MatrixXd part = motion.Rows(s, first_rows, stride);
    const Eigen::VectorXd later = motion.later.row(s).transpose();
    normal += weights[s] * (part.transpose() * part);
    normal += weights[s] * static_cast<double>(rows - first_rows) * later * later.transpose();
    right += weights[s] * (part.transpose() * missing.head(first_rows) + missing.tail(rows - first_rows).sum() * later);
  }
  const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt().unaryExpr([](double d) { return d > 0 ? 1 / d : 0; });
  Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  scaled.diagonal().array() += kRidge;
  return scale.cwiseProduct(Solved(scaled, Eigen::VectorXd(scale.cwiseProduct(right))));
}

void AddStart(const MeasuredHistory& history, const CondensedModel& model, const Eigen::VectorXd& weights, Index stride,
              Eigen::MatrixXd& modelled) {
  const FreeMotion motion = FreeMotionOf(history, model);
  const Eigen::VectorXd start = StartOf(history, motion, weights, stride, modelled);
  const Index held = motion.first.empty() ? 0 : motion.first.front().rows();
  for (Index s = 0; s < modelled.cols(); ++s) {
    modelled.col(s).head(held) += motion.first[static_cast<std::size_t>(s)] * start;
    modelled.col(s).tail(history.count - held).array() += motion.later.row(s).dot(start);
  }
}

}  // namespace fourpost
