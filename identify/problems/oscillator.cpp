#include "identify/problems/oscillator.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <ceres/jet.h>

namespace fourpost {
namespace {

constexpr int kSamples = 501;
constexpr double kSample_s = 0.01;

using Jet3 = ceres::Jet<double, 3>;

double ValueOf(double x) { return x; }
double ValueOf(const Jet3& x) { return x.a; }

template <typename T>
using Matrix4 = Eigen::Matrix<T, 4, 4>;

Eigen::VectorXd Chirp() {
  const double amplitude = 0.02, first_Hz = 0.5, last_Hz = 5, duration_s = (kSamples - 1) * kSample_s;
  Eigen::VectorXd u(kSamples);
  for (int i = 0; i < kSamples; ++i) {
    const double t = i * kSample_s;
    u[i] = amplitude * std::sin(2 * std::numbers::pi * (first_Hz * t + (last_Hz - first_Hz) * t * t / 2 / duration_s));
  }
  return u;
}

// Scaling and squaring: twelve terms of the series leave 1e-25 of a matrix below 1/16 in norm.
template <typename T>
Matrix4<T> Exponential(const Matrix4<T>& matrix) {
  double norm = 0;
  for (int i = 0; i < 4; ++i) {
    double row = 0;
    for (int j = 0; j < 4; ++j) row += std::abs(ValueOf(matrix(i, j)));
    norm = std::max(norm, row);
  }
  const int halvings = 4 + std::max(0, static_cast<int>(std::ceil(std::log2(norm))));
  const Matrix4<T> small = T(std::ldexp(1.0, -halvings)) * matrix;
  Matrix4<T> sum = Matrix4<T>::Identity(), term = Matrix4<T>::Identity();
  for (int k = 1; k <= 12; ++k) {
    term = (term * small / T(k)).eval();
    sum += term;
  }
  for (int k = 0; k < halvings; ++k) sum = (sum * sum).eval();
  return sum;
}

// Columns: z [m] and m z'' [N]. State (z, v, u, u') with v = z' - (d/m) u, so that u' does not enter the motion.
template <typename T>
Eigen::Matrix<T, Eigen::Dynamic, 2> Response(const T& m, const T& k, const T& d, const Eigen::VectorXd& u) {
  Matrix4<T> rates = Matrix4<T>::Zero();
  rates.row(0) << T(0), T(1), d / m, T(0);
  rates.row(1) << -k / m, -d / m, k / m - d * d / (m * m), T(0);
  rates(2, 3) = T(1);
  const Matrix4<T> step = Exponential<T>(T(kSample_s) * rates);
  Eigen::Matrix<T, Eigen::Dynamic, 2> response(u.size(), 2);
  Eigen::Matrix<T, 4, 1> state(T(0), -d / m * T(u[0]), T(0), T(0));
  for (Eigen::Index i = 0; i < u.size(); ++i) {
    const double slope = i + 1 < u.size() ? (u[i + 1] - u[i]) / kSample_s : 0;
    state[2] = T(u[i]);
    state[3] = T(slope);
    const T relative_rate = state[1] + d / m * u[i] - T(slope);
    response(i, 0) = state[0];
    response(i, 1) = -k * (state[0] - u[i]) - d * relative_rate;
    state = (step * state).eval();
  }
  return response;
}

}  // namespace

Problem OscillatorProblem() {
  struct Truth {
    Eigen::VectorXd u = Chirp();
    Eigen::MatrixX2d response = Response<double>(200, 15000, 1500, u);
    Eigen::RowVector2d sd;
    Truth() {
      const Eigen::RowVector2d mean = response.colwise().mean();
      sd = ((response.rowwise() - mean).colwise().squaredNorm() / kSamples).cwiseSqrt();
    }
  };
  const auto truth = std::make_shared<const Truth>();
  const auto evaluate = [truth](const Eigen::VectorXd& p) {
    const Eigen::MatrixX2d error = Response<double>(p[0], p[1], p[2], truth->u) - truth->response;
    const double scale = std::sqrt(100.0 / kSamples);
    Evaluation evaluation;
    evaluation.residuals.resize(2 * kSamples);
    evaluation.residuals << scale / truth->sd[0] * error.col(0), scale / truth->sd[1] * error.col(1);
    return evaluation;
  };
  const auto differentiate = [truth](const Eigen::VectorXd& p) {
    const auto response = Response(Jet3(p[0], 0), Jet3(p[1], 1), Jet3(p[2], 2), truth->u);
    const double scale = std::sqrt(100.0 / kSamples);
    Eigen::MatrixXd jacobian(2 * kSamples, 3);
    for (Eigen::Index c = 0; c < 2; ++c)
      for (Eigen::Index i = 0; i < kSamples; ++i)
        jacobian.row(c * kSamples + i) = scale / truth->sd[c] * response(i, c).v.transpose();
    return jacobian;
  };
  Problem problem{Lattice({{"m", 100, 600, 0.01}, {"k", 5000, 25000, 0.2}, {"d", 500, 3000, 0.05}}), evaluate,
                  2 * kSamples};
  problem.differentiate = differentiate;
  return problem;
}

}  // namespace fourpost
