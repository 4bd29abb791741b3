#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fourpost {

/// How posts move together: each one's share of the reference's motion, 1 of the reference.
struct PostShares {
  std::vector<double> share;
  std::size_t reference = 0;
  /// Motion that the shares do not describe, as a share of all of it: errors of amplitude and phase between posts.
  double rest = 0;

  /// The motion that the shares describe, by least squares: sum share x / sum share^2.
  std::complex<double> Motion(std::span<const std::complex<double>> posts) const;
  /// Whether they describe one pattern.
  bool operator==(const PostShares& other) const { return share == other.share && reference == other.reference; }
};

/// From the matrix of products between posts, sum conj(a) b over phasors or spectral lines, row a, column b. The
/// reference is the first post that moves by 0.9 of the largest, or as much as it within noise, unless one is given.
/// Shares within 0.1 of -1, 0 and 1 are these: a rig does not follow its command exactly; others are rounded to tenths.
/// `deviations`, of the same shape: standard deviations of column b's share of row a. Three of them, up to 0.3, may be
/// more than 0.1. Empty: zero.
PostShares SharesOf(const std::vector<std::vector<std::complex<double>>>& products,
                    std::optional<std::size_t> reference = std::nullopt,
                    const std::vector<std::vector<double>>& deviations = {});

/// "heave", "pitch", "roll" or "warp" of posts named FL FR RL RR, front and rear, or left and right, in any case and
/// with anything before it, as in "post_FL"; one post alone is heave. Nothing for other motions and names.
std::optional<std::string> PatternOf(const PostShares& shares, std::span<const std::string> posts);

}  // namespace fourpost
