#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "analysis/signals/noise_floor.h"
#include "identify/experiments/audited_vehicle.h"
#include "identify/experiments/time_history/time_histories.h"
#include "identify/experiments/time_history/windowed_line.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

constexpr double kShortest_s = 8;

bool IsAuditedHistory(const MeasuredHistory& history) {
  return !history.release && static_cast<double>(history.LongestMeasured().count) >= kShortest_s * history.rate_Hz;
}

/// Every `step`-th sample of four running means over so many: what they take from a signal they take from all alike,
/// but accelerations have more of what would be mirrored.
std::vector<double> Thinned(std::span<const double> signal, std::size_t step) {
  constexpr int kPasses = 4;
  std::vector<double> smooth(signal.begin(), signal.end());
  for (int pass = 0; pass < kPasses && step > 1; ++pass) {
    std::vector<double> means(smooth.size() - step + 1);
    for (std::size_t k = 0; k < means.size(); ++k)
      for (std::size_t i = k; i < k + step; ++i) means[k] += smooth[i] / static_cast<double>(step);
    smooth = std::move(means);
  }
  std::vector<double> thinned;
  for (std::size_t k = 0; k < smooth.size(); k += step) thinned.push_back(smooth[k]);
  return thinned;
}

/// How many derivatives make an acceleration of what a sensor reads.
int DerivativesOf(Sensor::Type type) {
  if (type == Sensor::Type::kAccelerometer) return 0;
  return type == Sensor::Type::kGyro ? 1 : 2;
}

/// A history at some lines of its spectrum, of the longest stretch in which all was measured.
class AuditedHistory {
 public:
  AuditedHistory(const MeasuredHistory& history, const Vehicle& vehicle) : history_(history), vehicle_(vehicle) {
    constexpr double kEnough_Hz = 200;
    constexpr double kLongest_s = 600;
    step_ = std::max<std::size_t>(1, static_cast<std::size_t>(history.rate_Hz / kEnough_Hz));
    rate_Hz_ = history.rate_Hz / static_cast<double>(step_);
    const MeasuredHistory::Stretch part = history.LongestMeasured();
    const auto first = static_cast<std::size_t>(history.first + part.first);
    const auto count =
        std::min(static_cast<std::size_t>(part.count), static_cast<std::size_t>(kLongest_s * history.rate_Hz));
    for (const std::vector<double>& height : history.heights)
      posts_.push_back(Thinned(std::span(height).subspan(first, count), step_));
    for (const MeasuredSignal& signal : history.signals) {
      const std::span<const double> values(signal.values.data() + part.first, count);
      signals_.push_back(Thinned(values, step_));
      noise_.push_back(NoiseOf(signal, values) / std::sqrt(static_cast<double>(step_)));
    }
  }

  void AddTo(AuditedVehicle& audited) {
    const std::vector<double> lines = Lines();
    if (lines.empty()) return;
    AuditedRun run = audited.Blank(history_.name, lines);
    run.is_noise_known = is_noise_known_;
    for (std::size_t f = 0; f < lines.size(); ++f) AddLine(f, audited, run);
    // Where a tyre lifts off, its force and squeeze are not proportional: of such there are few in a line of many
    // cycles.
    audited.Add(std::move(run), std::vector<double>(lines.size(), 0.0));
  }

 private:
  /// As stated, or of the empty part of the spectrum, which a filter of the rig empties of noise as well. Where nobody
  /// knows, a usual share; what goes beyond that widens all by the audit's misfit.
  double NoiseOf(const MeasuredSignal& signal, std::span<const double> values) {
    constexpr double kUsual = 0.01;
    if (signal.noise_sd > 0) return signal.noise_sd;
    const double floor = history_.filter ? 0 : NoiseFloor(values);
    if (floor > 0) return floor;
    is_noise_known_ = false;
    return kUsual * signal.Deviation();
  }

  WindowedLine LineAt(double frequency_Hz) const { return {posts_.front().size(), rate_Hz_, frequency_Hz}; }

  /// Heights of the posts, as all readings by the line of their acceleration over that of a sine.
  std::vector<Complex> PostsAt(const WindowedLine& line, double frequency_Hz) const {
    std::vector<Complex> heights;
    for (const std::vector<double>& post : posts_) heights.push_back(line.Of(post, 2) / MinusSquare(frequency_Hz));
    return heights;
  }

  static double MinusSquare(double frequency_Hz) { return -std::pow(2 * std::numbers::pi * frequency_Hz, 2); }

  static double Largest(const std::vector<Complex>& heights) {
    double largest = 0;
    for (const Complex& height : heights) largest = std::max(largest, std::abs(height));
    return largest;
  }

  struct Line {
    double frequency_Hz = 0;
    double size = 0;
  };

  /// The frequencies at which posts move most, one in each of some dozens of bands of equal ratio, three lines of the
  /// window apart, so that they are independent. Those at which posts are nearly at rest, by displacement and by speed,
  /// hold noise alone, of sensors whose noise is perhaps not known.
  std::vector<double> Lines() const {
    constexpr double kMoves = 0.1;
    const std::vector<Line> found = LargestOfBands();
    double displacement = 0;
    double speed = 0;
    for (const Line& line : found) {
      displacement = std::max(displacement, line.size);
      speed = std::max(speed, line.size * line.frequency_Hz);
    }
    std::vector<double> frequencies;
    for (const Line& line : found)
      if (line.size > kMoves * displacement || line.size * line.frequency_Hz > kMoves * speed)
        frequencies.push_back(line.frequency_Hz);
    return frequencies;
  }

  std::vector<Line> LargestOfBands() const {
    constexpr int kBands = 60;
    constexpr int kTries = 5;
    constexpr double kApart = 3;
    constexpr double kCycles = 8;
    constexpr double kAboveNoise = 30;
    const double duration_s = static_cast<double>(posts_.front().size()) / rate_Hz_;
    const double lowest = std::max(0.5, kCycles / duration_s);
    const double highest = std::min(20.0, 0.2 * rate_Hz_);
    const double ratio = std::pow(highest / lowest, 1.0 / kBands);
    std::vector<Line> lines;
    for (int band = 0; band < kBands && lowest < highest; ++band) {
      const double from = lowest * std::pow(ratio, band);
      Line best;
      for (int k = 0; k < kTries; ++k) {
        const double frequency = from * std::pow(ratio, (k + 0.5) / kTries);
        if (!lines.empty() && frequency < lines.back().frequency_Hz + kApart / duration_s) continue;
        const WindowedLine line = LineAt(frequency);
        const double size = Largest(PostsAt(line, frequency));
        if (size > best.size && size > kAboveNoise * line.NoiseSd(PostNoise())) best = {frequency, size};
      }
      if (best.size > 0) lines.push_back(best);
    }
    return lines;
  }

  double PostNoise() const {
    double largest = 0;
    for (const double sd : history_.post_noise_sd) largest = std::max(largest, sd);
    return largest / std::sqrt(static_cast<double>(step_));
  }

  void AddLine(std::size_t f, AuditedVehicle& audited, AuditedRun& run) const {
    const double frequency = run.frequency_Hz[f];
    const double square = MinusSquare(frequency);
    const WindowedLine line = LineAt(frequency);
    const std::vector<Complex> heights = PostsAt(line, frequency);
    const Complex reference = *std::max_element(
        heights.begin(), heights.end(), [](const Complex& a, const Complex& b) { return std::abs(a) < std::abs(b); });
    const auto column = static_cast<Eigen::Index>(f);
    for (std::size_t p = 0; p < heights.size(); ++p)
      run.posts(static_cast<Eigen::Index>(p), column) = heights[p] / reference;
    for (std::size_t s = 0; s < signals_.size(); ++s) {
      const Sensor& sensor = vehicle_.sensors[history_.signals[s].sensor];
      // Forces follow from heights as well as from accelerations, whose lines differ by the window; tyres lift off.
      if (sensor.type == Sensor::Type::kLoadCell) continue;
      const int derivatives = DerivativesOf(sensor.type);
      Complex reading = line.Of(signals_[s], derivatives) / square;
      double sd = line.NoiseSd(noise_[s]);
      if (derivatives == 0) sd /= std::abs(square);
      if (derivatives == 1) reading *= Complex(0, 2 * std::numbers::pi * frequency);
      audited.Put(run, history_.signals[s].sensor, f, reading / reference, sd / std::abs(reference));
    }
  }

  const MeasuredHistory& history_;
  const Vehicle& vehicle_;
  std::size_t step_ = 1;
  double rate_Hz_ = 0;
  std::vector<std::vector<double>> posts_;
  std::vector<std::vector<double>> signals_;
  std::vector<double> noise_;
  bool is_noise_known_ = true;
};

}  // namespace

bool TimeHistories::IsAudited() const { return std::any_of(fitted.begin(), fitted.end(), IsAuditedHistory); }

void TimeHistories::AddRecordings(AuditedVehicle& audited) const {
  for (const MeasuredHistory& history : fitted)
    if (IsAuditedHistory(history)) AuditedHistory(history, audited.vehicle()).AddTo(audited);
}

}  // namespace fourpost
