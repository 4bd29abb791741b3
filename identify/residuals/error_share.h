#pragma once

#include <string>

namespace fourpost {

/// A channel of one recording: squares of the errors and of what was measured, whose sums over several make an error in
/// percent of all.
struct ErrorShare {
  std::string channel;
  std::string recording;
  /// Only what is alike here adds up: gains of one unit, or signals of one.
  std::string kind;
  std::string unit;
  /// Of amplitudes over frequency, which pass nodes where small errors are large shares.
  bool has_nodes = false;
  double error = 0;
  double measured = 0;
};

}  // namespace fourpost
