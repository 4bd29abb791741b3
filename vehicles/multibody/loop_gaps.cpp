#include "vehicles/multibody/loop_gaps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "vehicles/description/design_poses.h"
#include "vehicles/description/element_list.h"
#include "vehicles/multibody/findings.h"

namespace fourpost {
namespace {

/// Whether fp:mirror has made the second of the first: its tags keep their line, its gaps their size to rounding.
bool AreTwins(const OpenClosure& a, const OpenClosure& b) {
  constexpr double kRounding = 1e-9;
  return a.source_line == b.source_line && std::abs(a.gap - b.gap) <= kRounding * a.gap;
}

class OpenClosureList {
 public:
  OpenClosureList(const Vehicle& vehicle, double least) : poses_(DesignPoses(vehicle)), least_(least) {}

  template <typename Closure>
  void Add(const char* tag, const std::vector<Closure>& closures) {
    const std::size_t first = open_.size();
    for (const Closure& closure : closures) {
      const double gap = (PlaceOf(closure.parent, poses_) - PlaceOf(closure.child, poses_)).norm();
      if (!(gap > least_)) continue;
      const OpenClosure open{Called(tag, closure.name), closure.source_line, closure.parent, closure.child, gap};
      if (open_.size() > first && AreTwins(open_.back(), open))
        open_.back().element += " (and of '" + closure.name + "')";
      else open_.push_back(open);
    }
  }

  std::vector<OpenClosure> Take() { return std::move(open_); }

 private:
  std::vector<Eigen::Isometry3d> poses_;
  double least_;
  std::vector<OpenClosure> open_;
};

/// `best`: the gap that moving the bodies leaves [m].
void Report(const OpenClosure& closure, double best, const std::string& file, Diagnostics& faults) {
  // A gap that barely changes was not closed by anything that could move.
  constexpr double kNoNearer = 0.99;
  const Place place{file, closure.source_line};
  const std::string gap = Readable(closure.gap, "m");
  if (best >= kNoNearer * closure.gap) faults.Report(kLoopStuck, place, {closure.element, gap});
  else faults.Report(kLoopOpen, place, {closure.element, gap, Readable(best, "m")});
}

}  // namespace

std::vector<OpenClosure> OpenClosures(const Vehicle& vehicle, double least) {
  OpenClosureList list(vehicle, least);
  list.Add("fp:ball", vehicle.balls);
  list.Add("fp:weld", vehicle.welds);
  list.Add("fp:hinge", vehicle.hinges);
  return list.Take();
}

Diagnostics LoopGapFaults(const Vehicle& vehicle, const std::function<double(const Point&, const Point&)>& distance) {
  std::vector<OpenClosure> open = OpenClosures(vehicle, 0);
  double largest = 0;
  for (const OpenClosure& closure : open) largest = std::max(largest, closure.gap);
  // Where one is open by more than a drawing shows, those that are within it are not to blame.
  const double least = std::min(kDrawnGap_m, 0.5 * largest);
  std::erase_if(open, [&](const OpenClosure& closure) { return closure.gap < least; });
  const auto best = [&](const OpenClosure& closure) { return distance(closure.parent, closure.child); };
  // Printed as nothing, and far above what a closed loop leaves.
  constexpr double kClosed_m = 1e-6;
  const auto is_closed = [&](const OpenClosure& closure) { return best(closure) < kClosed_m; };
  if (!std::all_of(open.begin(), open.end(), is_closed)) std::erase_if(open, is_closed);
  Diagnostics faults;
  for (const OpenClosure& closure : open) Report(closure, best(closure), vehicle.file, faults);
  return faults;
}

}  // namespace fourpost
