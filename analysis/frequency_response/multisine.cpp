#include "analysis/frequency_response/multisine.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <unsupported/Eigen/FFT>

#include "analysis/frequency_response/settled_part.h"
#include "analysis/signals/deviation.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Of lags 0 to half the signal: the product of the parts that lie on each other, over the powers of both, so that a
/// whole repeat has 1 whatever part of a period is at the ends.
std::vector<double> Autocorrelation(std::span<const double> signal) {
  std::size_t size = 1;
  while (size < 2 * signal.size()) size *= 2;
  const double mean = Mean(signal);
  std::vector<double> padded(size, 0.0);
  std::transform(signal.begin(), signal.end(), padded.begin(), [mean](double value) { return value - mean; });
  std::vector<double> energy(signal.size() + 1);
  for (std::size_t k = 0; k < signal.size(); ++k) energy[k + 1] = energy[k] + padded[k] * padded[k];
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<Complex> spectrum;
  transform.fwd(spectrum, padded);
  for (Complex& line : spectrum) line = std::norm(line);
  transform.inv(padded, spectrum);
  std::vector<double> correlation(signal.size() / 2);
  for (std::size_t lag = 0; lag < correlation.size(); ++lag) {
    const double powers = energy[signal.size() - lag] * (energy.back() - energy[lag]);
    correlation[lag] = powers > 0 ? padded[lag] / std::sqrt(powers) : 0;
  }
  return correlation;
}

/// Samples about a peak at which a fiftieth of it is lost, where it still is a parabola; one at least.
std::size_t ReachOf(const std::vector<double>& values, std::size_t peak) {
  constexpr double kLost = 0.02;
  std::size_t reach = 1;
  while (reach < peak && peak + reach + 1 < values.size() &&
         values[peak - reach] + values[peak + reach] > 2 * (1 - kLost) * values[peak])
    ++reach;
  return reach;
}

/// A peak between samples, by the least-squares parabola through those in its reach.
struct Peak {
  double place = 0;
  /// Second derivative, its sign turned.
  double curvature = 0;
};

Peak PeakNear(const std::vector<double>& values, std::size_t peak, std::size_t reach) {
  const std::size_t r = std::min({reach, peak, values.size() - 1 - peak});
  double second = 0;
  double fourth = 0;
  double sum = 0;
  double slope = 0;
  double bend = 0;
  for (std::size_t k = peak - r; k <= peak + r; ++k) {
    const double off = static_cast<double>(k) - static_cast<double>(peak);
    second += off * off;
    fourth += off * off * off * off;
    sum += values[k];
    slope += off * values[k];
    bend += off * off * values[k];
  }
  const double count = static_cast<double>(2 * r + 1);
  const double curvature = -2 * (bend - second * sum / count) / (fourth - second * second / count);
  return {static_cast<double>(peak) + slope / second / curvature, curvature};
}

/// Largest of the values within `reach` samples of `about`.
std::size_t Largest(const std::vector<double>& values, std::size_t about, std::size_t reach) {
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(about > reach ? about - reach : 0);
  const auto last = values.begin() + static_cast<std::ptrdiff_t>(std::min(values.size(), about + reach + 1));
  return static_cast<std::size_t>(std::max_element(first, last) - values.begin());
}

/// Lines 1.. of each whole period: amplitudes of cosines.
class PeriodSpectra {
 public:
  PeriodSpectra(std::span<const double> signal, std::size_t period) {
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::vector<double> buffer(period);
    for (std::size_t first = 0; first + period <= signal.size(); first += period) {
      std::copy_n(signal.begin() + static_cast<std::ptrdiff_t>(first), period, buffer.begin());
      std::vector<Complex> spectrum;
      transform.fwd(spectrum, buffer);
      for (Complex& line : spectrum) line *= 2 / static_cast<double>(period);
      spectra_.push_back(std::move(spectrum));
    }
  }

  std::size_t periods() const { return spectra_.size(); }
  std::size_t lines() const { return spectra_.front().size() - 1; }
  Complex At(std::size_t period, std::size_t line) const { return spectra_[period][line]; }

  std::vector<Complex> Mean(std::size_t first) const {
    std::vector<Complex> mean(spectra_.front().size());
    for (std::size_t m = first; m < spectra_.size(); ++m)
      for (std::size_t k = 0; k < mean.size(); ++k)
        mean[k] += spectra_[m][k] / static_cast<double>(spectra_.size() - first);
    return mean;
  }

 private:
  std::vector<std::vector<Complex>> spectra_;
};

std::vector<std::size_t> ExcitedLines(const PeriodSpectra& spectra) {
  constexpr double kShare = 0.1;
  // Above the highest line there are only noise and distortion of the rig.
  constexpr double kLeast = 1e-3;
  constexpr double kAboveNoise = 100;
  const std::size_t first = spectra.periods() / 2;
  const std::vector<Complex> mean = spectra.Mean(first);
  std::vector<double> noise(mean.size());
  for (std::size_t m = first + 1; m < spectra.periods(); ++m)
    for (std::size_t k = 0; k < mean.size(); ++k) noise[k] += std::norm(spectra.At(m, k) - spectra.At(m - 1, k)) / 2;
  // A line of few periods may happen to scatter little: those about it as well count.
  constexpr std::size_t kReach = 5;
  const double differences = static_cast<double>(spectra.periods() - first - 1);
  const auto noise_near = [&](std::size_t k) {
    double sum = 0;
    const std::size_t lower = k > kReach ? k - kReach : 1;
    const std::size_t upper = std::min(mean.size(), k + kReach + 1);
    for (std::size_t j = lower; j < upper; ++j) sum += noise[j] / differences;
    return sum / static_cast<double>(upper - lower) / (differences + 1);
  };
  double largest = 0;
  for (std::size_t k = 1; k < mean.size(); ++k) largest = std::max(largest, std::abs(mean[k]));
  std::vector<std::size_t> lines;
  for (std::size_t k = 1; k + 1 < mean.size(); ++k) {
    double near = 0;
    for (std::size_t j = std::max<std::size_t>(1, 3 * k / 4); j < std::min(mean.size(), 5 * k / 4 + 2); ++j)
      near = std::max(near, std::abs(mean[j]));
    if (std::abs(mean[k]) >= kShare * near && std::abs(mean[k]) > kLeast * largest &&
        std::norm(mean[k]) > kAboveNoise * noise_near(k))
      lines.push_back(k);
  }
  return lines;
}

Complex Interpolated(const std::vector<std::size_t>& lines, const std::vector<Complex>& values, std::size_t line) {
  const auto above = std::upper_bound(lines.begin(), lines.end(), line);
  if (above == lines.begin()) return values.front();
  if (above == lines.end()) return values.back();
  const auto k = static_cast<std::size_t>(above - lines.begin());
  const double share = static_cast<double>(line - lines[k - 1]) / static_cast<double>(lines[k] - lines[k - 1]);
  return values[k - 1] + share * (values[k] - values[k - 1]);
}

/// One channel against the reference.
class LineFit {
 public:
  LineFit(const PeriodSpectra& reference, const PeriodSpectra& channel, std::size_t first,
          const std::vector<std::size_t>& lines)
      : reference_(reference),
        channel_(channel),
        first_(first),
        lines_(lines),
        x_(reference.Mean(first)),
        y_(channel.Mean(first)) {}

  LineResponse Respond() const {
    LineResponse out;
    const double periods = static_cast<double>(channel_.periods() - first_);
    double excited = 0;
    double noise = 0;
    for (const std::size_t line : lines_) {
      out.response.push_back(y_[line] / x_[line]);
      const double variance = VarianceAt(line, out.response.back());
      noise += variance;
      excited += std::norm(y_[line]);
      out.noise_variance.push_back(variance / periods / std::norm(x_[line]));
    }
    out.noise = std::sqrt(noise / excited);
    const double count = static_cast<double>(lines_.size());
    const std::vector<Bin> odd = Unexcited(1, out.response);
    const std::vector<Bin> even = Unexcited(0, out.response);
    const auto share = [&](const std::vector<Bin>& bins) {
      if (bins.empty()) return std::numeric_limits<double>::quiet_NaN();
      double sum = 0;
      for (const Bin& bin : bins) sum += bin.distortion;
      return std::sqrt(std::max(0.0, sum / static_cast<double>(bins.size())) * count / excited);
    };
    out.odd_distortion = share(odd);
    out.even_distortion = share(even);
    for (std::size_t i = 0; i < lines_.size(); ++i)
      out.variance.push_back(out.noise_variance[i] + DistortionNear(lines_[i], odd) / std::norm(x_[lines_[i]]));
    return out;
  }

 private:
  struct Bin {
    std::size_t line = 0;
    double distortion = 0;
  };

  /// Of one period: of Y - H X.
  double VarianceAt(std::size_t line, Complex response) const {
    const Complex mean = y_[line] - response * x_[line];
    double sum = 0;
    for (std::size_t m = first_; m < channel_.periods(); ++m)
      sum += std::norm(channel_.At(m, line) - response * reference_.At(m, line) - mean);
    return sum / static_cast<double>(channel_.periods() - first_ - 1);
  }

  std::vector<Bin> Unexcited(std::size_t parity, const std::vector<Complex>& response) const {
    const double periods = static_cast<double>(channel_.periods() - first_);
    std::vector<Bin> bins;
    for (std::size_t line = lines_.front(); line < lines_.back(); ++line) {
      if (line % 2 != parity || std::binary_search(lines_.begin(), lines_.end(), line)) continue;
      const Complex linear = Interpolated(lines_, response, line);
      bins.push_back({line, std::norm(y_[line] - linear * x_[line]) - VarianceAt(line, linear) / periods});
    }
    return bins;
  }

  /// Mean of the eight nearest.
  static double DistortionNear(std::size_t line, const std::vector<Bin>& bins) {
    constexpr std::size_t kReach = 4;
    if (bins.empty()) return 0;
    const auto above = std::lower_bound(bins.begin(), bins.end(), line,
                                        [](const Bin& bin, std::size_t value) { return bin.line < value; });
    const auto at = static_cast<std::size_t>(above - bins.begin());
    const std::size_t first = at > kReach ? at - kReach : 0;
    const std::size_t last = std::min(bins.size(), at + kReach);
    double sum = 0;
    for (std::size_t k = first; k < last; ++k) sum += bins[k].distortion;
    return std::max(0.0, sum / static_cast<double>(last - first));
  }

  const PeriodSpectra& reference_;
  const PeriodSpectra& channel_;
  std::size_t first_;
  const std::vector<std::size_t>& lines_;
  std::vector<Complex> x_;
  std::vector<Complex> y_;
};

}  // namespace

std::optional<std::size_t> PeriodOf(std::span<const double> signal, double kept) {
  constexpr std::size_t kLeast = 16;
  if (signal.size() < 3 * kLeast || !(DeviationOf(signal) > 0)) return std::nullopt;
  const std::vector<double> correlation = Autocorrelation(signal);
  // The first decay belongs to the same period.
  std::size_t lag = 0;
  while (lag < correlation.size() && correlation[lag] > 0.5) ++lag;
  const std::size_t first = std::max(lag, kLeast);
  // Three periods may be all there is, and a peak needs neighbours.
  const std::size_t last = std::min(signal.size() / 3, correlation.size() - 2);
  if (first > last) return std::nullopt;
  const auto begin = correlation.begin() + static_cast<std::ptrdiff_t>(first);
  const double highest = *std::max_element(begin, correlation.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  if (highest < kept) return std::nullopt;
  // What noise takes from a whole repeat, and the deviation of that: noise n of a share times the signal, over all
  // samples. A strong line alone comes back earlier, but not as near.
  const double lost = std::max(0.0, 1 - highest);
  const double deviation = std::sqrt(2 * lost / static_cast<double>(signal.size()));
  const double enough = std::max(kept, highest - lost - 4 * deviation);
  std::size_t peak = first;
  while (correlation[peak] < enough) ++peak;
  while (peak < last && correlation[peak + 1] > correlation[peak]) ++peak;
  const std::size_t reach = ReachOf(correlation, peak);
  Peak found = PeakNear(correlation, peak, reach);
  // A late multiple gives the period more precisely.
  double at = 1;
  for (double multiple = 2; multiple * found.place / at < static_cast<double>(correlation.size() - 2); multiple *= 2) {
    const std::size_t late = Largest(correlation, static_cast<std::size_t>(std::round(multiple * found.place / at)),
                                     std::max<std::size_t>(2, reach));
    if (late + 1 >= correlation.size()) break;
    found = PeakNear(correlation, late, reach);
    at = multiple;
  }
  const double period = found.place / at;
  const double whole = std::round(period);
  const double periods = std::floor(static_cast<double>(signal.size()) / period);
  // The slope of the correlation by noise, over the curvature, is what noise moves the peak by.
  const double doubt = 3 * deviation / std::sqrt(std::max(1e-300, found.curvature)) / at;
  if (std::abs(period - whole) > 0.1 / std::sqrt(periods) + doubt) return std::nullopt;
  return static_cast<std::size_t>(whole);
}

std::optional<MultisineResponse> RespondToMultisine(std::span<const double> reference,
                                                    std::span<const std::span<const double>> channels,
                                                    std::size_t period) {
  constexpr std::size_t kFewest = 3;
  if (period < 8 || reference.size() < kFewest * period) return std::nullopt;
  const PeriodSpectra x(reference, period);
  MultisineResponse out{.period = period, .lines = ExcitedLines(x), .amplitude = {}, .channels = {}};
  if (out.lines.empty()) return std::nullopt;
  std::vector<PeriodSpectra> y;
  std::vector<std::vector<Complex>> series;
  for (const std::span<const double> channel : channels) {
    y.emplace_back(channel, period);
    for (const std::size_t line : out.lines) {
      std::vector<Complex>& one = series.emplace_back();
      for (std::size_t m = 0; m < x.periods(); ++m) one.push_back(y.back().At(m, line) / x.At(m, line));
    }
  }
  const SettledPart settled = SettledPartOf(series);
  // Two are the fewest that scatter.
  out.run_in = std::min(std::max<std::size_t>(1, settled.first), x.periods() - 2);
  out.is_settled = settled.is_settled;
  out.periods = x.periods() - out.run_in;
  const std::vector<Complex> mean = x.Mean(out.run_in);
  for (const std::size_t line : out.lines) out.amplitude.push_back(std::abs(mean[line]));
  for (const PeriodSpectra& channel : y) out.channels.push_back(LineFit(x, channel, out.run_in, out.lines).Respond());
  return out;
}

}  // namespace fourpost
