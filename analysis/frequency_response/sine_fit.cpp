#include "analysis/frequency_response/sine_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Rows are samples; columns 1, t, cos wt, sin wt, cos 2wt, ...; t from -1 to 1.
Eigen::MatrixXd Basis(std::size_t first, std::size_t last, double cycles_per_sample, int harmonics, double origin) {
  const auto size = static_cast<Eigen::Index>(last - first);
  Eigen::MatrixXd basis(size, 2 + 2 * harmonics);
  for (Eigen::Index n = 0; n < size; ++n) {
    basis(n, 0) = 1;
    basis(n, 1) = 2 * static_cast<double>(n) / static_cast<double>(size - 1) - 1;
    const double angle = 2 * pi * cycles_per_sample * (static_cast<double>(first) + static_cast<double>(n) - origin);
    for (int h = 1; h <= harmonics; ++h) {
      basis(n, 2 * h) = std::cos(h * angle);
      basis(n, 2 * h + 1) = std::sin(h * angle);
    }
  }
  return basis;
}

/// Offset, cosine and sine.
Eigen::Vector3d SineIn(std::span<const double> samples, const std::vector<double>& cosine,
                       const std::vector<double>& sine, const Eigen::Matrix3d& inverse) {
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < samples.size(); ++k) right += samples[k] * Eigen::Vector3d(1, cosine[k], sine[k]);
  return inverse * right;
}

}  // namespace

std::vector<SineFit> FitSines(std::span<const std::span<const double>> signals, std::size_t first, std::size_t last,
                              double cycles_per_sample, int harmonics, double origin) {
  constexpr double kHighest = 0.45;
  RequireOption(cycles_per_sample > 0 && cycles_per_sample < kHighest, "FitSines: cycles_per_sample", cycles_per_sample,
                "above 0 and below 0.45");
  const int count = std::clamp(static_cast<int>(kHighest / cycles_per_sample), 1, harmonics);
  RequireOption(last > first + static_cast<std::size_t>(2 + 2 * count), "FitSines: last", last,
                "more samples behind first than unknowns");
  const Eigen::MatrixXd basis = Basis(first, last, cycles_per_sample, count, origin);
  const Eigen::LDLT<Eigen::MatrixXd> normal(basis.transpose() * basis);
  std::vector<SineFit> fits;
  for (const std::span<const double> signal : signals) {
    const Eigen::Map<const Eigen::VectorXd> samples(signal.data() + first, basis.rows());
    const double offset = samples.mean();
    const Eigen::VectorXd fitted = normal.solve(basis.transpose() * (samples.array() - offset).matrix());
    SineFit fit{.mean = offset + fitted[0], .drift = 2 * fitted[1]};
    for (int h = 1; h <= count; ++h) fit.phasor.emplace_back(fitted[2 * h], -fitted[2 * h + 1]);
    fits.push_back(std::move(fit));
  }
  return fits;
}

CyclePhasors PhasorsByCycle(std::span<const std::span<const double>> signals, double first, double last,
                            double cycles_per_sample, double origin) {
  constexpr double kFewestSamples = 16;
  CyclePhasors out;
  out.cycles = static_cast<int>(std::max(1.0, std::ceil(kFewestSamples * cycles_per_sample)));
  const double length = out.cycles / cycles_per_sample;
  out.start.push_back(static_cast<std::size_t>(std::ceil(first)));
  out.phasor.resize(signals.size());
  out.offset.resize(signals.size());
  for (int block = 1; first + block * length <= last; ++block) {
    const std::size_t begin = out.start.back();
    const auto end = static_cast<std::size_t>(std::ceil(first + block * length));
    std::vector<double> cosine;
    std::vector<double> sine;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    for (std::size_t k = begin; k < end; ++k) {
      const double angle = 2 * pi * cycles_per_sample * (static_cast<double>(k) - origin);
      cosine.push_back(std::cos(angle));
      sine.push_back(std::sin(angle));
      const Eigen::Vector3d row(1, cosine.back(), sine.back());
      normal += row * row.transpose();
    }
    const Eigen::Matrix3d inverse = normal.inverse();
    for (std::size_t s = 0; s < signals.size(); ++s) {
      const Eigen::Vector3d fitted = SineIn(signals[s].subspan(begin, end - begin), cosine, sine, inverse);
      out.offset[s].push_back(fitted[0]);
      out.phasor[s].emplace_back(fitted[1], -fitted[2]);
    }
    out.start.push_back(end);
  }
  return out;
}

double RefinedFrequency(std::span<const double> signal, double first, double last, double cycles_per_sample) {
  constexpr int kRounds = 4;
  const std::array<std::span<const double>, 1> signals = {signal};
  for (int round = 0; round < kRounds; ++round) {
    const CyclePhasors cycles = PhasorsByCycle(signals, first, last, cycles_per_sample, first);
    const std::vector<Complex>& phasor = cycles.phasor.front();
    if (phasor.size() < 2) return cycles_per_sample;
    // Turns from block to block add up; each block's angle by its own weight.
    double phase = std::arg(phasor.front());
    double n = 0;
    double t = 0;
    double p = 0;
    double tt = 0;
    double tp = 0;
    for (std::size_t k = 0; k < phasor.size(); ++k) {
      if (k > 0) phase += std::arg(phasor[k] * std::conj(phasor[k - 1]));
      const double weight = std::norm(phasor[k]);
      const double time = static_cast<double>(k);
      n += weight;
      t += weight * time;
      p += weight * phase;
      tt += weight * time * time;
      tp += weight * time * phase;
    }
    const double spread = n * tt - t * t;
    if (!(spread > 0)) return cycles_per_sample;
    const double turn = (n * tp - t * p) / spread;
    cycles_per_sample *= 1 + turn / (2 * pi * cycles.cycles);
  }
  return cycles_per_sample;
}

}  // namespace fourpost
