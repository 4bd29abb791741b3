#pragma once

#include <span>

#include <Eigen/Core>

namespace fourpost {

/// Real samples of one cycle <-> complex harmonics 0..H with y(t) = Re sum Y_h exp(i h w t), sample k at w t = 2 pi
/// k/N. Exact both ways for signals without harmonics above H while N > 2 H; others alias.
///
/// Cosine and sine of even and odd harmonics are each even or odd about a quarter of the cycle, so only a quarter of
/// the tables and of the products is needed.
class CycleTransform {
 public:
  /// `samples`: a multiple of 4, more than twice the harmonics; throws std::invalid_argument otherwise.
  CycleTransform(int harmonics, int samples);

  /// The same, cached for all users of these numbers.
  static const CycleTransform& Shared(int harmonics, int samples);

  int harmonics() const { return static_cast<int>(even_cosine_.cols() + odd_cosine_.cols()) - 1; }
  Eigen::Index samples() const { return 4 * quarter_; }

  /// `harmonics`: (H + 1) x signals; `time`: samples x signals.
  void ToTime(const Eigen::MatrixXcd& harmonics, Eigen::MatrixXd& time) const;
  void ToHarmonics(const Eigen::MatrixXd& time, Eigen::MatrixXcd& harmonics) const;

 private:
  Eigen::Index quarter_;
  /// (N/4 + 1) x harmonics of that parity.
  Eigen::MatrixXd even_cosine_;
  Eigen::MatrixXd odd_cosine_;
  Eigen::MatrixXd even_sine_;
  Eigen::MatrixXd odd_sine_;
};

/// One of the signals, samples x signals; empty if there are none.
inline std::span<const double> Samples(const Eigen::MatrixXd& signals, Eigen::Index column) {
  if (signals.size() == 0) return {};
  return {signals.col(column).data(), static_cast<std::size_t>(signals.rows())};
}
inline std::span<double> Room(Eigen::MatrixXd& signals, Eigen::Index column) {
  return {signals.col(column).data(), static_cast<std::size_t>(signals.rows())};
}

}  // namespace fourpost
