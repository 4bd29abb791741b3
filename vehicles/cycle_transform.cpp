#include "vehicles/cycle_transform.h"

#include <cmath>
#include <numbers>

#include "analysis/option_check.h"

namespace fourpost {
namespace {

/// Signals of a quarter of the cycle, both ends included.
using Quarter = Eigen::VectorXd;

}  // namespace

CycleTransform::CycleTransform(int harmonics, int samples) : quarter_(samples / 4) {
  RequireOption(samples % 4 == 0 && samples > 2 * harmonics, "samples", samples,
                "a multiple of 4 and more than twice the harmonics");
  const Eigen::Index rows = quarter_ + 1;
  even_cosine_.resize(rows, harmonics / 2 + 1);
  even_sine_.resize(rows, harmonics / 2 + 1);
  odd_cosine_.resize(rows, (harmonics + 1) / 2);
  odd_sine_.resize(rows, (harmonics + 1) / 2);
  for (Eigen::Index k = 0; k < rows; ++k)
    for (int h = 0; h <= harmonics; ++h) {
      const double angle = 2 * std::numbers::pi * h * static_cast<double>(k) / samples;
      (h % 2 == 0 ? even_cosine_ : odd_cosine_)(k, h / 2) = std::cos(angle);
      (h % 2 == 0 ? even_sine_ : odd_sine_)(k, h / 2) = std::sin(angle);
    }
}

void CycleTransform::ToTime(const Eigen::MatrixXcd& harmonics, Eigen::MatrixXd& time) const {
  const Eigen::Index n = samples();
  time.resize(n, harmonics.cols());
  Quarter sum(quarter_ + 1);   // even + odd cosines
  Quarter rest(quarter_ + 1);  // even - odd
  Quarter even(quarter_ + 1);
  Quarter odd(quarter_ + 1);
  for (Eigen::Index j = 0; j < harmonics.cols(); ++j) {
    const auto real = harmonics.col(j).real();
    const auto imag = harmonics.col(j).imag();
    const auto evens = Eigen::seqN(0, even_cosine_.cols(), 2);
    const auto odds = Eigen::seqN(1, odd_cosine_.cols(), 2);
    even.noalias() = even_cosine_.lazyProduct(real(evens));
    odd.noalias() = odd_cosine_.lazyProduct(real(odds));
    sum = even + odd;
    rest = even - odd;
    even.noalias() = even_sine_.lazyProduct(-imag(evens));
    odd.noalias() = odd_sine_.lazyProduct(-imag(odds));
    double* y = time.col(j).data();
    for (Eigen::Index k = 0; k <= quarter_; ++k) {
      y[n / 2 - k] = rest[k] + odd[k] - even[k];
      y[n / 2 + k] = rest[k] - odd[k] + even[k];
      if (k > 0) y[n - k] = sum[k] - even[k] - odd[k];
      y[k] = sum[k] + even[k] + odd[k];
    }
  }
}

void CycleTransform::ToHarmonics(const Eigen::MatrixXd& time, Eigen::MatrixXcd& harmonics) const {
  const Eigen::Index n = samples();
  const double scale = 2.0 / static_cast<double>(n);
  harmonics.resize(even_cosine_.cols() + odd_cosine_.cols(), time.cols());
  Quarter even_cosine(quarter_ + 1);
  Quarter odd_cosine(quarter_ + 1);
  Quarter even_sine(quarter_ + 1);
  Quarter odd_sine(quarter_ + 1);
  const auto evens = Eigen::seqN(0, even_cosine_.cols(), 2);
  const auto odds = Eigen::seqN(1, odd_cosine_.cols(), 2);
  for (Eigen::Index j = 0; j < time.cols(); ++j) {
    const double* y = time.col(j).data();
    for (Eigen::Index k = 0; k <= quarter_; ++k) {
      const double mirrored = k > 0 ? y[n - k] : y[0];
      // The ends of the quarter fold onto themselves.
      const double weight = k == 0 || k == quarter_ ? 0.5 * scale : scale;
      const double sum = weight * (y[k] + mirrored);
      const double difference = weight * (y[k] - mirrored);
      const double far_sum = weight * (y[n / 2 - k] + y[n / 2 + k]);
      const double far_difference = weight * (y[n / 2 - k] - y[n / 2 + k]);
      even_cosine[k] = sum + far_sum;
      odd_cosine[k] = sum - far_sum;
      even_sine[k] = difference - far_difference;
      odd_sine[k] = difference + far_difference;
    }
    auto out = harmonics.col(j);
    out(evens).real() = even_cosine_.transpose().lazyProduct(even_cosine);
    out(evens).imag() = -even_sine_.transpose().lazyProduct(even_sine);
    out(odds).real() = odd_cosine_.transpose().lazyProduct(odd_cosine);
    out(odds).imag() = -odd_sine_.transpose().lazyProduct(odd_sine);
    out[0] *= 0.5;
  }
}

}  // namespace fourpost
