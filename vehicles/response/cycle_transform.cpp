#include "vehicles/response/cycle_transform.h"

#include <cmath>
#include <complex>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

void AddScaled(double factor, const double* __restrict__ from, Eigen::Index count, double* __restrict__ to) {
  for (Eigen::Index k = 0; k < count; ++k) to[k] += factor * from[k];
}

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

const CycleTransform& CycleTransform::Shared(int harmonics, int samples) {
  static std::mutex mutex;
  static std::map<std::pair<int, int>, CycleTransform> transforms;
  const std::lock_guard lock(mutex);
  return transforms.try_emplace({harmonics, samples}, harmonics, samples).first->second;
}

void CycleTransform::ToTime(const Eigen::MatrixXcd& harmonics, Eigen::MatrixXd& time) const {
  const Eigen::Index n = samples();
  time.resize(n, harmonics.cols());
  Eigen::Matrix<double, Eigen::Dynamic, 4> sums(quarter_ + 1, 4);
  double* even_cosine = sums.col(0).data();
  double* odd_cosine = sums.col(1).data();
  double* even_sine = sums.col(2).data();
  double* odd_sine = sums.col(3).data();
  for (Eigen::Index j = 0; j < harmonics.cols(); ++j) {
    sums.setZero();
    for (Eigen::Index h = 0; h < harmonics.rows(); ++h) {
      const bool even = h % 2 == 0;
      AddScaled(harmonics(h, j).real(), (even ? even_cosine_ : odd_cosine_).col(h / 2).data(), quarter_ + 1,
                even ? even_cosine : odd_cosine);
      AddScaled(-harmonics(h, j).imag(), (even ? even_sine_ : odd_sine_).col(h / 2).data(), quarter_ + 1,
                even ? even_sine : odd_sine);
    }
    double* y = time.col(j).data();
    for (Eigen::Index k = 0; k <= quarter_; ++k) {
      const double near_cosine = even_cosine[k] + odd_cosine[k];
      const double far_cosine = even_cosine[k] - odd_cosine[k];
      const double near_sine = odd_sine[k] + even_sine[k];
      const double far_sine = odd_sine[k] - even_sine[k];
      y[n / 2 - k] = far_cosine + far_sine;
      y[n / 2 + k] = far_cosine - far_sine;
      if (k > 0) y[n - k] = near_cosine - near_sine;
      y[k] = near_cosine + near_sine;
    }
  }
}

void CycleTransform::ToHarmonics(const Eigen::MatrixXd& time, Eigen::MatrixXcd& harmonics) const {
  const Eigen::Index n = samples();
  const double scale = 2.0 / static_cast<double>(n);
  harmonics.resize(even_cosine_.cols() + odd_cosine_.cols(), time.cols());
  Eigen::Matrix<double, Eigen::Dynamic, 4> folds(quarter_ + 1, 4);
  Eigen::VectorXd sums(even_cosine_.cols());
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
      folds(k, 0) = sum + far_sum;
      folds(k, 1) = sum - far_sum;
      folds(k, 2) = far_difference - difference;
      folds(k, 3) = -far_difference - difference;
    }
    Complex* out = harmonics.col(j).data();
    sums = even_cosine_.transpose().lazyProduct(folds.col(0));
    for (Eigen::Index h = 0; h < even_cosine_.cols(); ++h) out[2 * h].real(sums[h]);
    sums = even_sine_.transpose().lazyProduct(folds.col(2));
    for (Eigen::Index h = 0; h < even_sine_.cols(); ++h) out[2 * h].imag(sums[h]);
    sums.head(odd_cosine_.cols()) = odd_cosine_.transpose().lazyProduct(folds.col(1));
    for (Eigen::Index h = 0; h < odd_cosine_.cols(); ++h) out[2 * h + 1].real(sums[h]);
    sums.head(odd_sine_.cols()) = odd_sine_.transpose().lazyProduct(folds.col(3));
    for (Eigen::Index h = 0; h < odd_sine_.cols(); ++h) out[2 * h + 1].imag(sums[h]);
    out[0] *= 0.5;
  }
}

}  // namespace fourpost
