#pragma once

namespace fourpost {

/// Root mean square, over that of the largest channel of its kind in the same recording, below which a channel does not
/// move: a 16-bit recorder whose range is three times the rms of the largest has steps of 6 / 2^16 of it.
inline constexpr double kMotionlessShare = 1e-4;

}  // namespace fourpost
