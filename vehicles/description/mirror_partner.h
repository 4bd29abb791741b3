#pragma once

#include <string>
#include <vector>

namespace fourpost {

/// Names that the mirror partner of a left element may have: "coil_left" gives "coil_right", "tyre FL" gives "tyre FR".
/// Words of the pairs left-right, l-r, fl-fr, rl-rr, lf-rf, lr-rr and lh-rh are replaced, one at a time, if they stand
/// between characters other than letters or between letters of the other case ("coilLeft").
std::vector<std::string> MirrorPartners(const std::string& left);

}  // namespace fourpost
