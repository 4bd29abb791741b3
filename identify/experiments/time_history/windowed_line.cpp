#include "identify/experiments/time_history/windowed_line.h"

#include <cmath>
#include <numbers>

namespace fourpost {

WindowedLine::WindowedLine(std::size_t samples, double rate_Hz, double frequency_Hz) {
  using std::numbers::pi;
  using Complex = std::complex<double>;
  const double omega = 2 * pi * frequency_Hz;
  // Half of the window's own rate: w = sin^2 (slow t).
  const double slow = pi * rate_Hz / static_cast<double>(samples);
  double sum = 0;
  double squares = 0;
  for (std::vector<Complex>& factor : factor_) factor.resize(samples);
  for (std::size_t k = 0; k < samples; ++k) {
    const double t = (static_cast<double>(k) + 0.5) / rate_Hz;
    const double w = std::pow(std::sin(slow * t), 2);
    const double w1 = slow * std::sin(2 * slow * t);
    const double w2 = 2 * slow * slow * std::cos(2 * slow * t);
    const Complex turn = std::polar(1.0, -omega * t);
    factor_[0][k] = w * turn;
    factor_[1][k] = Complex(-w1, omega * w) * turn;
    factor_[2][k] = Complex(w2 - omega * omega * w, -2 * omega * w1) * turn;
    sum += w;
    squares += w * w;
  }
  for (std::vector<Complex>& factor : factor_)
    for (Complex& value : factor) value *= 2 / sum;
  noise_ = std::sqrt(2 * squares) / sum;
}

std::complex<double> WindowedLine::Of(std::span<const double> signal, int derivative) const {
  const std::vector<std::complex<double>>& factor = factor_[derivative];
  std::complex<double> line;
  for (std::size_t k = 0; k < factor.size(); ++k) line += signal[k] * factor[k];
  return line;
}

double WindowedLine::NoiseSd(double noise_sd) const { return noise_ * noise_sd; }

}  // namespace fourpost
