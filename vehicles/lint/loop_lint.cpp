#include "vehicles/lint/loop_lint.h"

#include "vehicles/description/design_poses.h"
#include "vehicles/description/element_list.h"
#include "vehicles/lint/findings.h"
#include "vehicles/multibody/loop_gaps.h"

namespace fourpost {
namespace {

/// The link whose centre of mass lies furthest from where it is written: "link 'body' by 1.2 mm".
std::string FurthestMoved(const LintSubject& subject) {
  // Of mirror images the first.
  constexpr double kAlike = 1e-6;
  const std::vector<Eigen::Isometry3d> written = DesignPoses(subject.vehicle);
  const Link* furthest = nullptr;
  double most = 0;
  for (std::size_t i = 1; i < subject.vehicle.links.size(); ++i) {
    const Link& link = subject.vehicle.links[i];
    const Point com{static_cast<int>(i), link.ComAt(subject.values)};
    const double moved = (subject.Place(com) - PlaceOf(com, written)).norm();
    if (moved <= (1 + kAlike) * most) continue;
    most = moved;
    furthest = &link;
  }
  return furthest ? Called("link", furthest->name) + " by " + Readable(most, "m") : "nothing";
}

}  // namespace

void LintOpenClosures(const LintSubject& subject, FileFaults& findings) {
  for (const OpenClosure& closure : OpenClosures(subject.vehicle, kDrawnGap_m))
    findings.Report(kClosureOpen, closure.source_line,
                    {closure.element, Readable(closure.gap, "m"), FurthestMoved(subject)});
}

}  // namespace fourpost
