#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// A vehicle that is let go, in samples of a record.
struct ReleaseSamples {
  /// First at rest before; `let_go` where the record begins in motion.
  std::size_t rest_from = 0;
  /// First that has left the rest.
  std::size_t let_go = 0;
  /// First at rest again, and the one behind the last.
  std::size_t rest = 0;
  std::size_t end = 0;
};

/// Where the vehicle is let go: it moves suddenly, which is a tenth of a signal's largest motion within 50 ms of rest,
/// by less and less, and then rests for half a second at least. A motion a fifth as large as the largest of the record
/// counts, so a lift by a hoist or a knock does not. `signals`: of one length, in any unit; what rests is found in
/// blocks of 50 ms and 16 samples at least, by their deviations beside those of the quietest. Samples that are no
/// finite numbers are passed over.
std::vector<ReleaseSamples> ReleasesOf(std::span<const std::span<const double>> signals, double rate_Hz);

/// By how much a signal rises from begin to end of a record by its slope at rest: that which the rests before and after
/// releases have in common, each with a level of its own. A line through all takes what is let go for a drift. 0 where
/// they hold fewer than three samples.
double DriftAtRest(std::span<const double> signal, std::span<const ReleaseSamples> releases);

/// The signal's mean at rest before a release less that after it; 0 without a rest before, or within `noise` times its
/// deviation there.
double StepOf(std::span<const double> signal, const ReleaseSamples& release, double noise = 5);

}  // namespace fourpost
