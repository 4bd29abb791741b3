#include "analysis/frequency_response/post_shares.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

namespace fourpost {
namespace {

/// Where a post is: 1 for front and left, -1 for rear and right, 0 for neither.
struct Corner {
  double front = 0;
  double left = 0;
};

struct CornerName {
  std::string_view ending;
  Corner corner;
};

constexpr std::array<CornerName, 8> kCorners = {{{"fl", {1, 1}},
                                                 {"fr", {1, -1}},
                                                 {"rl", {-1, 1}},
                                                 {"rr", {-1, -1}},
                                                 {"front", {1, 0}},
                                                 {"rear", {-1, 0}},
                                                 {"left", {0, 1}},
                                                 {"right", {0, -1}}}};

std::optional<Corner> CornerOf(const std::string& name) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const CornerName& known : kCorners)
    if (lower.ends_with(known.ending)) return known.corner;
  return std::nullopt;
}

double Rounded(double share, double deviation) {
  constexpr double kNear = 0.1;
  constexpr double kFar = 0.3;
  const double near = std::clamp(3 * deviation, kNear, kFar);
  for (const double whole : {-1.0, 0.0, 1.0})
    if (std::abs(share - whole) < near) return whole;
  return std::round(10 * share) / 10;
}

/// Which post of those that move by as much comes first is a matter of noise: the first one of the whole shares is it.
void BeginWithFirst(PostShares& shares) {
  const auto moves_alike = [](double share) { return std::abs(share) == 1; };
  const auto first = std::find_if(shares.share.begin(), shares.share.end(), moves_alike);
  shares.reference = static_cast<std::size_t>(first - shares.share.begin());
  const double sign = *first;
  // No zero is negative.
  for (double& share : shares.share) share = sign * share + 0.0;
}

template <typename Sign>
bool Moves(const PostShares& shares, const std::vector<Corner>& corners, Sign sign) {
  for (std::size_t p = 0; p < corners.size(); ++p) {
    const double relative = sign(corners[p]) * sign(corners[shares.reference]);
    if (relative == 0 || shares.share[p] != relative) return false;
  }
  return true;
}

}  // namespace

std::complex<double> PostShares::Motion(std::span<const std::complex<double>> posts) const {
  std::complex<double> sum;
  double square = 0;
  for (std::size_t p = 0; p < posts.size(); ++p) {
    sum += share[p] * posts[p];
    square += share[p] * share[p];
  }
  return sum / square;
}

PostShares SharesOf(const std::vector<std::vector<std::complex<double>>>& products,
                    std::optional<std::size_t> reference, const std::vector<std::vector<double>>& deviations) {
  constexpr double kMoving = 0.9;
  PostShares shares;
  const std::size_t count = products.size();
  double largest = 0;
  for (std::size_t p = 0; p < count; ++p) largest = std::max(largest, products[p][p].real());
  for (std::size_t p = count; p-- > 0;)
    if (products[p][p].real() >= kMoving * kMoving * largest) shares.reference = p;
  if (reference) shares.reference = *reference;
  const std::vector<std::complex<double>>& row = products[shares.reference];
  const double own = row[shares.reference].real();
  for (std::size_t p = 0; p < count; ++p) {
    const double deviation = deviations.empty() ? 0 : deviations[shares.reference][p];
    shares.share.push_back(p == shares.reference ? 1 : Rounded(row[p].real() / own, deviation));
  }
  if (!reference) BeginWithFirst(shares);
  double square = 0;
  double all = 0;
  for (std::size_t p = 0; p < count; ++p) {
    square += shares.share[p] * shares.share[p];
    all += products[p][p].real();
  }
  // What the projection on the shares holds: |s' x|^2 / s's.
  double held = 0;
  for (std::size_t p = 0; p < count; ++p)
    for (std::size_t q = 0; q < count; ++q) held += shares.share[p] * shares.share[q] * products[p][q].real();
  shares.rest = all > 0 ? std::sqrt(std::max(0.0, 1 - held / square / all)) : 0;
  return shares;
}

std::optional<std::string> PatternOf(const PostShares& shares, std::span<const std::string> posts) {
  if (posts.size() == 1) return "heave";
  std::vector<Corner> corners;
  for (const std::string& post : posts) {
    const std::optional<Corner> corner = CornerOf(post);
    if (!corner) return std::nullopt;
    corners.push_back(*corner);
  }
  const auto heave = [](const Corner&) { return 1.0; };
  const auto pitch = [](const Corner& corner) { return corner.front; };
  const auto roll = [](const Corner& corner) { return corner.left; };
  const auto warp = [](const Corner& corner) { return corner.front * corner.left; };
  if (Moves(shares, corners, heave)) return "heave";
  if (Moves(shares, corners, pitch)) return "pitch";
  if (Moves(shares, corners, roll)) return "roll";
  if (Moves(shares, corners, warp)) return "warp";
  return std::nullopt;
}

}  // namespace fourpost
