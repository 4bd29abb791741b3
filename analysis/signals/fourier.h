#pragma once

#include <span>

#include <Eigen/Core>

namespace fourpost {

/// Harmonics Y_0..Y_count of a periodic signal, y(t) = Re sum_h Y_h exp(i h w t), the first sample at t = 0; Y_0 is the
/// mean. They have the unit of the samples.
///
/// The samples span exactly `cycles` whole cycles, that is samples.size() = cycles * F_s / f, and the rectangle rule
///   Y_h = (2 / N) sum_n y_n exp(-2 pi i h cycles n / N),  Y_0 half of it,
/// is exact for a signal without harmonics from N / (2 cycles) upwards (thesis, eqs. 4.23-4.27, which print F_s for the
/// F_s / f samples of a cycle). With F_s / f rounded it errs by 0.2-0.4 dB at 30 Hz: use HarmonicsByLeastSquares then.
/// Throws std::invalid_argument unless cycles > 0, count >= 0 and count * cycles < N / 2.
Eigen::VectorXcd Harmonics(std::span<const double> samples, int cycles, int count);

/// The same for any number of samples of at least one cycle, `samples_per_cycle` = F_s / f need not be whole: the
/// least-squares fit (QR) of 1, cos h w t, sin h w t for h = 1..count. Exact for a signal without higher harmonics.
/// Throws std::invalid_argument unless count >= 0, samples_per_cycle > 2 count, and there is a cycle of samples.
Eigen::VectorXcd HarmonicsByLeastSquares(std::span<const double> samples, double samples_per_cycle, int count);

}  // namespace fourpost
