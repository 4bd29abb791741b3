#pragma once

#include <string>
#include <vector>

#include "identify/experiments/bench/bench_result.h"

namespace fourpost {

/// Work diagrams (force over displacement) and characteristic diagrams (force over speed), measured and modelled, of
/// one cycle of each recording at each of the frequencies 1, 2, 5, 10, 15, 20, 25 Hz that it holds.
std::string DiagramSvg(const std::string& title, const std::vector<ModelledRecording>& recordings);

/// Force, speed and frequency in one picture: the characteristic curves of DiagramSvg over each other, one colour per
/// frequency, measured beside modelled, the slow ones on the left and those from 10 Hz on, which are smaller, on the
/// right.
std::string FrequencySvg(const std::string& title, const std::vector<ModelledRecording>& recordings);

/// Linear equivalent damping and dynamic stiffness of every cycle over its frequency, measured and modelled.
std::string EquivalentSvg(const std::string& title, const std::vector<ModelledRecording>& recordings);

}  // namespace fourpost
