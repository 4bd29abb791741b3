#include "analysis/frequency_response/stepped_sine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "analysis/frequency_response/settled_part.h"
#include "analysis/frequency_response/sine_fit.h"
#include "analysis/signals/deviation.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

constexpr int kHarmonics = 5;

std::vector<std::vector<Complex>> Products(const std::vector<Complex>& posts) {
  std::vector<std::vector<Complex>> products(posts.size(), std::vector<Complex>(posts.size()));
  for (std::size_t a = 0; a < posts.size(); ++a)
    for (std::size_t b = 0; b < posts.size(); ++b) products[a][b] = std::conj(posts[a]) * posts[b];
  return products;
}

/// One dwell of a record.
class DwellFit {
 public:
  DwellFit(const RigSignals& signals, const Dwell& dwell, std::optional<std::size_t> reference)
      : signals_(signals), posts_(signals.posts.size()), all_(signals.posts) {
    all_.insert(all_.end(), signals.channels.begin(), signals.channels.end());
    const double last = static_cast<double>(signals.samples());
    start_ = std::max(0.0, dwell.start);
    end_ = std::min(last, dwell.end);
    const std::size_t tracked = reference.value_or(Largest(start_, end_));
    frequency_ = RefinedFrequency(all_[tracked], start_, end_, dwell.cycles_per_sample);
    // Ends are good to a fraction of a cycle. Of many blocks the last one may be lost, which the next dwell may have
    // reached; of few ones that costs more than what it lacks.
    constexpr double kFewBlocks = 6;
    const double block = std::max(1.0, std::ceil(16 * frequency_)) / frequency_;
    const double slack = end_ - start_ < kFewBlocks * block ? 0.15 : -0.5;
    end_ = std::min(last, end_ + slack / frequency_);
    reference_ = reference;
  }

  std::optional<DwellResponse> Respond() {
    const CyclePhasors cycles = PhasorsByCycle(all_, start_, end_, frequency_, start_);
    constexpr std::size_t kFewestBlocks = 3;
    if (cycles.blocks() < kFewestBlocks) return std::nullopt;
    std::vector<Complex> mean;
    for (std::size_t p = 0; p < posts_; ++p) {
      Complex sum;
      for (std::size_t k = cycles.blocks() / 2; k < cycles.blocks(); ++k) sum += cycles.phasor[p][k];
      mean.push_back(sum);
    }
    DwellResponse out;
    out.shares = SharesOf(Products(mean), reference_, ShareDeviations(cycles, mean));
    const std::vector<Complex> motion = MotionByCycle(cycles, out.shares);
    const SettledPart settled = SettledPartOf(Ratios(cycles, motion));
    if (cycles.blocks() - settled.first < kFewestBlocks) return std::nullopt;
    out.is_settled = settled.is_settled;
    out.first = cycles.start[settled.first];
    out.last = cycles.start.back();
    out.frequency_Hz = frequency_ * signals_.rate_Hz;
    out.cycles = static_cast<int>(cycles.blocks() - settled.first) * cycles.cycles;
    out.run_in_cycles = static_cast<int>(settled.first) * cycles.cycles;
    Fit(cycles, motion, settled.first, out);
    return out;
  }

 private:
  std::size_t Largest(double start, double end) const {
    std::size_t largest = 0;
    double most = -1;
    for (std::size_t p = 0; p < posts_; ++p) {
      const auto first = static_cast<std::size_t>(start);
      const double size = DeviationOf(all_[p].subspan(first, static_cast<std::size_t>(end) - first));
      if (size > 1.05 * most) {
        most = size;
        largest = p;
      }
    }
    return largest;
  }

  /// By the scatter of the later half of the blocks, of which `mean` is the sum: of each post's share of each.
  std::vector<std::vector<double>> ShareDeviations(const CyclePhasors& cycles, const std::vector<Complex>& mean) const {
    std::vector<std::vector<double>> deviations(posts_, std::vector<double>(posts_));
    for (std::size_t a = 0; a < posts_; ++a)
      for (std::size_t b = 0; b < posts_; ++b) {
        const Complex ratio = mean[b] / mean[a];
        std::vector<Complex> apart;
        for (std::size_t k = cycles.blocks() / 2; k < cycles.blocks(); ++k)
          apart.push_back(cycles.phasor[b][k] - ratio * cycles.phasor[a][k]);
        // Real and imaginary part have half of it each.
        const double size = std::abs(mean[a]) / static_cast<double>(apart.size());
        const double deviation = std::sqrt(VarianceOfMean(apart) / 2) / size;
        deviations[a][b] = std::isfinite(deviation) ? deviation : 0;
      }
    return deviations;
  }

  std::vector<Complex> MotionByCycle(const CyclePhasors& cycles, const PostShares& shares) const {
    std::vector<Complex> motion;
    for (std::size_t k = 0; k < cycles.blocks(); ++k) {
      std::vector<Complex> posts;
      for (std::size_t p = 0; p < posts_; ++p) posts.push_back(cycles.phasor[p][k]);
      motion.push_back(shares.Motion(posts));
    }
    return motion;
  }

  std::vector<std::vector<Complex>> Ratios(const CyclePhasors& cycles, const std::vector<Complex>& motion) const {
    std::vector<std::vector<Complex>> ratios;
    for (std::size_t s = posts_; s < all_.size(); ++s) {
      std::vector<Complex>& ratio = ratios.emplace_back();
      for (std::size_t k = 0; k < cycles.blocks(); ++k) ratio.push_back(cycles.phasor[s][k] / motion[k]);
    }
    // Without channels the posts alone settle.
    if (ratios.empty()) ratios.push_back(motion);
    return ratios;
  }

  void Fit(const CyclePhasors& cycles, const std::vector<Complex>& motion, std::size_t settled,
           DwellResponse& out) const {
    const std::vector<SineFit> fits = FitSines(all_, out.first, out.last, frequency_, kHarmonics, start_);
    std::vector<Complex> posts;
    for (std::size_t p = 0; p < posts_; ++p) posts.push_back(fits[p].phasor.front());
    const Complex reference = out.shares.Motion(posts);
    out.amplitude = std::abs(reference);
    out.post_distortion = PostDistortion(fits, out.shares) / out.amplitude;
    for (std::size_t s = posts_; s < all_.size(); ++s) {
      const double mean_variance = VarianceOfMean(std::span<const double>(cycles.offset[s]).subspan(settled));
      DwellChannel channel{.response = fits[s].phasor.front() / reference,
                           .mean = fits[s].mean,
                           .mean_variance = mean_variance,
                           .drift_square = DriftSquare(fits[s].drift, mean_variance, cycles.blocks() - settled),
                           .harmonics = {}};
      for (const Complex& phasor : fits[s].phasor) channel.harmonics.push_back(std::abs(phasor));
      std::vector<Complex> differences;
      for (std::size_t k = settled; k < cycles.blocks(); ++k)
        differences.push_back((cycles.phasor[s][k] - channel.response * motion[k]) / reference);
      channel.variance = VarianceOfMean(differences);
      out.channels.push_back(std::move(channel));
    }
  }

  /// Less what noise makes of it, which of n even values has 12 / n of their variance, where their mean has 1 / n.
  static double DriftSquare(double drift, double mean_variance, std::size_t blocks) {
    constexpr double kOfNoise = 12;
    return drift * drift - kOfNoise * mean_variance / StudentFactor(static_cast<double>(blocks) - 1);
  }

  double PostDistortion(const std::vector<SineFit>& fits, const PostShares& shares) const {
    double square = 0;
    for (std::size_t h = 1; h < fits.front().phasor.size(); ++h) {
      std::vector<Complex> posts;
      for (std::size_t p = 0; p < posts_; ++p) posts.push_back(fits[p].phasor[h]);
      square += std::norm(shares.Motion(posts));
    }
    return std::sqrt(square);
  }

  const RigSignals& signals_;
  std::size_t posts_;
  /// Posts first.
  std::vector<std::span<const double>> all_;
  std::optional<std::size_t> reference_;
  double start_ = 0;
  double end_ = 0;
  double frequency_ = 0;
};

/// Adds what transients may have left in the means. `responses`: of one record, in its order.
void AddTransients(std::vector<DwellResponse>& responses, double rate_Hz) {
  constexpr double kSlowest_Hz = 0.5;
  for (std::size_t r = 0; r < responses.size(); ++r) {
    const double duration_s = static_cast<double>(responses[r].last - responses[r].first) / rate_Hz;
    const double share = 1 / (2 * std::numbers::pi * kSlowest_Hz * duration_s);
    const std::size_t first = r > 0 ? r - 1 : r;
    const std::size_t last = std::min(r + 1, responses.size() - 1);
    for (std::size_t c = 0; c < responses[r].channels.size(); ++c) {
      double sum = 0;
      for (std::size_t near = first; near <= last; ++near) sum += responses[near].channels[c].drift_square;
      responses[r].channels[c].mean_variance +=
          share * share * std::max(0.0, sum) / static_cast<double>(last - first + 1);
    }
  }
}

}  // namespace

double DwellChannel::Distortion() const {
  double square = 0;
  for (std::size_t h = 1; h < harmonics.size(); ++h) square += harmonics[h] * harmonics[h];
  return std::sqrt(square) / harmonics.front();
}

std::vector<DwellResponse> RespondInDwells(const RigSignals& signals, std::span<const Dwell> dwells,
                                           std::optional<std::size_t> reference) {
  std::vector<DwellResponse> responses;
  for (const Dwell& dwell : dwells)
    if (std::optional<DwellResponse> response = DwellFit(signals, dwell, reference).Respond())
      responses.push_back(*std::move(response));
  AddTransients(responses, signals.rate_Hz);
  return responses;
}

}  // namespace fourpost
