#pragma once

#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/text/found.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// Named motions of the posts.
inline constexpr std::array<std::string_view, 4> kPostPatterns = {"heave", "pitch", "roll", "warp"};

/// All names they go by.
inline constexpr std::array<std::string_view, 5> kPostPatternNames = {"heave", "bounce", "pitch", "roll", "warp"};

/// The name among kPostPatterns of one that goes by two: "heave" of "bounce"; else the name itself.
std::string_view PatternName(std::string_view name);

/// A pattern that is unknown, or that the posts of a vehicle cannot make.
class PatternError : public std::invalid_argument {
 public:
  explicit PatternError(Found found)
      : std::invalid_argument(found.kind->Message(found.words)), found_(std::move(found)) {}
  const Found& found() const { return found_; }

 private:
  Found found_;
};

/// Shape of each post (Excitation::shape) for a pattern; the front left post is the reference:
///   heave, or bounce: all 1;   pitch: front 1, rear -1;   roll: left 1, right -1;
///   warp: front left and rear right 1, the other two corners -1.
/// Front and left are relative to the middle of the posts, halfway between the outermost; a post stands at the point of
/// its tyre in the design pose. Throws PatternError for an unknown name, and for a pattern that these posts
/// cannot make: pitch without posts at front and rear, roll without posts left and right, warp without one at each
/// corner, or any of them with a post in the middle.
std::vector<double> PostPattern(const Vehicle& vehicle, std::string_view name);

}  // namespace fourpost
