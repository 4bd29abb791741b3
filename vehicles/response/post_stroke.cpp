#include "vehicles/response/post_stroke.h"

#include <cmath>

#include "analysis/text/count_check.h"
#include "analysis/text/number.h"
#include "vehicles/response/findings.h"

namespace fourpost {
namespace {

/// To a hundredth of a millimetre.
std::string Millimetres(double metres) { return FormatNumber(std::round(metres * 1e5) / 1e2) + " mm"; }

}  // namespace

void CheckStroke(const Vehicle& vehicle, std::span<const double> excursion_m, const std::string& motion,
                 Diagnostics& diagnostics, std::optional<double> otherwise_m) {
  RequireCount("CheckStroke", "posts", vehicle.posts.size(), excursion_m.size());
  // Rounding of an amplitude that uses the whole stroke.
  constexpr double kSlack = 1e-9;
  for (std::size_t p = 0; p < vehicle.posts.size(); ++p) {
    const Post& post = vehicle.posts[p];
    const std::optional<double> stroke = post.stroke ? post.stroke : otherwise_m;
    if (!stroke) continue;
    const double reach = *stroke / 2;
    if (excursion_m[p] <= reach * (1 + kSlack)) continue;
    diagnostics.Report(post.stroke ? kStrokeExceeded : kUsualStrokeExceeded, {vehicle.file, post.source_line},
                       {post.name, Millimetres(reach), motion, Millimetres(excursion_m[p])});
  }
}

}  // namespace fourpost
