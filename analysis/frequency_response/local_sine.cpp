#include "analysis/frequency_response/local_sine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

namespace fourpost {
namespace {

using Row = Eigen::Matrix<double, 5, 1>;

Row RowAt(double cycles) {
  const double angle = 2 * std::numbers::pi * cycles;
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  return {1, cosine, sine, cosine * cosine - sine * sine, 2 * sine * cosine};
}

}  // namespace

SignalBlocks::SignalBlocks(std::span<const double> signal, double first, double last, double cycles_per_sample) {
  constexpr double kInACycle = 32;
  const double most = static_cast<double>(signal.size());
  const auto begin = static_cast<std::size_t>(std::clamp(std::ceil(first), 0.0, most));
  const auto end = static_cast<std::size_t>(std::clamp(std::ceil(last), 0.0, most));
  const auto count = static_cast<std::size_t>(std::max(1.0, std::floor(1 / (kInACycle * cycles_per_sample))));
  size = static_cast<double>(count);
  origin = static_cast<double>(begin) + 0.5 * (size - 1);
  for (std::size_t k = begin; k + count <= end; k += count) {
    double sum = 0;
    for (std::size_t i = k; i < k + count; ++i) sum += signal[i];
    values.push_back(sum / size);
  }
}

std::size_t SignalBlocks::Place(double sample) const {
  const double place = std::ceil((sample - origin) / size - 1e-9);
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(values.size())));
}

LocalSine::LocalSine(const SignalBlocks& blocks, std::size_t first, std::size_t last, double cycles_per_sample)
    : cycles_per_sample_(cycles_per_sample), origin_(blocks.TimeOf(first)) {
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  Row right = Row::Zero();
  double square = 0;
  for (std::size_t k = first; k < last; ++k) {
    const Row row = RowAt(cycles_per_sample * (blocks.TimeOf(k) - origin_));
    const double value = blocks.values[k] - blocks.values[first];
    normal += row * row.transpose();
    right += value * row;
    square += value * value;
  }
  const Row fitted = normal.ldlt().solve(right);
  std::copy_n(fitted.data(), 5, value_);
  value_[0] += blocks.values[first];
  const double freedom = std::max(1.0, static_cast<double>(last - first) - 5);
  rest_ = std::sqrt(std::max(0.0, square - fitted.dot(right)) / freedom);
}

double LocalSine::amplitude() const { return std::hypot(value_[1], value_[2]); }

double LocalSine::At(double time) const {
  return RowAt(cycles_per_sample_ * (time - origin_)).dot(Eigen::Map<const Row>(value_));
}

double LocalSine::SquareOff(const SignalBlocks& blocks, std::size_t first, std::size_t last) const {
  double square = 0;
  for (std::size_t k = first; k < last; ++k) square += std::pow(blocks.values[k] - At(blocks.TimeOf(k)), 2);
  return square / static_cast<double>(last - first);
}

LocalSine BestSine(const SignalBlocks& blocks, std::size_t first, std::size_t last, double cycles_per_sample,
                   double reach, int rounds) {
  constexpr int kSteps = 6;
  LocalSine best(blocks, first, last, cycles_per_sample);
  for (int round = 0; round < rounds; ++round, reach /= kSteps) {
    const double middle = best.cycles_per_sample();
    for (int step = -kSteps; step <= kSteps; ++step) {
      const LocalSine sine(blocks, first, last, middle + cycles_per_sample * reach * step / kSteps);
      if (sine.rest() < best.rest()) best = sine;
    }
  }
  return best;
}

}  // namespace fourpost
