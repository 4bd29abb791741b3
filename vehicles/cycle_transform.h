#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>

namespace fourpost {

/// Real samples of one cycle <-> complex harmonics 0..H with y(t) = Re sum Y_h exp(i h w t), sample k at w t = 2 pi
/// k/N. Exact both ways for signals without harmonics above H while N > 2 H; others alias.
class CycleTransform {
 public:
  CycleTransform(int harmonics, int samples) : cosine_(samples, harmonics + 1), sine_(samples, harmonics + 1) {
    for (int k = 0; k < samples; ++k)
      for (int h = 0; h <= harmonics; ++h) {
        const double angle = 2 * std::numbers::pi * h * k / samples;
        cosine_(k, h) = std::cos(angle);
        sine_(k, h) = std::sin(angle);
      }
  }

  /// `harmonics`: (H + 1) x signals; `time`: samples x signals.
  void ToTime(const Eigen::MatrixXcd& harmonics, Eigen::MatrixXd& time) const {
    time.noalias() = cosine_ * harmonics.real();
    time.noalias() -= sine_ * harmonics.imag();
  }

  void ToHarmonics(const Eigen::MatrixXd& time, Eigen::MatrixXcd& harmonics) const {
    const double scale = 2.0 / static_cast<double>(time.rows());
    harmonics.resize(cosine_.cols(), time.cols());
    harmonics.real().noalias() = scale * (cosine_.transpose() * time);
    harmonics.imag().noalias() = -scale * (sine_.transpose() * time);
    harmonics.row(0) *= 0.5;
  }

 private:
  Eigen::MatrixXd cosine_;
  Eigen::MatrixXd sine_;
};

}  // namespace fourpost
