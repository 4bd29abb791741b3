#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

namespace fourpost {

/// Evenly sampled inputs, samples x inputs, and an output.
struct ArxRecord {
  Eigen::MatrixXd inputs;
  Eigen::VectorXd output;
};

/// A linear model without physics (Ljung, System Identification, 2nd ed., section 4.2), of order n:
///   y_k = c + sum_{i=1..n} a_i y_{k-i} + sum_j sum_{i=0..n} b_ij u_{j,k-i} + e_k.
struct Arx {
  int order = 0;
  double constant = 0;
  /// a_1 .. a_n.
  Eigen::VectorXd own;
  /// b, lags 0 .. n x inputs.
  Eigen::MatrixXd of_inputs;

  /// The first `order` samples are those measured.
  Eigen::VectorXd OneStep(const ArxRecord& record) const;
  /// The same, from where on the model is fed with its own output; not finite where the model is unstable.
  Eigen::VectorXd FreeRun(const ArxRecord& record) const;
};

/// Normalised mean square error of an output, [%], about its mean, over all records.
double ErrorOf(std::span<const ArxRecord> records, std::span<const Eigen::VectorXd> modelled);

/// The order from 1 to `most` with the least N ln(RSS/N) + p ln N for p coefficients, by one QR decomposition whose
/// leading columns are those of lower orders. BIC sees predictions of the next sample, and noise of the output biases
/// the coefficients. Least squares of signals filtered by 1/A of the last pass come nearer to those of least free-run
/// error (Steiglitz and McBride, IEEE Trans. Automatic Control 10, 1965): of five passes, at that order and at 2, 4, 6
/// and 8 if these are lower, the model with the least free-run error is taken. Nothing of records without inputs alike
/// in number, of constant outputs, or with fewer than ten samples per coefficient of order 1.
std::optional<Arx> FitArx(std::span<const ArxRecord> records, int most);

/// The share of the output's power that follows linearly from the inputs, over all frequencies: the multiple coherence
/// (Bendat and Piersol, Random Data, 4th ed., section 7.3) weighed by the output's spectrum, of Welch's segments of
/// `segment` samples, less what as many inputs without any relation would show. Nothing for fewer than four segments
/// per input.
std::optional<double> LinearShare(const ArxRecord& record, Eigen::Index segment);

}  // namespace fourpost
