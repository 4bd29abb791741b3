#include "identify/search/idle_parameters.h"

#include <algorithm>

#include "identify/search/draws.h"
#include "identify/search/dvhde_operators.h"
#include "identify/search/findings.h"

namespace fourpost {
namespace {

constexpr int kPlaces = 4;

// The point, and others that differ in this gene alone.
std::vector<LatticePoint> PlacesAlong(const Lattice& lattice, const LatticePoint& point, std::size_t axis) {
  std::vector<LatticePoint> points = {point};
  for (int k = 0; k < kPlaces; ++k) {
    points.push_back(point);
    points.back()[axis] = 1 + k * (lattice.count(axis) - 1) / (kPlaces - 1);
  }
  return points;
}

bool IsIdle(Archive& archive, const LatticePoint& point, std::size_t axis) {
  const std::vector<Score> scores = archive.Evaluate(PlacesAlong(archive.lattice(), point, axis));
  return scores.front().ok() &&
         std::all_of(scores.begin(), scores.end(), [&](const Score& score) { return score == scores.front(); });
}

// Some that can be evaluated; fewer when few can.
std::vector<LatticePoint> PointsToProbe(Archive& archive) {
  constexpr std::size_t kWanted = 2;
  constexpr std::size_t kTries = 50;
  std::vector<LatticePoint> points;
  for (std::size_t i = 0; i < kTries && points.size() < kWanted; ++i) {
    Draws draws(0, DrawPurpose::kProbe, 0, i);
    const LatticePoint point = RandomPoint(archive.lattice(), draws);
    if (archive.Evaluate({point}).front().ok()) points.push_back(point);
  }
  return points;
}

}  // namespace

std::vector<std::string> IdleParameters(Archive& archive) {
  const std::vector<LatticePoint> points = PointsToProbe(archive);
  std::vector<std::string> idle;
  for (std::size_t j = 0; j < archive.lattice().size(); ++j) {
    const auto is_idle = [&](const LatticePoint& point) { return IsIdle(archive, point, j); };
    if (!points.empty() && std::all_of(points.begin(), points.end(), is_idle))
      idle.push_back(archive.lattice().axes()[j].name);
  }
  return idle;
}

void CheckEffects(Archive& archive, const std::string& file, Diagnostics& diagnostics) {
  const std::vector<std::string> idle = IdleParameters(archive);
  if (idle.size() == archive.lattice().size()) return diagnostics.Report(kObjectiveConstant, {file});
  for (const std::string& name : idle) diagnostics.Report(kObjectiveIgnores, {file}, {name});
}

}  // namespace fourpost
