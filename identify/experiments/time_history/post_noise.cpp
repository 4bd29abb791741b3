#include "identify/experiments/time_history/post_noise.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <unsupported/Eigen/FFT>

#include "analysis/numerics/decompositions.h"
#include "analysis/signals/median.h"
#include "analysis/signals/random_stream.h"
#include "identify/experiments/time_history/history_simulation.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Spectra between the columns of a record, by Welch's method: per frequency a matrix [unit^2/Hz].
struct SpectralMatrices {
  std::vector<Eigen::MatrixXcd> at;
  double spacing_Hz = 0;
  /// Means over so many independent segments; those that overlap by half under Hann's window count 0.6 each.
  double independent = 0;
};

SpectralMatrices SpectraOf(const Eigen::MatrixXd& columns, double rate_Hz, Index segment) {
  SpectralMatrices spectra{.spacing_Hz = rate_Hz / static_cast<double>(segment)};
  const Eigen::VectorXd window = Eigen::VectorXd::NullaryExpr(segment, [&](Index k) {
    return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(segment));
  });
  spectra.at.assign(static_cast<std::size_t>(segment / 2 + 1), Eigen::MatrixXcd::Zero(columns.cols(), columns.cols()));
  Eigen::FFT<double> transform;
  Eigen::MatrixXcd transforms(segment, columns.cols());
  Index count = 0;
  for (Index first = 0; first + segment <= columns.rows(); first += segment / 2, ++count) {
    for (Index c = 0; c < columns.cols(); ++c) {
      const Eigen::VectorXd part = columns.col(c).segment(first, segment);
      const Eigen::VectorXd shown = window.cwiseProduct((part.array() - part.mean()).matrix());
      Eigen::VectorXcd of(segment);
      transform.fwd(of, shown);
      transforms.col(c) = of;
    }
    for (std::size_t k = 0; k < spectra.at.size(); ++k) {
      const Eigen::VectorXcd row = transforms.row(static_cast<Index>(k)).transpose();
      spectra.at[k] += row * row.adjoint();
    }
  }
  const double scale = 2 / (rate_Hz * window.squaredNorm() * static_cast<double>(count));
  for (Eigen::MatrixXcd& matrix : spectra.at) matrix *= scale;
  spectra.independent = std::max(1.0, 0.6 * static_cast<double>(count));
  return spectra;
}

/// What of the last columns does not follow linearly from the first `inputs`.
Eigen::MatrixXcd Incoherent(const Eigen::MatrixXcd& spectra, Index inputs, double independent) {
  const Index outputs = spectra.rows() - inputs;
  const Eigen::MatrixXcd of_inputs = spectra.topLeftCorner(inputs, inputs);
  const Eigen::MatrixXcd between = spectra.topRightCorner(inputs, outputs);
  const double kept = std::max(0.25, 1 - static_cast<double>(inputs) / independent);
  return (spectra.bottomRightCorner(outputs, outputs) -
          between.adjoint() * of_inputs.completeOrthogonalDecomposition().solve(between)) /
         kept;
}

/// Upper ends of octaves down from half the rate [Hz], the lowest one with six frequencies of a segment or fewer.
std::vector<double> Octaves(double rate_Hz, double spacing_Hz) {
  std::vector<double> ends = {0.5 * rate_Hz};
  while (ends.back() > 6 * spacing_Hz) ends.push_back(0.5 * ends.back());
  std::reverse(ends.begin(), ends.end());
  return ends;
}

/// Noise whose spectrum is `density` [unit^2/Hz] up to each of the ends.
Eigen::VectorXd Coloured(std::uint64_t seed, std::size_t post, Index count, const std::vector<double>& ends_Hz,
                         const std::vector<double>& density, double rate_Hz) {
  Index points = 2;
  while (points < count) points *= 2;
  RandomStream draws(seed, "post noise", post);
  const Eigen::VectorXd white = Eigen::VectorXd::NullaryExpr(points, [&](Index) { return draws.Normal(); });
  Eigen::FFT<double> transform;
  Eigen::VectorXcd of(points);
  transform.fwd(of, white);
  for (Index k = 0; k < points; ++k) {
    const double frequency = rate_Hz * static_cast<double>(std::min(k, points - k)) / static_cast<double>(points);
    const auto band =
        static_cast<std::size_t>(std::lower_bound(ends_Hz.begin(), ends_Hz.end() - 1, frequency) - ends_Hz.begin());
    of[k] *= std::sqrt(density[band] * rate_Hz / 2);
  }
  Eigen::VectorXd coloured(points);
  transform.inv(coloured, of);
  return coloured.head(count);
}

MeasuredHistory WithAdded(const MeasuredHistory& history, std::size_t post, const Eigen::VectorXd& added) {
  MeasuredHistory moved = history;
  for (std::size_t k = 0; k < moved.heights[post].size(); ++k) moved.heights[post][k] += added[static_cast<Index>(k)];
  moved.posts = FollowHeights(moved.heights, moved.posts.start_s, moved.posts.step_s,
                              moved.filter ? &*moved.filter : nullptr, moved.tensions);
  return moved;
}

/// Least squares with x >= 0, of a normal matrix of few columns.
Eigen::VectorXd NotNegative(const Eigen::MatrixXd& normal, const Eigen::VectorXd& right) {
  std::vector<Index> kept;
  for (Index p = 0; p < right.size(); ++p)
    if (normal(p, p) > 0) kept.push_back(p);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size());
  while (!kept.empty()) {
    const Eigen::VectorXd part = LeastNorm(normal(kept, kept)).Solve(Eigen::VectorXd(right(kept)));
    x.setZero();
    x(kept) = part.cwiseMax(0);
    if (part.minCoeff() >= 0) break;
    std::vector<Index> positive;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (part[static_cast<Index>(i)] >= 0) positive.push_back(kept[i]);
    kept = std::move(positive);
  }
  return x;
}

/// Least squares over all pairs of channels and the frequencies of each octave, each in parts of what chance makes of
/// it.
class PostNoiseEstimate {
 public:
  PostNoiseEstimate(const MeasuredHistory& history, const CondensedModel& model, const Eigen::MatrixXd& modelled,
                    double step_s)
      : history_(history), posts_(static_cast<Index>(history.heights.size())) {
    const Index segment = Segment();
    const SpectralMatrices spectra = SpectraOf(Measured(modelled), history.rate_Hz, segment);
    independent_ = spectra.independent;
    spacing_Hz_ = spectra.spacing_Hz;
    for (std::size_t k = 0; k < spectra.at.size(); ++k) residuals_.push_back(Unexplained(spectra.at[k]));
    ends_Hz_ = Octaves(history.rate_Hz, spectra.spacing_Hz);
    const auto& stated = history.post_noise_is_stated;
    const bool is_known = std::all_of(stated.begin(), stated.end(), [](char is) { return is != 0; });
    if (is_known || history.signals.size() < 2) return;
    const Eigen::MatrixXd before = HistorySimulation(history, step_s).Run(model);
    for (std::size_t p = 0; p < history.heights.size(); ++p)
      for (std::size_t b = 0; b < ends_Hz_.size(); ++b) {
        const double scale = Probe(p, b);
        const MeasuredHistory moved = WithAdded(history, p, scale * UnitNoise(p, b));
        const Eigen::MatrixXd change = (HistorySimulation(moved, step_s).Run(model) - before) / scale;
        causes_.push_back(SpectraOf(change, history.rate_Hz, segment).at);
      }
    Sum();
  }

  PostNoise Noise() const {
    PostNoise noise = {.ends_Hz = ends_Hz_, .density = {}};
    const auto bands = static_cast<Index>(ends_Hz_.size());
    Eigen::VectorXd density(posts_ * bands);
    for (Index i = 0; i < density.size(); ++i) density[i] = White(i / bands);
    Estimate(density);
    for (Index p = 0; p < posts_; ++p) {
      const Eigen::VectorXd of_post = density.segment(p * bands, bands);
      noise.density.emplace_back(of_post.begin(), of_post.end());
    }
    return noise;
  }

 private:
  /// A sixteenth of the window, some thirty overlapping ones.
  Index Segment() const { return std::max<Index>(16, history_.count / 16 / 2 * 2); }

  /// Heights and residuals through the window.
  Eigen::MatrixXd Measured(const Eigen::MatrixXd& modelled) const {
    Eigen::MatrixXd measured(history_.count, posts_ + modelled.cols());
    for (Index p = 0; p < posts_; ++p) {
      const std::vector<double>& heights = history_.heights[static_cast<std::size_t>(p)];
      for (Index k = 0; k < history_.count; ++k) measured(k, p) = heights[static_cast<std::size_t>(history_.first + k)];
    }
    for (Index c = 0; c < modelled.cols(); ++c)
      measured.col(posts_ + c) =
          modelled.col(c) - history_.signals[static_cast<std::size_t>(c)].MeasuredOr(modelled.col(c));
    return measured;
  }

  /// Where the posts did not move the recorded heights are noise themselves.
  Eigen::MatrixXcd Unexplained(const Eigen::MatrixXcd& spectra) const {
    constexpr double kMoves = 10;
    bool moves = true;
    for (Index p = 0; p < posts_; ++p) moves = moves && spectra(p, p).real() > kMoves * White(p);
    if (moves) return Incoherent(spectra, posts_, independent_);
    const Index channels = spectra.rows() - posts_;
    return spectra.bottomRightCorner(channels, channels);
  }

  /// Of density 1 in one octave.
  Eigen::VectorXd UnitNoise(std::size_t post, std::size_t band) const {
    std::vector<double> density(ends_Hz_.size(), 0.0);
    density[band] = 1;
    return Coloured(7 + band, post, static_cast<Index>(history_.heights[post].size()), ends_Hz_, density,
                    history_.rate_Hz);
  }

  /// What that is scaled by: small against the motion, in displacement and in speed, and large against rounding.
  double Probe(std::size_t post, std::size_t band) const {
    const std::vector<double>& heights = history_.heights[post];
    double squares = 0;
    for (const double height : heights) squares += height * height;
    const double rms = squares > 0 ? std::sqrt(squares / static_cast<double>(heights.size())) : 1e-3;
    return 1e-4 * rms / std::sqrt(ends_Hz_[band]) / std::max(1.0, ends_Hz_[band]);
  }

  void Sum() {
    const auto count = static_cast<Index>(causes_.size());
    normal_.setZero(count, count);
    right_.setZero(count);
    for (std::size_t k = 1; k < residuals_.size(); ++k) {
      const Eigen::VectorXd power = PowerAbout(k);
      for (Index i = 0; i < power.size(); ++i)
        for (Index j = 0; j < i; ++j) AddPair(k, i, j, power[i] * power[j]);
    }
    // Spectra of what noise causes scatter themselves, which adds 1 / K to their squares.
    right_ *= 1 + 1 / independent_;
  }

  /// Of each channel, over neighbours, lest a spectrum be weighted by its own scatter.
  Eigen::VectorXd PowerAbout(std::size_t k) const {
    constexpr std::size_t kReach = 3;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(residuals_[k].rows());
    const std::size_t from = k > kReach ? k - kReach : 1;
    const std::size_t end = std::min(k + kReach + 1, residuals_.size());
    for (std::size_t at = from; at < end; ++at) sum += residuals_[at].diagonal().real();
    return sum / static_cast<double>(end - from);
  }

  Index BandOf(std::size_t k) const {
    return std::lower_bound(ends_Hz_.begin(), ends_Hz_.end() - 1, static_cast<double>(k) * spacing_Hz_) -
           ends_Hz_.begin();
  }

  void AddPair(std::size_t k, Index i, Index j, double chance) {
    if (!(chance > 0)) return;
    Eigen::VectorXcd causes = Eigen::VectorXcd::Zero(normal_.rows());
    const auto bands = static_cast<Index>(ends_Hz_.size());
    for (Index c = BandOf(k); c < causes.size(); c += bands) causes[c] = causes_[static_cast<std::size_t>(c)][k](i, j);
    const std::complex<double> residual = residuals_[k](i, j);
    right_ += (causes.conjugate() * residual).real() / chance;
    normal_ += (causes.conjugate() * causes.transpose()).real() / chance;
    common_ += std::norm(residual) / chance - 1 / independent_;
  }

  /// White noise, stated or in the empty part of a post's spectrum [m^2/Hz].
  double White(Index post) const {
    return std::pow(history_.post_noise_sd[static_cast<std::size_t>(post)], 2) * 2 / history_.rate_Hz;
  }

  void Estimate(Eigen::VectorXd& density) const {
    const auto bands = static_cast<Index>(ends_Hz_.size());
    std::vector<Index> open;
    for (Index i = 0; i < density.size(); ++i)
      if (!history_.post_noise_is_stated[static_cast<std::size_t>(i / bands)]) open.push_back(i);
    if (open.empty() || causes_.empty()) return;
    Eigen::VectorXd known = density;
    known(open).setZero();
    const Eigen::MatrixXd normal = normal_(open, open);
    const Eigen::VectorXd right = (right_ - normal_ * known)(open);
    const Eigen::VectorXd seen = NotNegative(normal, right);
    // The model lacks something where noise of the posts does not cause most of what channels have in common.
    Eigen::VectorXd all = known;
    all(open) = seen;
    if (common_ <= 0 || all.dot(2 * right_ - normal_ * all) < 0.7 * common_) return;
    // Each term scatters by 1 / 2K about its mean, and under Hann's window neighbours by 1.5 of that together.
    const Eigen::MatrixXd covariance = 1.5 / (2 * independent_) * LeastNorm(normal).PseudoInverse();
    for (Index first = 0; first < seen.size(); first += bands) {
      std::vector<Index> sharp;
      for (Index i = first; i < first + bands; ++i)
        if (normal(i, i) > 0 && seen[i] > 3 * std::sqrt(covariance(i, i))) sharp.push_back(i);
      if (IsWhite(seen, sharp, density[open[static_cast<std::size_t>(first)]])) continue;
      for (const Index i : sharp) density[open[static_cast<std::size_t>(i)]] = seen[i];
    }
  }

  /// Noise of one post. A damper with two rates passes some of it on from octave to octave, so that one alone does not
  /// speak against white noise.
  static bool IsWhite(const Eigen::VectorXd& seen, const std::vector<Index>& sharp, double white) {
    constexpr double kColoured = 3;
    std::vector<double> sizes;
    for (const Index i : sharp) sizes.push_back(seen[i]);
    return sizes.empty() || Median(std::move(sizes)) < kColoured * white;
  }

  const MeasuredHistory& history_;
  Index posts_;
  double independent_ = 1;
  double spacing_Hz_ = 0;
  std::vector<double> ends_Hz_;
  /// Per frequency: between channels, what does not follow from the posts.
  std::vector<Eigen::MatrixXcd> residuals_;
  /// Per post and octave, per frequency: between channels, of noise of density 1.
  std::vector<std::vector<Eigen::MatrixXcd>> causes_;
  Eigen::MatrixXd normal_;
  Eigen::VectorXd right_;
  /// Squares of the pairs beyond those that chance makes.
  double common_ = 0;
};

}  // namespace

bool PostNoise::IsAny() const {
  return std::any_of(density.begin(), density.end(), [](const std::vector<double>& post) {
    return std::any_of(post.begin(), post.end(), [](double power) { return power > 0; });
  });
}

PostNoise PostNoiseOf(const MeasuredHistory& history, const CondensedModel& model, const Eigen::MatrixXd& modelled,
                      double step_s) {
  return PostNoiseEstimate(history, model, modelled, step_s).Noise();
}

MeasuredHistory WithPostNoise(const MeasuredHistory& history, const PostNoise& noise, std::uint64_t seed, double sign) {
  MeasuredHistory noisy = history;
  for (std::size_t p = 0; p < noisy.heights.size(); ++p)
    noisy = WithAdded(noisy, p,
                      sign * Coloured(seed, p, static_cast<Index>(noisy.heights[p].size()), noise.ends_Hz,
                                      noise.density[p], history.rate_Hz));
  return noisy;
}

}  // namespace fourpost
