#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fourpost {

/// A part of a signal in blocks of samples, some dozens in a cycle, for sines of about one frequency.
struct SignalBlocks {
  /// Samples in a block, and the middle of the first one.
  double size = 1;
  double origin = 0;
  std::vector<double> values;

  /// `first` to `last`: samples, cut to the signal.
  SignalBlocks(std::span<const double> signal, double first, double last, double cycles_per_sample);

  /// Places of the first block at or after a sample, and behind the last before it.
  std::size_t Place(double sample) const;
  double TimeOf(std::size_t block) const { return origin + static_cast<double>(block) * size; }
};

/// A sine with its first overtone and an offset, fitted to blocks by least squares. It goes on beyond them.
class LocalSine {
 public:
  /// Blocks `first` to `last`, the last excluded, eight at least.
  LocalSine(const SignalBlocks& blocks, std::size_t first, std::size_t last, double cycles_per_sample);

  double cycles_per_sample() const { return cycles_per_sample_; }
  double amplitude() const;
  /// What it does not explain, root mean square over its blocks.
  double rest() const { return rest_; }
  /// Mean square of what it is off other blocks.
  double SquareOff(const SignalBlocks& blocks, std::size_t first, std::size_t last) const;

 private:
  double At(double time) const;

  double cycles_per_sample_;
  /// Of its phase.
  double origin_;
  /// Offset, cosine, sine, cosine and sine of the overtone.
  double value_[5] = {};
  double rest_ = 0;
};

/// That whose frequency leaves the least, within `reach` of `cycles_per_sample`, a share of it, to `reach` / 6^rounds.
LocalSine BestSine(const SignalBlocks& blocks, std::size_t first, std::size_t last, double cycles_per_sample,
                   double reach, int rounds);

}  // namespace fourpost
