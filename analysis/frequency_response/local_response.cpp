#include "analysis/frequency_response/local_response.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Dense>
#include <unsupported/Eigen/FFT>

#include "analysis/signals/noise_floor.h"
#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// Polynomials of second order, for response and leakage.
constexpr Eigen::Index kTerms = 3;
constexpr int kFewestLines = 6;
constexpr double kBand = 0.025;

/// The longest one not above `size` that the transform is fast for: 2^a 3^b 5^c, a at least 1.
std::size_t FastSize(std::size_t size) {
  std::size_t best = 2;
  for (std::size_t five = 1; five <= size; five *= 5)
    for (std::size_t three = five; three <= size; three *= 3)
      for (std::size_t two = 2 * three; two <= size; two *= 2) best = std::max(best, two);
  return best;
}

std::size_t SegmentOf(double frequency_Hz, double rate_Hz, std::size_t samples) {
  constexpr double kPeriods = 240;
  double lower_Hz = 1.0 / 4;
  while (4 * lower_Hz <= frequency_Hz) lower_Hz *= 4;
  const double wanted = kPeriods / lower_Hz * rate_Hz;
  if (wanted >= static_cast<double>(samples)) return FastSize(samples);
  // Whole segments leave next to nothing out.
  const double count = std::ceil(static_cast<double>(samples) / wanted);
  return FastSize(static_cast<std::size_t>(static_cast<double>(samples) / count));
}

/// Lines about one frequency, and the sums over all segments.
class LocalFit {
 public:
  LocalFit(double frequency_Hz, double rate_Hz, std::size_t segment, std::size_t channels)
      : frequency_Hz_(frequency_Hz) {
    const double line_Hz = rate_Hz / static_cast<double>(segment);
    const double place = frequency_Hz / line_Hz;
    const auto half = std::max<Eigen::Index>(kFewestLines, static_cast<Eigen::Index>(kBand * place));
    centre_ = static_cast<Eigen::Index>(std::round(place));
    // Next to frequency zero there are lines above only.
    first_ = std::max<Eigen::Index>(1, centre_ - half);
    const Eigen::Index last = std::max(centre_ + half, first_ + 2 * half);
    RequireOption(2 * last < static_cast<Eigen::Index>(segment), "LocalResponses: frequencies_Hz", frequency_Hz,
                  "below half the rate by 7 lines at least");
    const Eigen::Index lines = last - first_ + 1;
    place_.resize(lines);
    for (Eigen::Index k = 0; k < lines; ++k)
      place_[k] = (static_cast<double>(first_ + k) - place) / static_cast<double>(half);
    Eigen::MatrixXd powers(lines, kTerms);
    for (Eigen::Index term = 0; term < kTerms; ++term) powers.col(term) = place_.array().pow(static_cast<double>(term));
    leak_ = Eigen::HouseholderQR<Eigen::MatrixXd>(powers).householderQ() * Eigen::MatrixXd::Identity(lines, kTerms);
    right_ = Eigen::MatrixXcd::Zero(kTerms, static_cast<Eigen::Index>(channels));
    power_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(channels));
  }

  void AddReference(const std::vector<Complex>& spectrum) {
    const Eigen::VectorXcd lines = Lines(spectrum);
    regressors_.resize(lines.size(), kTerms);
    for (Eigen::Index term = 0; term < kTerms; ++term)
      regressors_.col(term) = lines.cwiseProduct(place_.array().pow(static_cast<double>(term)).matrix());
    regressors_ -= (leak_ * (leak_.transpose() * regressors_)).eval();
    normal_ += regressors_.adjoint() * regressors_;
    reference_power_ += lines.squaredNorm();
    ++segments_;
  }

  void AddChannel(std::size_t channel, const std::vector<Complex>& spectrum) {
    const auto c = static_cast<Eigen::Index>(channel);
    const Eigen::VectorXcd lines = Lines(spectrum);
    right_.col(c) += regressors_.adjoint() * lines;
    power_[c] += lines.squaredNorm() - (leak_.transpose() * lines).squaredNorm();
  }

  /// `noise`: of a line of the reference; `scale` makes a density of its mean square.
  LocalResponse Solve(double noise, double scale) const {
    const double lines = static_cast<double>(segments_ * place_.size());
    const double freedom = lines - static_cast<double>(segments_ * kTerms) - static_cast<double>(kTerms);
    const Eigen::Matrix3cd inverse = WithoutNoise(noise).inverse();
    LocalResponse out{.frequency_Hz = frequency_Hz_,
                      .averages = freedom,
                      .reference_density = scale * reference_power_ / lines,
                      .channels = {}};
    const double spread = (inverse * normal_ * inverse)(0, 0).real();
    for (Eigen::Index c = 0; c < power_.size(); ++c) {
      const Eigen::Vector3cd fitted = inverse * right_.col(c);
      const double left = power_[c] - 2 * fitted.dot(right_.col(c)).real() + fitted.dot(normal_ * fitted).real();
      const double density = std::max(0.0, left) / freedom;
      LocalChannel channel{.response = fitted[0], .variance = density * spread};
      const double explained = std::norm(channel.response) / spread;
      channel.coherence = explained / (explained + density * lines);
      out.channels.push_back(channel);
    }
    return out;
  }

 private:
  Eigen::VectorXcd Lines(const std::vector<Complex>& spectrum) const {
    return Eigen::Map<const Eigen::VectorXcd>(spectrum.data() + first_, place_.size());
  }

  /// Expectation of the normal matrix of white noise taken off, unless that is most of it.
  Eigen::Matrix3cd WithoutNoise(double noise) const {
    Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
    const Eigen::VectorXd kept = 1 - leak_.rowwise().squaredNorm().array();
    for (Eigen::Index a = 0; a < kTerms; ++a)
      for (Eigen::Index b = 0; b < kTerms; ++b)
        expected(a, b) = (kept.array() * place_.array().pow(static_cast<double>(a + b))).sum();
    expected *= noise * static_cast<double>(segments_);
    constexpr double kMost = 0.3;
    if (expected(0, 0) > kMost * normal_(0, 0).real()) return normal_;
    return normal_ - expected;
  }

  double frequency_Hz_;
  Eigen::Index centre_ = 0;
  Eigen::Index first_ = 0;
  /// Of each line, -1 to 1.
  Eigen::VectorXd place_;
  /// Orthonormal.
  Eigen::MatrixXd leak_;
  /// Of the segment that was added last, without what leakage may explain.
  Eigen::MatrixXcd regressors_;
  Eigen::Matrix3cd normal_ = Eigen::Matrix3cd::Zero();
  Eigen::MatrixXcd right_;
  Eigen::VectorXd power_;
  double reference_power_ = 0;
  Eigen::Index segments_ = 0;
};

/// All frequencies with segments of one length: one segment after the other, one channel after the other.
class SegmentPass {
 public:
  SegmentPass(std::size_t segment, double rate_Hz) : segment_(segment), rate_Hz_(rate_Hz), buffer_(segment) {
    transform_.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  }

  std::vector<LocalResponse> Run(std::span<const double> reference, std::span<const std::span<const double>> channels,
                                 std::span<const double> frequencies_Hz, double noise) {
    std::vector<LocalFit> fits;
    for (const double frequency : frequencies_Hz) fits.emplace_back(frequency, rate_Hz_, segment_, channels.size());
    for (std::size_t first = 0; first + segment_ <= reference.size(); first += segment_) {
      Transform(reference.subspan(first, segment_));
      for (LocalFit& fit : fits) fit.AddReference(spectrum_);
      for (std::size_t c = 0; c < channels.size(); ++c) {
        Transform(channels[c].subspan(first, segment_));
        for (LocalFit& fit : fits) fit.AddChannel(c, spectrum_);
      }
    }
    const double size = static_cast<double>(segment_);
    std::vector<LocalResponse> responses;
    for (const LocalFit& fit : fits) responses.push_back(fit.Solve(noise * noise * size, 2 / (rate_Hz_ * size)));
    return responses;
  }

 private:
  void Transform(std::span<const double> samples) {
    double mean = 0;
    for (const double sample : samples) mean += sample / static_cast<double>(segment_);
    std::transform(samples.begin(), samples.end(), buffer_.begin(), [mean](double sample) { return sample - mean; });
    transform_.fwd(spectrum_, buffer_);
  }

  std::size_t segment_;
  double rate_Hz_;
  Eigen::FFT<double> transform_;
  std::vector<double> buffer_;
  std::vector<Complex> spectrum_;
};

}  // namespace

std::vector<LocalResponse> LocalResponses(std::span<const double> reference,
                                          std::span<const std::span<const double>> channels, double rate_Hz,
                                          std::span<const double> frequencies_Hz) {
  constexpr std::size_t kLeast = 64;
  RequireOption(reference.size() >= kLeast, "LocalResponses: samples", reference.size(), "64 at least");
  const double noise = NoiseFloor(reference);
  std::vector<LocalResponse> responses;
  for (std::size_t k = 0; k < frequencies_Hz.size();) {
    const std::size_t segment = SegmentOf(frequencies_Hz[k], rate_Hz, reference.size());
    std::size_t end = k + 1;
    while (end < frequencies_Hz.size() && SegmentOf(frequencies_Hz[end], rate_Hz, reference.size()) == segment) ++end;
    SegmentPass pass(segment, rate_Hz);
    for (LocalResponse& response : pass.Run(reference, channels, frequencies_Hz.subspan(k, end - k), noise))
      responses.push_back(std::move(response));
    k = end;
  }
  return responses;
}

}  // namespace fourpost
