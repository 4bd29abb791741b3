#pragma once

namespace fourpost {

/// Processor time of the calling thread since it began [s]: what a busy machine takes from it does not count.
double ThreadTime_s();

}  // namespace fourpost
