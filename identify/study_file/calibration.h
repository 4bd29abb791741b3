#pragma once

#include <string>

namespace fourpost {

/// Something of a rig's instruments that is known to a standard deviation only, as a study states it under
/// 'calibration'.
struct Calibration {
  enum class Kind {
    /// A factor of what is read, about 1.
    kGain,
    /// By how much a channel, or the posts, lag what they measure [s].
    kDelay,
    /// What a load at rest is read too large by [N].
    kOffset,
  };
  Kind kind = Kind::kGain;
  /// A sensor, or what shares the error: "accelerometers", "displacements", "struts", "load_cells", "gyros", "posts",
  /// "static_loads".
  std::string of;
  /// A share, seconds or newtons.
  double sd = 0;
  int line = 0;

  bool IsOfPosts() const { return of == kPosts; }
  bool IsOfStaticLoads() const { return of == kStaticLoads; }
  /// "gain of accelerometers"
  std::string Name() const;
  /// SI.
  std::string Unit() const;

  static constexpr const char* kPosts = "posts";
  static constexpr const char* kStaticLoads = "static_loads";
};

}  // namespace fourpost
