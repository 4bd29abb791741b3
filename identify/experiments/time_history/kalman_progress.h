#pragma once

#include <functional>

#include "analysis/process/work_hooks.h"

namespace fourpost {

/// Shows how an estimate of a Kalman filter's noise gets on, called with its runs so far. The hooks must outlive it.
std::function<void(int runs)> KalmanProgress(const WorkHooks& hooks);

}  // namespace fourpost
