#include "analysis/signals/arx.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <Eigen/Dense>

#include "analysis/signals/spectrum.h"

namespace fourpost {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kSamplesPerCoefficient = 10;

/// Columns of an order and those before: the constant, inputs at lag 0, then output and inputs at each lag.
Index Columns(Index order, Index inputs) { return 1 + inputs + order * (1 + inputs); }

/// Of sample k >= order.
void FillRow(const ArxRecord& record, Index order, Index k, Eigen::Ref<Eigen::RowVectorXd> row) {
  const Index inputs = record.inputs.cols();
  row[0] = 1;
  row.segment(1, inputs) = record.inputs.row(k);
  for (Index lag = 1; lag <= order; ++lag) {
    const Index at = Columns(lag - 1, inputs);
    row[at] = record.output[k - lag];
    row.segment(at + 1, inputs) = record.inputs.row(k - lag);
  }
}

/// Upper triangle of the QR decomposition of all rows [regressors, output], found block by block.
struct Triangle {
  MatrixXd r;
  Index rows = 0;
};

Triangle TriangleOf(std::span<const ArxRecord> records, Index order) {
  constexpr Index kBlock = 2048;
  const Index columns = Columns(order, records.front().inputs.cols()) + 1;
  Triangle triangle{.r = MatrixXd::Zero(columns, columns)};
  MatrixXd stacked(columns + kBlock, columns);
  for (const ArxRecord& record : records)
    for (Index first = order; first < record.output.size(); first += kBlock) {
      const Index count = std::min(kBlock, record.output.size() - first);
      stacked.setZero();
      stacked.topRows(columns) = triangle.r;
      for (Index k = 0; k < count; ++k) {
        Eigen::RowVectorXd row(columns);
        FillRow(record, order, first + k, row.head(columns - 1));
        row[columns - 1] = record.output[first + k];
        stacked.row(columns + k) = row;
      }
      triangle.r = Eigen::HouseholderQR<MatrixXd>(stacked).matrixQR().topRows(columns).triangularView<Eigen::Upper>();
      triangle.rows += count;
    }
  return triangle;
}

Arx Solution(const Triangle& triangle, Index order, Index inputs) {
  const Index count = Columns(order, inputs);
  // Inputs that say the same share what there is.
  const VectorXd all = Eigen::ColPivHouseholderQR<MatrixXd>(triangle.r.topLeftCorner(count, count))
                           .solve(triangle.r.col(triangle.r.cols() - 1).head(count));
  Arx arx{.order = static_cast<int>(order),
          .constant = all[0],
          .own = VectorXd(order),
          .of_inputs = MatrixXd(order + 1, inputs)};
  arx.of_inputs.row(0) = all.segment(1, inputs).transpose();
  for (Index lag = 1; lag <= order; ++lag) {
    const Index at = Columns(lag - 1, inputs);
    arx.own[lag - 1] = all[at];
    arx.of_inputs.row(lag) = all.segment(at + 1, inputs).transpose();
  }
  return arx;
}

Index OrderByBic(const Triangle& triangle, Index most, Index inputs) {
  const auto rows = static_cast<double>(triangle.rows);
  const VectorXd last = triangle.r.col(triangle.r.cols() - 1);
  Index best = 1;
  double least = INFINITY;
  for (Index order = 1; order <= most; ++order) {
    const Index count = Columns(order, inputs);
    // A perfect model is one to rounding.
    const double squares = std::max(last.tail(last.size() - count).squaredNorm(), 1e-28 * last.squaredNorm());
    const double bic = rows * std::log(squares / rows) + static_cast<double>(count) * std::log(rows);
    if (!(bic < least)) continue;
    least = bic;
    best = order;
  }
  return best;
}

/// Through 1/A, from rest.
VectorXd ThroughPoles(const VectorXd& signal, const VectorXd& own) {
  VectorXd out = signal;
  for (Index k = 0; k < out.size(); ++k)
    for (Index i = 1; i <= std::min(k, own.size()); ++i) out[k] += own[i - 1] * out[k - i];
  return out;
}

std::vector<ArxRecord> ThroughPoles(std::span<const ArxRecord> records, const VectorXd& own) {
  std::vector<ArxRecord> filtered;
  for (const ArxRecord& record : records) {
    ArxRecord one{.inputs = record.inputs, .output = ThroughPoles(record.output, own)};
    for (Index j = 0; j < one.inputs.cols(); ++j) one.inputs.col(j) = ThroughPoles(record.inputs.col(j), own);
    if (!one.output.allFinite() || !one.inputs.allFinite()) return {};
    filtered.push_back(std::move(one));
  }
  return filtered;
}

double FreeRunError(const Arx& arx, std::span<const ArxRecord> records) {
  std::vector<VectorXd> modelled;
  for (const ArxRecord& record : records) modelled.push_back(arx.FreeRun(record));
  const double error = ErrorOf(records, modelled);
  return std::isfinite(error) ? error : INFINITY;
}

VectorXd Centred(const VectorXd& values) { return values.array() - values.mean(); }

struct Candidate {
  Arx arx;
  /// Of its free runs.
  double error = INFINITY;
};

/// The best of plain least squares and the passes after it.
Candidate OfOrder(std::span<const ArxRecord> records, Index order) {
  constexpr int kPasses = 5;
  const Index inputs = records.front().inputs.cols();
  Arx last = Solution(TriangleOf(records, order), order, inputs);
  Candidate best{last, FreeRunError(last, records)};
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<ArxRecord> filtered = ThroughPoles(records, last.own);
    if (filtered.empty()) break;
    // That of filtered signals has passed the filter as well.
    const double of_constant = 1 - last.own.sum();
    last = Solution(TriangleOf(filtered, order), order, inputs);
    last.constant *= of_constant;
    const double error = FreeRunError(last, records);
    if (error < best.error) best = {last, error};
  }
  return best;
}

}  // namespace

VectorXd Arx::OneStep(const ArxRecord& record) const {
  VectorXd out = record.output;
  for (Index k = order; k < out.size(); ++k) {
    out[k] = constant + of_inputs.row(0).dot(record.inputs.row(k));
    for (Index lag = 1; lag <= order; ++lag)
      out[k] += own[lag - 1] * record.output[k - lag] + of_inputs.row(lag).dot(record.inputs.row(k - lag));
  }
  return out;
}

VectorXd Arx::FreeRun(const ArxRecord& record) const {
  VectorXd out = record.output;
  for (Index k = order; k < out.size(); ++k) {
    out[k] = constant + of_inputs.row(0).dot(record.inputs.row(k));
    for (Index lag = 1; lag <= order; ++lag)
      out[k] += own[lag - 1] * out[k - lag] + of_inputs.row(lag).dot(record.inputs.row(k - lag));
  }
  return out;
}

double ErrorOf(std::span<const ArxRecord> records, std::span<const VectorXd> modelled) {
  double error = 0;
  double all = 0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    error += Centred(records[r].output - modelled[r]).squaredNorm();
    all += Centred(records[r].output).squaredNorm();
  }
  return 100 * error / all;
}

std::optional<Arx> FitArx(std::span<const ArxRecord> records, int most) {
  if (records.empty()) return std::nullopt;
  const Index inputs = records.front().inputs.cols();
  Index samples = 0;
  double power = 0;
  for (const ArxRecord& record : records) {
    if (record.inputs.cols() != inputs) return std::nullopt;
    samples += record.output.size();
    power += Centred(record.output).squaredNorm();
  }
  const Index room = samples / kSamplesPerCoefficient;
  if (!(power > 0) || room < Columns(1, inputs)) return std::nullopt;
  const Index highest = std::min<Index>(most, (room - 1 - inputs) / (1 + inputs));
  const Index by_bic = OrderByBic(TriangleOf(records, highest), highest, inputs);
  Candidate best = OfOrder(records, by_bic);
  for (const Index order : {2, 4, 6, 8})
    if (order < by_bic)
      if (Candidate lower = OfOrder(records, order); lower.error < best.error) best = std::move(lower);
  return best.arx;
}

std::optional<double> LinearShare(const ArxRecord& record, Index segment) {
  constexpr Index kLeastPerInput = 4;
  const Index inputs = record.inputs.cols();
  const Index count = segment < 8 ? 0 : 2 * record.output.size() / segment - 1;
  if (inputs == 0 || count < kLeastPerInput * inputs) return std::nullopt;
  const auto span = [&](Index column) {
    const VectorXd& output = record.output;
    const double* first = column < inputs ? record.inputs.col(column).data() : output.data();
    return std::span(first, static_cast<std::size_t>(output.size()));
  };
  const auto bins = static_cast<std::size_t>(segment / 2 + 1);
  std::vector<Eigen::MatrixXcd> spectra(bins, Eigen::MatrixXcd::Zero(inputs + 1, inputs + 1));
  for (Index i = 0; i <= inputs; ++i)
    for (Index j = i; j <= inputs; ++j) {
      const Spectrum pair = WelchSpectrum(span(i), span(j), 1, static_cast<std::size_t>(segment));
      for (std::size_t k = 0; k < bins; ++k) {
        spectra[k](i, j) = pair.cross[k];
        spectra[k](j, i) = std::conj(pair.cross[k]);
      }
    }
  double left = 0;
  double all = 0;
  for (std::size_t k = 1; k < bins; ++k) {
    const Eigen::MatrixXcd among = spectra[k].topLeftCorner(inputs, inputs);
    const Eigen::VectorXcd across = spectra[k].topRightCorner(inputs, 1);
    const double power = spectra[k](inputs, inputs).real();
    const double explained = across.dot(Eigen::ColPivHouseholderQR<Eigen::MatrixXcd>(among).solve(across)).real();
    left += std::clamp(power - explained, 0.0, power);
    all += power;
  }
  // Hann's segments that overlap by half are nearly independent.
  const double averages = 0.95 * static_cast<double>(count);
  return std::max(0.0, 1 - left / all * averages / (averages - static_cast<double>(inputs)));
}

}  // namespace fourpost
