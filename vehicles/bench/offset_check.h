#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "analysis/signals/low_pass.h"
#include "analysis/text/diagnostics.h"
#include "vehicles/bench/bench_damper.h"

namespace fourpost {

/// A recording of a damper's force [N] on its bench. The force has passed `filter`, which has settled between the
/// samples `first` and `end`.
struct RecordedForce {
  const BenchMotion& motion;
  const std::optional<LowPass>& filter;
  std::span<const double> force;
  std::size_t first = 0;
  std::size_t end = 0;
};

/// Warns of sensor offsets, compared with the damper at these values of all parameters. Force: its mean where the
/// displacement turns back, at rest, differs from the modelled one by more than 15 % of the force's span; not checked
/// with gas or springs in parallel, whose preload a fit finds. Displacement: its mean exceeds its span, and springs,
/// gas or oil chambers would give another force there; pure velocity laws do not depend on position.
void CheckBenchOffsets(const BenchDamper& damper, const RecordedForce& recorded, std::span<const double> values,
                       const std::string& file, Diagnostics& diagnostics);

}  // namespace fourpost
