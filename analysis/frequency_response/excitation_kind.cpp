#include "analysis/frequency_response/excitation_kind.h"

#include "analysis/frequency_response/multisine.h"

namespace fourpost {

ExcitationKind KindOf(std::span<const double> post, std::span<const TonePoint> track, std::span<const Dwell> dwells) {
  constexpr double kMostInDwells = 0.5;
  constexpr double kTonal = 0.9;
  const double tonal = TonalShare(track);
  if (tonal > kMostInDwells && ShareInDwells(track, dwells) > kMostInDwells) return ExcitationKind::kStepped;
  if (tonal > kTonal) return ExcitationKind::kSweep;
  return PeriodOf(post) ? ExcitationKind::kMultisine : ExcitationKind::kRandom;
}

}  // namespace fourpost
