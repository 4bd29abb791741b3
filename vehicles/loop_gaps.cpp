#include "vehicles/loop_gaps.h"

#include <cmath>
#include <string>

#include "analysis/units.h"

namespace fourpost {
namespace {

/// `excess`: distance of the points above what the closure allows [m].
std::string GapText(const std::string& element, double excess, const std::string& how) {
  return "the loop cannot be closed: the two points of " + element + " stay " +
         FormatQuantity(std::round(std::abs(excess) * 1e6) * 1e-6, "mm") + " " + how +
         "; correct their positions or the joints between them";
}

}  // namespace

Diagnostics LoopGapFaults(const Vehicle& vehicle, const std::vector<double>& rod_lengths,
                          const std::function<double(const Point&, const Point&)>& distance) {
  // A thousand times what a closed loop leaves, a thousandth of what is printed.
  constexpr double kGap_m = 1e-9;
  Diagnostics faults;
  const auto check = [&](const char* tag, const auto& closures) {
    for (const auto& closure : closures)
      if (const double gap = distance(closure.parent, closure.child); gap > kGap_m)
        faults.Error(vehicle.file, closure.source_line,
                     GapText(std::string(tag) + " '" + closure.name + "'", gap, "apart"));
  };
  check("fp:ball", vehicle.balls);
  check("fp:weld", vehicle.welds);
  check("fp:hinge", vehicle.hinges);
  for (std::size_t i = 0; i < vehicle.rods.size(); ++i) {
    const Rod& rod = vehicle.rods[i];
    const double excess = distance(rod.parent, rod.child) - rod_lengths[i];
    if (std::abs(excess) > kGap_m)
      faults.Error(
          vehicle.file, rod.source_line,
          GapText("fp:rod '" + rod.name + "'", excess, excess > 0 ? "too far apart for it" : "too near for it"));
  }
  if (!faults.HasErrors())
    faults.Error(vehicle.file, 0,
                 "the loops cannot be closed: the directions that fp:weld and fp:hinge keep do not go together");
  return faults;
}

}  // namespace fourpost
