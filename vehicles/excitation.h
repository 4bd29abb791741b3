#pragma once

#include <vector>

namespace fourpost {

/// A stepped sine on the posts: post p moves as shape[p] amplitude sin(2 pi f t).
struct Excitation {
  std::vector<double> frequency_Hz;
  /// One per frequency [m]; that of the reference, whose shape is 1.
  std::vector<double> amplitude_m;
  /// One per post: how far it moves relative to the reference, negative for opposite phase.
  std::vector<double> shape;
};

}  // namespace fourpost
