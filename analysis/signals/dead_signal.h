#pragma once

#include <span>

namespace fourpost {

/// Whether a signal holds nothing but noise of its converter, as that of a sensor without a plug: its rms about the
/// mean is below two levels (see LevelOf), and nothing of it lasts from one sample to the next. False of a constant,
/// and of fewer than 64 samples.
bool IsDead(std::span<const double> signal);

}  // namespace fourpost
