#include "analysis/comfort/weighting.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "analysis/signals/spline_through.h"
#include "analysis/text/option_check.h"

namespace fourpost {
namespace {

using std::numbers::pi;
using std::numbers::sqrt2;

/// Of one weighting; frequencies in Hz. An infinite f3 and an f5 of zero leave that part out.
struct Constants {
  std::string_view name;
  double f1;
  double f2;
  double f3;
  double f4;
  double q4;
  double f5;
  double q5;
  double f6;
  double q6;
  double gain;
};

constexpr double kNoZero = HUGE_VAL;

/// In the order of kWeightings.
constexpr std::array<Constants, kWeightings.size()> kConstants = {{
    {"Wk", 0.4, 100, 12.5, 12.5, 0.63, 2.37, 0.91, 3.35, 0.91, 1},
    {"Wd", 0.4, 100, 2, 2, 0.63, 0, 0, 0, 0, 1},
    {"We", 0.4, 100, 1, 1, 0.63, 0, 0, 0, 0, 1},
    {"Wf", 0.08, 0.63, kNoZero, 0.25, 0.86, 0.0625, 0.80, 0.1, 0.80, 1},
    {"Wb", 0.4, 100, 16, 16, 0.55, 2.5, 0.9, 4, 0.95, 1.024},
}};

const Constants& ConstantsOf(Weighting weighting) { return kConstants[static_cast<std::size_t>(weighting)]; }

}  // namespace

std::string_view WeightingName(Weighting weighting) { return ConstantsOf(weighting).name; }

std::optional<Weighting> WeightingNamed(std::string_view name) {
  for (const Weighting weighting : kWeightings)
    if (WeightingName(weighting) == name) return weighting;
  return {};
}

WeightingFilter::WeightingFilter(Weighting weighting) {
  const Constants& c = ConstantsOf(weighting);
  sections_.push_back({.corner = 2 * pi * c.f2, .b0 = c.gain, .a1 = sqrt2});
  sections_.push_back({.corner = 2 * pi * c.f4, .b0 = 1, .b1 = c.f4 / c.f3, .a1 = 1 / c.q4});
  if (c.f5 > 0) {
    const double ratio = c.f5 / c.f6;
    sections_.push_back({.corner = 2 * pi * c.f6, .b0 = ratio * ratio, .b1 = ratio / c.q5, .b2 = 1, .a1 = 1 / c.q6});
  }
  sections_.push_back({.corner = 2 * pi * c.f1, .b2 = 1, .a1 = sqrt2});
}

std::complex<double> WeightingFilter::Response(double frequency_Hz) const {
  std::complex<double> response = 1;
  for (const Section& section : sections_) {
    const std::complex<double> q(0, 2 * pi * frequency_Hz / section.corner);
    response *= (section.b0 + q * (section.b1 + q * section.b2)) / (1.0 + q * (section.a1 + q));
  }
  return response;
}

std::vector<double> WeightingFilter::Apply(std::span<const double> signal, double rate_Hz) const {
  RequirePositive("WeightingFilter: rate_Hz", rate_Hz);
  RequireOption(signal.size() >= 2, "WeightingFilter: samples", signal.size(), "two at least");
  const double step = 1 / rate_Hz;
  const UniformSpline spline = SplineThrough(signal, 0, step);

  // States x1, x2 of each section, x1' = corner x2, x2' = corner (input - x1 - a1 x2), the input that the section
  // before puts out; behind them the signal with its three derivatives, by which a cubic is a state as well.
  const auto states = static_cast<Eigen::Index>(2 * sections_.size());
  Eigen::MatrixXd rates = Eigen::MatrixXd::Zero(states + 4, states + 4);
  Eigen::RowVectorXd input = Eigen::RowVectorXd::Unit(states + 4, states);
  Eigen::Index x = 0;
  for (const Section& section : sections_) {
    rates(x, x + 1) = section.corner;
    rates.row(x + 1) = section.corner * input;
    rates(x + 1, x) -= section.corner;
    rates(x + 1, x + 1) -= section.corner * section.a1;
    input *= section.b2;
    input[x] += section.b0 - section.b2;
    input[x + 1] += section.b1 - section.b2 * section.a1;
    x += 2;
  }
  for (Eigen::Index k = 0; k < 3; ++k) rates(states + k, states + k + 1) = 1;
  const Eigen::RowVectorXd& output = input;
  const Eigen::MatrixXd over_step = Exponential(rates * step).topRows(states);

  Eigen::VectorXd state(states + 4);
  state.head(states) =
      Solved(rates.topLeftCorner(states, states).eval(), (-signal[0] * rates.col(states).head(states)).eval());
  std::vector<double> weighted(signal.size());
  UniformSpline::Point here = spline.At(0);
  for (std::size_t k = 0; k < signal.size(); ++k) {
    const UniformSpline::Point next = spline.At(std::min(static_cast<double>(k + 1) * step, spline.end()));
    state.tail(4) << signal[k], here.slope, here.curvature, (next.curvature - here.curvature) / step;
    weighted[k] = output.dot(state);
    state.head(states) = (over_step * state).eval();
    here = next;
  }
  return weighted;
}

}  // namespace fourpost
