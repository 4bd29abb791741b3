#include "identify/uncertainty/residual_noise.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <utility>

#include <unsupported/Eigen/FFT>

#include "analysis/numerics/decompositions.h"
#include "analysis/signals/autocorrelation.h"

namespace fourpost {
namespace {

using Eigen::Index;

Eigen::VectorXd ValuesOf(const ResidualSeries& series, const Eigen::VectorXd& residuals) {
  Eigen::VectorXd values(series.count);
  for (Index k = 0; k < series.count; ++k) values[k] = residuals[series.first + k * series.step];
  return values;
}

/// Half one-sided transform: 0 to half the rate.
Eigen::VectorXcd Transformed(const Eigen::VectorXd& values, Index points) {
  Eigen::FFT<double> transform;
  Eigen::VectorXd padded = Eigen::VectorXd::Zero(points);
  padded.head(values.size()) = values;
  Eigen::VectorXcd all(points);
  transform.fwd(all, padded);
  return all.head(points / 2 + 1);
}

Eigen::VectorXcd FilterAt(const std::vector<double>& coefficients, Index points) {
  Eigen::VectorXd taps = Eigen::VectorXd::Zero(static_cast<Index>(coefficients.size()) + 1);
  taps[0] = 1;
  for (std::size_t i = 0; i < coefficients.size(); ++i) taps[static_cast<Index>(i) + 1] = coefficients[i];
  return Transformed(taps, points);
}

/// How many neighbours a spectrum is averaged over on each side: a quarter of its frequency, as resonances are as wide
/// as that, but at least eight and at most 40 independent points, fewer of short records.
class Reach {
 public:
  Reach(Index samples, Index points)
      : apart_(static_cast<double>(points) / static_cast<double>(samples)),
        most_(std::clamp(std::sqrt(static_cast<double>(samples)) / 2, 8.0, 40.0)) {}

  Index At(Index k) const {
    constexpr double kLeast = 8;
    return static_cast<Index>(apart_ * std::clamp(0.25 * static_cast<double>(k) / apart_, kLeast, most_));
  }

 private:
  /// Points from one independent point to the next.
  double apart_;
  double most_;
};

/// Mean over neighbours, mirrored at both ends.
std::vector<Eigen::MatrixXcd> Smoothed(const Eigen::MatrixXcd& transforms, const Reach& reach, double scale) {
  const Index last = transforms.rows() - 1;
  const Index channels = transforms.cols();
  const auto power = [&](Index k) -> Eigen::MatrixXcd {
    const bool is_mirrored = k < 0 || k > last;
    const Index at = k < 0 ? -k : k > last ? 2 * last - k : k;
    const Eigen::VectorXcd row = transforms.row(std::clamp<Index>(at, 0, last)).transpose();
    const Eigen::MatrixXcd product = row * row.adjoint();
    return is_mirrored ? Eigen::MatrixXcd(product.conjugate()) : product;
  };
  std::vector<Eigen::MatrixXcd> smoothed;
  Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(channels, channels);
  Index from = -reach.At(0);
  Index end = from;
  for (Index k = 0; k <= last; ++k) {
    for (; end <= k + reach.At(k); ++end) sum += power(end);
    for (; from < k - reach.At(k); ++from) sum -= power(from);
    smoothed.push_back(scale / static_cast<double>(end - from) * sum);
  }
  return smoothed;
}

/// Likewise of one power.
Eigen::VectorXd SmoothedPower(const Eigen::VectorXd& power, const Reach& reach) {
  Eigen::MatrixXcd roots = power.cwiseSqrt().cast<std::complex<double>>();
  const std::vector<Eigen::MatrixXcd> smoothed = Smoothed(roots, reach, 1);
  return Eigen::VectorXd::NullaryExpr(power.size(),
                                      [&](Index k) { return smoothed[static_cast<std::size_t>(k)](0, 0).real(); });
}

/// C, so that the columns of matrix C are orthonormal and span those of the matrix.
Eigen::MatrixXd Orthonormalising(const Eigen::MatrixXd& matrix) {
  constexpr double kRank = 1e-9;
  const Eigen::MatrixXd products = matrix.transpose() * matrix;
  const Eigen::VectorXd scale =
      products.diagonal().cwiseSqrt().unaryExpr([](double norm) { return norm > 0 ? 1 / norm : 0; });
  const SymmetricEigenpairs pairs = SymmetricEigenpairsOf(scale.asDiagonal() * products * scale.asDiagonal());
  std::vector<Index> spanning;
  for (Index i = 0; i < pairs.values.size(); ++i)
    if (pairs.values[i] > kRank * pairs.values[pairs.values.size() - 1]) spanning.push_back(i);
  return scale.asDiagonal() * pairs.vectors(Eigen::all, spanning) *
         pairs.values(spanning).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// Noise variances of neighbours over frequency, from second differences, smoothed over five of them.
void AddVariances(const ResidualSeries& series, const Eigen::VectorXd& residuals, Eigen::VectorXd& variance) {
  constexpr Index kReach = 2;
  if (series.count < 3) return;
  const Eigen::VectorXd values = ValuesOf(series, residuals);
  const Index last = series.count - 2;
  const auto square = [&](Index k) {
    const Index at = std::clamp<Index>(k, 1, last);
    const double difference = values[at - 1] - 2 * values[at] + values[at + 1];
    return difference * difference / 6;  // of white noise the mean is its variance
  };
  for (Index k = 0; k < series.count; ++k) {
    double sum = 0;
    for (Index near = k - kReach; near <= k + kReach; ++near) sum += square(near);
    variance[series.first + k * series.step] = sum / (2 * kReach + 1);
  }
}

}  // namespace

ResidualNoise::ResidualNoise(const Eigen::VectorXd& residuals, const ResidualStructure& structure,
                             const Eigen::MatrixXd& jacobian)
    : variance_(Eigen::VectorXd::Ones(residuals.size())), over_time_(static_cast<std::size_t>(residuals.size()), 0) {
  std::map<int, std::vector<ResidualSeries>> records;
  for (const ResidualSeries& series : structure.series) {
    if (!series.is_over_time) {
      AddVariances(series, residuals, variance_);
      continue;
    }
    records[series.record].push_back(series);
    for (Index k = 0; k < series.count; ++k) over_time_[static_cast<std::size_t>(series.first + k * series.step)] = 1;
  }
  if (records.empty()) return;
  Eigen::MatrixXd all = jacobian;
  all.conservativeResize(Eigen::NoChange, jacobian.cols() + structure.absorbed.cols());
  if (structure.absorbed.size() > 0) all.rightCols(structure.absorbed.cols()) = structure.absorbed;
  const FittedColumns fitted = {all, Orthonormalising(all)};
  for (auto& [number, channels] : records) records_.push_back(Measured(std::move(channels), residuals, fitted));
}

// Of N / T of the measured samples' power per point of the transform, `fitted` takes the sum of |F|^2 over its columns.
Eigen::MatrixXd ResidualNoise::Kept(const Record& record, const FittedColumns& fitted) {
  // A channel that a fit follows everywhere says nothing of its noise.
  constexpr double kLeast = 0.2;
  const Reach reach(record.samples, record.points);
  Eigen::MatrixXd kept(record.points / 2 + 1, static_cast<Index>(record.channels.size()));
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const ResidualSeries& series = record.channels[c];
    const Eigen::MatrixXd rows = fitted.all(Eigen::seqN(series.first, series.count, series.step), Eigen::all);
    const Eigen::MatrixXd columns = rows * fitted.orthonormalising;
    Eigen::VectorXd taken = Eigen::VectorXd::Zero(kept.rows());
    for (Index p = 0; p < columns.cols(); ++p) taken += Transformed(columns.col(p), record.points).cwiseAbs2();
    taken /= static_cast<double>(std::max<Index>(1, series.measured()));
    kept.col(static_cast<Index>(c)) = (1 - SmoothedPower(taken, reach).array()).max(kLeast);
  }
  return kept;
}

ResidualNoise::Record ResidualNoise::Measured(std::vector<ResidualSeries> channels, const Eigen::VectorXd& residuals,
                                              const FittedColumns& fitted) {
  Record record;
  record.channels = std::move(channels);
  record.samples = record.channels.front().count;
  record.points = 2;
  while (record.points < 2 * record.samples) record.points *= 2;
  const auto count = static_cast<Index>(record.channels.size());
  Eigen::MatrixXcd transforms(record.points / 2 + 1, count);
  Eigen::MatrixXcd colour(record.points / 2 + 1, count);
  for (Index c = 0; c < count; ++c) {
    const ResidualSeries& series = record.channels[static_cast<std::size_t>(c)];
    const Eigen::VectorXd signal = ValuesOf(series, residuals);
    const std::vector<double> coefficients = Autoregression(signal);
    // Power per sample that was measured: the others have none.
    const double scale = 1 / std::sqrt(static_cast<double>(std::max<Index>(1, series.measured())));
    transforms.col(c) = scale * Transformed(Whitened(signal, coefficients), record.points);
    colour.col(c) = FilterAt(coefficients, record.points).cwiseInverse();
  }
  record.spectrum = Smoothed(transforms, Reach(record.samples, record.points), 1);
  const Eigen::MatrixXd kept = Kept(record, fitted);
  for (Index k = 0; k < colour.rows(); ++k) {
    const Eigen::VectorXcd by = colour.row(k).cwiseQuotient(kept.row(k).cwiseSqrt()).transpose();
    Eigen::MatrixXcd& power = record.spectrum[static_cast<std::size_t>(k)];
    power = (by * by.adjoint()).cwiseProduct(power).eval();
  }
  return record;
}

ResidualNoise::Transforms ResidualNoise::TransformsOf(const Record& record, const Eigen::MatrixXd& jacobian,
                                                      const std::vector<char>& among) {
  const Index parameters = jacobian.cols();
  Transforms transforms;
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const ResidualSeries& series = record.channels[c];
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(series.count, parameters);
    bool is_present = false;
    for (Index k = 0; k < series.count; ++k) {
      const Index at = series.first + k * series.step;
      if (!among[static_cast<std::size_t>(at)]) continue;
      part.row(k) = jacobian.row(at);
      is_present = true;
    }
    if (!is_present) continue;
    Eigen::MatrixXcd transform(record.points / 2 + 1, parameters);
    for (Index p = 0; p < parameters; ++p) transform.col(p) = Transformed(part.col(p), record.points);
    transforms.channels.push_back(static_cast<Index>(c));
    transforms.of.push_back(std::move(transform));
  }
  return transforms;
}

// Sum_ts J_t' R(t - s) J_s is the mean over all frequencies of conj(J)' S J.
Eigen::MatrixXd ResidualNoise::Covariance(const Record& record, const Transforms& one, const Transforms& other) {
  const auto row_of = [](const Transforms& transforms, Index k) {
    Eigen::MatrixXcd rows(static_cast<Index>(transforms.of.size()), transforms.of.front().cols());
    for (std::size_t i = 0; i < transforms.of.size(); ++i) rows.row(static_cast<Index>(i)) = transforms.of[i].row(k);
    return rows;
  };
  const Index last = record.points / 2;
  Eigen::MatrixXd total = Eigen::MatrixXd::Zero(one.of.front().cols(), other.of.front().cols());
  for (Index k = 0; k <= last; ++k) {
    const double times = k == 0 || k == last ? 1 : 2;  // every other frequency stands for its negative as well
    const Eigen::MatrixXcd& spectrum = record.spectrum[static_cast<std::size_t>(k)];
    total += times * (row_of(one, k).adjoint() * spectrum(one.channels, other.channels) * row_of(other, k)).real();
  }
  return total / static_cast<double>(record.points);
}

Eigen::MatrixXd ResidualNoise::CovarianceOfScores(const Eigen::MatrixXd& jacobian, const std::vector<char>& among,
                                                  const std::vector<char>& with) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(jacobian.cols(), jacobian.cols());
  for (Index i = 0; i < jacobian.rows(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (among[k] && with[k] && !over_time_[k]) sum += variance_[i] * jacobian.row(i).transpose() * jacobian.row(i);
  }
  for (const Record& record : records_) {
    const Transforms one = TransformsOf(record, jacobian, among);
    const Transforms other = among == with ? one : TransformsOf(record, jacobian, with);
    if (!one.of.empty() && !other.of.empty()) sum += Covariance(record, one, other);
  }
  return sum;
}

Eigen::MatrixXd ResidualNoise::CovarianceOverTime(const Eigen::MatrixXd& jacobian) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(jacobian.cols(), jacobian.cols());
  for (const Record& record : records_) {
    const Transforms all = TransformsOf(record, jacobian, over_time_);
    sum += Covariance(record, all, all);
  }
  return sum;
}

Eigen::MatrixXd ResidualNoise::CovarianceOfStretches(const Eigen::MatrixXd& added,
                                                     const std::vector<char>& among) const {
  constexpr Index kStretches = 24;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(added.cols(), added.cols());
  for (const Record& record : records_) {
    // Of samples that take part; others say nothing of the scatter.
    std::vector<Eigen::VectorXd> by_sample;
    for (Index k = 0; k < record.samples; ++k) {
      Eigen::VectorXd sum = Eigen::VectorXd::Zero(added.cols());
      bool is_present = false;
      for (const ResidualSeries& series : record.channels) {
        const Index at = series.first + k * series.step;
        if (!among[static_cast<std::size_t>(at)]) continue;
        sum += added.row(at).transpose();
        is_present = true;
      }
      if (is_present) by_sample.push_back(std::move(sum));
    }
    const auto count = static_cast<Index>(by_sample.size());
    if (count < 2 * kStretches) continue;
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(added.cols(), kStretches);
    for (Index k = 0; k < count; ++k) sums.col(k * kStretches / count) += by_sample[static_cast<std::size_t>(k)];
    sums.colwise() -= sums.rowwise().mean().eval();
    covariance += static_cast<double>(kStretches) / (kStretches - 1) * sums * sums.transpose();
  }
  return covariance;
}

}  // namespace fourpost
