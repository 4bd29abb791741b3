#include "identify/experiments/time_history/start_state.h"

#include <algorithm>
#include <cmath>
#include <complex>
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
  return model;
}

/// A mode by what the signals have of it at the first sample, and its eigenvalue.
struct FreeMode {
  std::complex<double> eigenvalue;
  Eigen::VectorXcd readings;
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
    FreeMode mode = {.eigenvalue = value, .readings = Eigen::VectorXcd(static_cast<Index>(history.signals.size()))};
    for (std::size_t s = 0; s < history.signals.size(); ++s)
      mode.readings[static_cast<Index>(s)] =
          (sensors.row(static_cast<Index>(history.signals[s].sensor)) * pairs.vectors.col(i))(0);
    modes.push_back(std::move(mode));
  }
  return modes;
}

/// Of one signal: samples of the window.
Eigen::VectorXd InWindow(const MeasuredHistory& history, Eigen::VectorXd all) {
  if (const auto& filter = history.filter)
    LowPass(filter->order, filter->cutoff_Hz, history.rate_Hz)
        .Apply({all.data(), static_cast<std::size_t>(all.size())});
  return WithoutMean(all.tail(history.count));
}

}  // namespace

Eigen::MatrixXd FreeMotions(const MeasuredHistory& history, const CondensedModel& model) {
  const std::vector<FreeMode> modes = ModesOf(history, model);
  const auto signals = static_cast<Index>(history.signals.size());
  const Index samples = history.first + history.count;
  const Index lasting = std::min(samples, static_cast<Index>(std::lround(kLongest_s * history.rate_Hz)));
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(history.count * signals, 2 * static_cast<Index>(modes.size()));
  Index column = 0;
  for (const FreeMode& mode : modes) {
    const std::complex<double> step = std::exp(mode.eigenvalue / history.rate_Hz);
    for (Index s = 0; s < signals; ++s) {
      Eigen::VectorXcd all = Eigen::VectorXcd::Zero(samples);
      std::complex<double> now = mode.readings[s];
      for (Index k = 0; k < lasting; ++k, now *= step) all[k] = now;
      motions.col(column).segment(s * history.count, history.count) = InWindow(history, all.real());
      if (mode.eigenvalue.imag() != 0)
        motions.col(column + 1).segment(s * history.count, history.count) = InWindow(history, all.imag());
    }
    column += mode.eigenvalue.imag() != 0 ? 2 : 1;
  }
  return motions.leftCols(column);
}

void AddStart(const MeasuredHistory& history, const CondensedModel& model, const Eigen::VectorXd& weights, Index stride,
              Eigen::MatrixXd& modelled) {
  // Of normalised columns: motions that no signal tells apart share what there is.
  constexpr double kRidge = 1e-9;
  const Eigen::MatrixXd motions = FreeMotions(history, model);
  const Index count = motions.cols();
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  const Index rows = (history.count + stride - 1) / stride;
  for (Index s = 0; s < modelled.cols(); ++s) {
    const auto strided = Eigen::seqN(s * history.count, rows, stride);
    const Eigen::MatrixXd part = motions(strided, Eigen::all);
    const Eigen::VectorXd missing =
        (history.signals[static_cast<std::size_t>(s)].values - modelled.col(s))(Eigen::seqN(0, rows, stride));
    normal += weights[s] * part.transpose() * part;
    right += weights[s] * part.transpose() * missing;
  }
  const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt().unaryExpr([](double d) { return d > 0 ? 1 / d : 0; });
  Eigen::MatrixXd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  scaled.diagonal().array() += kRidge;
  const Eigen::VectorXd start = scale.cwiseProduct(Solved(scaled, Eigen::VectorXd(scale.cwiseProduct(right))));
  modelled += (motions * start).reshaped(history.count, modelled.cols());
}

}  // namespace fourpost
