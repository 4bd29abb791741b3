#include "identify/suggest/aligned_residuals.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace fourpost {
namespace {

using Eigen::Index;

/// Those outside all series, in their order.
std::vector<Index> Independent(const StructuredResiduals& all) {
  std::vector<char> is_in_series(static_cast<std::size_t>(all.residuals.size()));
  for (const ResidualSeries& series : all.structure.series)
    for (Index i = 0; i < series.count; ++i) is_in_series[static_cast<std::size_t>(series.first + i * series.step)] = 1;
  std::vector<Index> places;
  for (Index i = 0; i < all.residuals.size(); ++i)
    if (!is_in_series[static_cast<std::size_t>(i)]) places.push_back(i);
  return places;
}

/// By how many residuals `other` begins before `known`; nothing where they are no such series of the same thing.
std::optional<Index> Lead(const ResidualSeries& known, const ResidualSeries& other) {
  if (known.is_over_time != other.is_over_time || known.record != other.record) return std::nullopt;
  if (!known.is_over_time) return known.count == other.count ? std::optional<Index>(0) : std::nullopt;
  constexpr double kRounding = 1e-9;
  if (!(std::abs(known.interval_s - other.interval_s) <= kRounding * known.interval_s)) return std::nullopt;
  return static_cast<Index>(std::lround((known.start_s - other.start_s) / known.interval_s));
}

}  // namespace

std::optional<Eigen::VectorXd> AlignedTo(const StructuredResiduals& known, const StructuredResiduals& others) {
  const std::vector<ResidualSeries>& to = known.structure.series;
  const std::vector<ResidualSeries>& from = others.structure.series;
  const std::vector<Index> alone = Independent(known);
  const std::vector<Index> others_alone = Independent(others);
  if (to.size() != from.size() || alone.size() != others_alone.size()) return std::nullopt;
  Eigen::VectorXd aligned = known.residuals;
  for (std::size_t i = 0; i < alone.size(); ++i) aligned[alone[i]] = others.residuals[others_alone[i]];
  for (std::size_t s = 0; s < to.size(); ++s) {
    const std::optional<Index> lead = Lead(to[s], from[s]);
    if (!lead) return std::nullopt;
    for (Index i = 0; i < to[s].count; ++i)
      if (const Index k = i + *lead; k >= 0 && k < from[s].count)
        aligned[to[s].first + i * to[s].step] = others.residuals[from[s].first + k * from[s].step];
  }
  return aligned;
}

}  // namespace fourpost
