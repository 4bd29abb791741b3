#pragma once

#include <cstddef>
#include <vector>

namespace fourpost {

/// A stepped sine on the posts: post p moves as shape[p] amplitude sin(2 pi f t).
struct Excitation {
  /// Positive.
  std::vector<double> frequency_Hz;
  /// One per frequency, positive [m]; that of the reference post, whose shape is 1.
  std::vector<double> amplitude_m;
  /// One per post: its motion relative to the reference, negative for opposite phase.
  std::vector<double> shape;

  /// Throws std::invalid_argument naming the field with a wrong size, or with a value that is not finite or not
  /// positive.
  void Validate(std::size_t post_count) const;
};

}  // namespace fourpost
