#include "identify/problems/oscillator.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace fourpost {
namespace {

constexpr int kSamples = 501;
constexpr double kStep_s = 0.01;

using Matrix4 = Eigen::Matrix4d;

Eigen::VectorXd Chirp() {
  const double amplitude = 0.02, first_Hz = 0.5, last_Hz = 5, duration_s = (kSamples - 1) * kStep_s;
  Eigen::VectorXd u(kSamples);
  for (int i = 0; i < kSamples; ++i) {
    const double t = i * kStep_s;
    u[i] = amplitude * std::sin(2 * std::numbers::pi * (first_Hz * t + (last_Hz - first_Hz) * t * t / 2 / duration_s));
  }
  return u;
}

// Scaling and squaring: twelve terms of the series leave 1e-25 of a matrix below 1/16 in norm.
Matrix4 Exponential(const Matrix4& matrix) {
  const int halvings =
      4 + std::max(0, static_cast<int>(std::ceil(std::log2(matrix.cwiseAbs().rowwise().sum().maxCoeff()))));
  const Matrix4 small = std::ldexp(1.0, -halvings) * matrix;
  Matrix4 sum = Matrix4::Identity(), term = Matrix4::Identity();
  for (int k = 1; k <= 12; ++k) {
    term = (term * small / k).eval();
    sum += term;
  }
  for (int k = 0; k < halvings; ++k) sum = (sum * sum).eval();
  return sum;
}

// Columns: z [m] and m z'' [N]. State (z, v, u, u') with v = z' - (d/m) u, so that u' does not enter the motion.
Eigen::MatrixX2d Response(double m, double k, double d, const Eigen::VectorXd& u) {
  Matrix4 rates = Matrix4::Zero();
  rates.row(0) << 0, 1, d / m, 0;
  rates.row(1) << -k / m, -d / m, k / m - d * d / (m * m), 0;
  rates(2, 3) = 1;
  const Matrix4 step = Exponential(kStep_s * rates);
  Eigen::MatrixX2d response(u.size(), 2);
  Eigen::Vector4d state(0, -d / m * u[0], 0, 0);
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    const double slope = i + 1 < u.size() ? (u[i + 1] - u[i]) / kStep_s : 0;
    state.tail<2>() << u[i], slope;
    const double relative_rate = state[1] + d / m * u[i] - slope;
    response.row(i) << state[0], -k * (state[0] - u[i]) - d * relative_rate;
    state = step * state;
  }
  return response;
}

}  // namespace

Problem OscillatorProblem() {
  struct Truth {
    Eigen::VectorXd u = Chirp();
    Eigen::MatrixX2d response = Response(200, 15000, 1500, u);
    Eigen::RowVector2d sd;
    Truth() {
      const Eigen::RowVector2d mean = response.colwise().mean();
      sd = ((response.rowwise() - mean).colwise().squaredNorm() / kSamples).cwiseSqrt();
    }
  };
  const auto truth = std::make_shared<const Truth>();
  const auto evaluate = [truth](const Eigen::VectorXd& p) {
    const Eigen::MatrixX2d error = Response(p[0], p[1], p[2], truth->u) - truth->response;
    const double scale = std::sqrt(100.0 / kSamples);
    Evaluation evaluation;
    evaluation.residuals.resize(2 * kSamples);
    evaluation.residuals << scale / truth->sd[0] * error.col(0), scale / truth->sd[1] * error.col(1);
    return evaluation;
  };
  return {Lattice({{"m", 100, 600, 0.01}, {"k", 5000, 25000, 0.2}, {"d", 500, 3000, 0.05}}), evaluate, 2 * kSamples};
}

}  // namespace fourpost
