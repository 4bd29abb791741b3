#include "analysis/frequency_response/settled_part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/signals/student_t.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

Complex MeanOf(std::span<const Complex> series) {
  Complex sum;
  for (const Complex& value : series) sum += value;
  return sum / static_cast<double>(series.size());
}

/// By differences of neighbours: independent ones differ by twice their variance.
double ScatterOf(std::span<const Complex> series) {
  double sum = 0;
  for (std::size_t k = 1; k < series.size(); ++k) sum += std::norm(series[k] - series[k - 1]);
  return series.size() > 1 ? sum / (2 * static_cast<double>(series.size() - 1)) : 0;
}

/// What the mean of one signal's last half is, and its blocks scatter by.
struct LastHalf {
  Complex mean;
  double blocks = 0;
  double variance = 0;
};

/// `least`: scatter that counts at least, as a share of the mean.
LastHalf LastHalfOf(std::span<const Complex> series, double least) {
  const std::span<const Complex> half = series.subspan(series.size() / 2);
  LastHalf last{.mean = MeanOf(half), .blocks = static_cast<double>(half.size())};
  last.variance = ScatterOf(half) + least * least * std::norm(last.mean);
  return last;
}

bool BeginsOff(std::span<const Complex> series, std::size_t first, std::size_t count, const LastHalf& last,
               double threshold) {
  const double n = static_cast<double>(count);
  const double off = std::norm(MeanOf(series.subspan(first, count)) - last.mean);
  return off > threshold * last.variance * (1 / n + 1 / last.blocks);
}

std::vector<std::size_t> LengthsFrom(std::size_t first, std::size_t blocks) {
  std::vector<std::size_t> lengths;
  const std::size_t half = (blocks - first) / 2;
  for (std::size_t length = 1; length < half; length *= 2) lengths.push_back(length);
  lengths.push_back(std::max<std::size_t>(1, half));
  return lengths;
}

/// By the lowest Fourier lines, over the number; 0 where these are too few.
double DensityAtZero(std::span<const Complex> series, Complex mean) {
  constexpr std::size_t kFewest = 3;
  constexpr std::size_t kMost = 4;
  const std::size_t n = series.size();
  const std::size_t lines = n / 6 < kFewest ? 0 : std::min(kMost, n / 6);
  double density = 0;
  for (std::size_t line = 1; line <= lines; ++line)
    for (const double sign : {-1.0, 1.0}) {
      Complex sum;
      for (std::size_t k = 0; k < n; ++k)
        sum += (series[k] - mean) * std::polar(1.0, sign * 2 * std::numbers::pi * static_cast<double>(line * k % n) /
                                                        static_cast<double>(n));
      density += std::norm(sum) / static_cast<double>(n);
    }
  return lines > 0 ? density / (2 * static_cast<double>(lines)) : 0;
}

/// Without what few numbers do not know.
double PlainVarianceOfMean(std::span<const Complex> series) {
  const double n = static_cast<double>(series.size());
  const Complex mean = MeanOf(series);
  double scatter = 0;
  for (const Complex& value : series) scatter += std::norm(value - mean);
  return std::max(scatter / (n - 1), DensityAtZero(series, mean)) / n;
}

}  // namespace

SettledPart SettledPartOf(std::span<const std::vector<Complex>> signals) {
  constexpr double kFalse = 1e-3;
  constexpr double kFine = 1e-3;
  constexpr double kCoarse = 5e-3;
  if (signals.empty() || signals.front().size() < 4) return {};
  const std::size_t blocks = signals.front().size();
  const std::size_t tests = signals.size() * LengthsFrom(0, blocks).size();
  // |off|^2 over the variance of one number is chi-square / 2: exp(-x) are beyond x. Few blocks know their scatter
  // poorly: Hotelling's T^2 in place of it.
  const double p = kFalse / static_cast<double>(tests);
  const double freedom = std::max(1.0, static_cast<double>(blocks - blocks / 2) - 1);
  const double threshold = freedom * (std::pow(p, -1 / freedom) - 1);
  const auto begins_off = [&](std::size_t first, double least) {
    for (const std::vector<Complex>& series : signals) {
      const LastHalf last = LastHalfOf(series, least);
      for (const std::size_t length : LengthsFrom(first, blocks))
        if (BeginsOff(series, first, length, last, threshold)) return true;
    }
    return false;
  };
  // A dwell's beginning is known to a cycle: what is short enough not to be seen would still bias the mean.
  constexpr std::size_t kEnough = 4;
  for (std::size_t first = blocks >= kEnough ? 1 : 0; first <= blocks / 2; ++first)
    if (!begins_off(first, kFine)) return {first, true};
  return {blocks / 2, !begins_off(blocks / 2, kCoarse)};
}

double VarianceOfMean(std::span<const Complex> series) {
  const std::size_t n = series.size();
  if (n < 3) return std::numeric_limits<double>::quiet_NaN();
  // Few numbers know their scatter poorly, of nine by 1.08 times the deviation.
  constexpr std::size_t kFew = 9;
  return PlainVarianceOfMean(series) * (n < kFew ? StudentFactor(2 * static_cast<double>(n) - 2) : 1);
}

double VarianceOfMean(std::span<const double> series) {
  const std::size_t n = series.size();
  if (n < 3) return std::numeric_limits<double>::quiet_NaN();
  return PlainVarianceOfMean(std::vector<Complex>(series.begin(), series.end())) *
         StudentFactor(static_cast<double>(n) - 1);
}

double StudentFactor(double degrees_of_freedom) {
  constexpr double kNormal95 = 1.959964;
  return std::pow(StudentT95(degrees_of_freedom) / kNormal95, 2);
}

}  // namespace fourpost
