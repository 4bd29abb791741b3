#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace fourpost {

/// How a signal stands at an end of its range.
struct Clipping {
  /// Where it stands; with noise on it, its mean there.
  double level = 0;
  /// Standard deviation of that noise; 0: it stands at one value exactly.
  double noise = 0;
  std::size_t samples = 0;
  /// The first of them.
  std::size_t first = 0;
};

/// Samples at the greatest value, exactly (see ClippedAtTop) or but for noise, as where it was added behind what
/// clipped: of the samples in the upper twentieth of the span that follow each other noise shows in their
/// differences, s; those within 8 s of the greatest are at the top, in runs of six at least that begin and end steeply,
/// by three times as much within an eighth of the run. A crest, however flat its noise makes it, ends slowly: that of a
/// sine falls by half as much. Nothing below kFewestClipped of them in all, and under noise of more than 0.15 % of the
/// span, where a force of friction looks the same.
std::optional<Clipping> ClippingAtTop(std::span<const double> signal);
std::optional<Clipping> ClippingAtBottom(std::span<const double> signal);

/// Of a signal that is clipped at one end at least.
struct ClippedEnds {
  std::optional<Clipping> top;
  std::optional<Clipping> bottom;

  /// Whether one stands at one value exactly: noise may hide that a force of friction alone is flat by itself.
  bool is_exact() const;
  /// Whether a sample stands at such a value.
  bool IsExactAt(double value) const;
  /// The first sample of both.
  std::size_t first() const;
  /// "is clipped: 30 samples stand at 200 N exactly, the first at 1.5 s"; "looks clipped: ..." under noise. `first_s`:
  /// when first() was.
  std::string Text(const std::string& unit, double first_s) const;
  /// "30 samples stand at 200 N exactly, the first at 1.5 s".
  std::string Samples(const std::string& unit, double first_s) const;
};

/// Nothing where neither end is clipped.
std::optional<ClippedEnds> ClippingAtEnds(std::span<const double> signal);

}  // namespace fourpost
