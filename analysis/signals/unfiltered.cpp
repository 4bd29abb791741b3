#include "analysis/signals/unfiltered.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <unsupported/Eigen/FFT>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

/// Samples that surround a record: a filter of some per cent of the rate rings for a fraction of them.
constexpr std::size_t kMargin = 512;

/// Before the record its first value; behind it the record turned about its end, faded to the first value, so that it
/// closes on itself.
std::vector<double> Closed(std::span<const double> record) {
  std::size_t size = 1;
  while (size < record.size() + 2 * kMargin) size *= 2;
  std::vector<double> closed(size);
  std::copy(record.begin(), record.end(), closed.begin() + kMargin);
  const double first = record.front();
  const double last = record.back();
  std::fill_n(closed.begin(), kMargin, first);
  const std::size_t behind = size - kMargin - record.size();
  for (std::size_t k = 0; k < behind; ++k) {
    const double turned = 2 * last - record[record.size() - 1 - std::min(k + 1, record.size() - 1)];
    const double share = static_cast<double>(k + 1) / static_cast<double>(behind);
    const double fade = 0.5 + 0.5 * std::cos(std::numbers::pi * std::min(1.0, share));
    closed[kMargin + record.size() + k] = first + fade * (turned - first);
  }
  return closed;
}

double Pass(double cycles, double passes, double stops) {
  if (cycles <= passes) return 1;
  if (cycles >= stops) return 0;
  return 0.5 + 0.5 * std::cos(std::numbers::pi * (cycles - passes) / (stops - passes));
}

}  // namespace

std::vector<double> Unfiltered(std::span<const double> filtered, const LowPass& filter, double passes, double stops) {
  RequireOption(!filtered.empty(), "Unfiltered: samples", filtered.size(), "one at least");
  RequireOption(passes > 0 && passes < stops, "Unfiltered: passes", passes, "above 0 and below stops");
  RequireOption(stops <= 0.5, "Unfiltered: stops", stops, "at most half a cycle per sample");
  std::vector<double> closed = Closed(filtered);
  const double offset = filtered.front();
  for (double& sample : closed) sample -= offset;
  std::vector<std::complex<double>> spectrum;
  Eigen::FFT<double> transform;
  transform.fwd(spectrum, closed);
  const std::size_t size = closed.size();
  for (std::size_t k = 0; k < size; ++k) {
    const double cycles = static_cast<double>(k) / static_cast<double>(size);
    const double near = std::min(cycles, 1 - cycles);
    const double pass = Pass(near, passes, stops);
    spectrum[k] *= pass == 0 ? 0.0 : pass / filter.Response(cycles);
  }
  std::vector<std::complex<double>> signal;
  transform.inv(signal, spectrum);
  std::vector<double> record(filtered.size());
  for (std::size_t k = 0; k < record.size(); ++k) record[k] = signal[kMargin + k].real() + offset;
  return record;
}

std::vector<double> Unfiltered(std::span<const double> filtered, const LowPass& filter, double cutoff) {
  const double stops = std::min(0.4, 2.5 * cutoff);
  return Unfiltered(filtered, filter, std::min(0.8 * stops, 1.5 * cutoff), stops);
}

}  // namespace fourpost
