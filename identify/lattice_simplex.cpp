#include "identify/lattice_simplex.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fourpost {
namespace {

constexpr double kAxisStep = 0.05;

void SortBestFirst(Population& population) {
  std::stable_sort(population.begin(), population.end(),
                   [](const Individual& a, const Individual& b) { return IsBetter(a.score, b.score); });
}

bool Holds(const Population& population, const LatticePoint& point) {
  return std::any_of(population.begin(), population.end(),
                     [&](const Individual& member) { return member.point == point; });
}

// A twentieth of the range away, towards the further bound.
LatticePoint AlongAxis(const Lattice& lattice, LatticePoint point, std::size_t axis) {
  const std::int64_t count = lattice.count(axis);
  const auto step = std::max<std::int64_t>(1, std::llround(kAxisStep * static_cast<double>(count - 1)));
  point[axis] += 2 * point[axis] > count ? -step : step;
  return point;
}

// worst + share (centroid of the others - worst): 2 reflects, 3 expands, 3/2 and 1/2 contract.
LatticePoint Through(const Population& simplex, const Lattice& lattice, double share) {
  const LatticePoint& worst = simplex.back().point;
  LatticePoint point(worst.size());
  for (std::size_t j = 0; j < point.size(); ++j) {
    double centroid = 0;
    for (std::size_t i = 0; i + 1 < simplex.size(); ++i) centroid += static_cast<double>(simplex[i].point[j]);
    centroid /= static_cast<double>(simplex.size() - 1);
    const double from = static_cast<double>(worst[j]);
    const double last = static_cast<double>(lattice.count(j));
    point[j] = std::llround(std::clamp(from + share * (centroid - from), 1.0, last));
  }
  return point;
}

std::optional<Individual> Scored(const LatticePoint& point, const ScorePoints& score) {
  const std::vector<Score> scores = score({point});
  if (scores.empty()) return std::nullopt;
  return Individual{point, scores.front()};
}

// All vertices halfway to the best. False when the search has to end.
bool Shrink(Population& simplex, const ScorePoints& score) {
  const LatticePoint& best = simplex.front().point;
  std::vector<LatticePoint> points;
  for (std::size_t i = 1; i < simplex.size(); ++i) {
    LatticePoint point = best;
    for (std::size_t j = 0; j < point.size(); ++j) {
      point[j] += std::llround(0.5 * static_cast<double>(simplex[i].point[j] - best[j]));
    }
    points.push_back(point);
  }
  const std::vector<Score> scores = score(points);
  for (std::size_t i = 0; i < scores.size(); ++i) simplex[i + 1] = {points[i], scores[i]};
  return scores.size() == points.size();
}

// One iteration on vertices sorted best first. False when the search has to end.
bool Iterate(Population& simplex, const Lattice& lattice, const ScorePoints& score) {
  Individual& worst = simplex.back();
  const std::optional<Individual> reflected = Scored(Through(simplex, lattice, 2), score);
  if (!reflected) return false;
  if (IsBetter(reflected->score, simplex.front().score)) {
    const std::optional<Individual> expanded = Scored(Through(simplex, lattice, 3), score);
    worst = expanded && IsBetter(expanded->score, reflected->score) ? *expanded : *reflected;
    return expanded.has_value();
  }
  if (IsBetter(reflected->score, simplex[simplex.size() - 2].score)) {
    worst = *reflected;
    return true;
  }
  const bool outside = IsBetter(reflected->score, worst.score);
  const std::optional<Individual> contracted = Scored(Through(simplex, lattice, outside ? 1.5 : 0.5), score);
  if (!contracted) return false;
  if (IsBetter(contracted->score, outside ? reflected->score : worst.score)) {
    worst = *contracted;
    return true;
  }
  return Shrink(simplex, score);
}

}  // namespace

Population StartSimplex(const Population& population, const Lattice& lattice, const ScorePoints& score) {
  Population members = population;
  SortBestFirst(members);
  Population simplex;
  for (const Individual& member : members) {
    if (simplex.size() <= lattice.size() && !Holds(simplex, member.point)) simplex.push_back(member);
  }
  std::vector<LatticePoint> missing;
  for (std::size_t j = 0; simplex.size() + missing.size() <= lattice.size(); ++j) {
    missing.push_back(AlongAxis(lattice, simplex.front().point, j));
  }
  const std::vector<Score> scores = score(missing);
  for (std::size_t i = 0; i < scores.size(); ++i) simplex.push_back({missing[i], scores[i]});
  return simplex;
}

Individual DownhillSimplex(Population simplex, const Lattice& lattice, int iterations, const ScorePoints& score) {
  bool goes_on = true;
  for (int iteration = 0; iteration < iterations && goes_on; ++iteration) {
    SortBestFirst(simplex);
    goes_on = Iterate(simplex, lattice, score);
  }
  SortBestFirst(simplex);
  return simplex.front();
}

}  // namespace fourpost
