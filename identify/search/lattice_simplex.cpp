#include "identify/search/lattice_simplex.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fourpost {
namespace {

constexpr double kAxisStep = 0.05;

// Shares of the way from the worst vertex to the centroid of the others.
constexpr double kReflect = 2;
constexpr double kExpand = 3;
constexpr double kContractOutside = 1.5;
constexpr double kContractInside = 0.5;

void SortBestFirst(Population& population) {
  std::stable_sort(population.begin(), population.end(),
                   [](const Individual& a, const Individual& b) { return IsBetter(a.score, b.score); });
}

bool Holds(const Population& population, const LatticePoint& point) {
  return std::any_of(population.begin(), population.end(),
                     [&](const Individual& member) { return member.point == point; });
}

// A share of the range away, towards the further bound.
LatticePoint SteppedAlong(const Lattice& lattice, LatticePoint point, std::size_t axis, double share = kAxisStep) {
  const std::int64_t count = lattice.count(axis);
  const auto step = std::max<std::int64_t>(1, std::llround(share * static_cast<double>(count - 1)));
  point[axis] += 2 * point[axis] > count ? -step : step;
  return point;
}

}  // namespace

LatticeSimplex::LatticeSimplex(const Lattice& lattice, Population members) : lattice_(&lattice) {
  SortBestFirst(members);
  for (const Individual& member : members) {
    if (vertices_.size() <= lattice.size() && !Holds(vertices_, member.point)) vertices_.push_back(member);
  }
  for (std::size_t j = 0; vertices_.size() + asked_.size() <= lattice.size(); ++j)
    asked_.push_back(SteppedAlong(lattice, vertices_.front().point, j));
  if (asked_.empty()) Iterate();
}

LatticeSimplex::LatticeSimplex(const Lattice& lattice, Individual from, const std::vector<std::size_t>& axes,
                               double share)
    : lattice_(&lattice), vertices_{std::move(from)} {
  for (const std::size_t axis : axes) asked_.push_back(SteppedAlong(lattice, vertices_.front().point, axis, share));
}

void LatticeSimplex::Tell(const std::vector<Score>& scores) {
  const Individual first = {asked_.front(), scores.front()};
  switch (stage_) {
    case Stage::kVertices:
      for (std::size_t i = 0; i < scores.size(); ++i) vertices_.push_back({asked_[i], scores[i]});
      return Iterate();
    case Stage::kReflection: return Reflected(first);
    case Stage::kExpansion: return ReplaceWorst(IsBetter(first.score, reflected_.score) ? first : reflected_);
    case Stage::kContraction: return IsBetter(first.score, limit_) ? ReplaceWorst(first) : Shrink();
    case Stage::kShrinkage:
      for (std::size_t i = 0; i < scores.size(); ++i) vertices_[i + 1] = {asked_[i], scores[i]};
      ++iterations_;
      return Iterate();
  }
}

bool LatticeSimplex::IsCollapsed() const {
  const LatticePoint& best = vertices_.front().point;
  return std::all_of(vertices_.begin(), vertices_.end(), [&](const Individual& vertex) {
    for (std::size_t j = 0; j < best.size(); ++j) {
      if (std::abs(vertex.point[j] - best[j]) > 1) return false;
    }
    return true;
  });
}

void LatticeSimplex::Reflected(const Individual& reflected) {
  reflected_ = reflected;
  if (IsBetter(reflected.score, vertices_.front().score)) return AskThrough(kExpand, Stage::kExpansion);
  if (IsBetter(reflected.score, vertices_[vertices_.size() - 2].score)) return ReplaceWorst(reflected);
  Contract(IsBetter(reflected.score, vertices_.back().score));
}

void LatticeSimplex::Contract(bool outside) {
  limit_ = outside ? reflected_.score : vertices_.back().score;
  AskThrough(outside ? kContractOutside : kContractInside, Stage::kContraction);
}

// All vertices halfway to the best.
void LatticeSimplex::Shrink() {
  const LatticePoint& best = vertices_.front().point;
  asked_.clear();
  for (std::size_t i = 1; i < vertices_.size(); ++i) {
    LatticePoint point = best;
    for (std::size_t j = 0; j < point.size(); ++j)
      point[j] += std::llround(0.5 * static_cast<double>(vertices_[i].point[j] - best[j]));
    asked_.push_back(std::move(point));
  }
  stage_ = Stage::kShrinkage;
}

void LatticeSimplex::ReplaceWorst(const Individual& vertex) {
  vertices_.back() = vertex;
  ++iterations_;
  Iterate();
}

void LatticeSimplex::Iterate() {
  SortBestFirst(vertices_);
  AskThrough(kReflect, Stage::kReflection);
}

void LatticeSimplex::AskThrough(double share, Stage stage) {
  asked_ = {Through(share)};
  stage_ = stage;
}

LatticePoint LatticeSimplex::Through(double share) const {
  const LatticePoint& worst = vertices_.back().point;
  LatticePoint point(worst.size());
  for (std::size_t j = 0; j < point.size(); ++j) {
    double centroid = 0;
    for (std::size_t i = 0; i + 1 < vertices_.size(); ++i) centroid += static_cast<double>(vertices_[i].point[j]);
    centroid /= static_cast<double>(vertices_.size() - 1);
    const double from = static_cast<double>(worst[j]);
    const double last = static_cast<double>(lattice_->count(j));
    point[j] = std::llround(std::clamp(from + share * (centroid - from), 1.0, last));
  }
  return point;
}

}  // namespace fourpost
