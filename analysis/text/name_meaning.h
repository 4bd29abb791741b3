#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace fourpost {

/// In lower case; split where no letters are, where a capital follows a small letter, and before digits.
std::vector<std::string> WordsOf(std::string_view name);

/// What the name of a channel, a sensor, a post or a tyre says.
struct NameMeaning {
  /// "body", "axle", "strut", "tyre" and "post" for all words that mean these; others as they are, in lower case.
  /// Without words for quantities, which units say.
  std::set<std::string> words;
  /// 1 front, -1 rear, 0 not said; 1 left, -1 right, 0 not said.
  int front = 0;
  int left = 0;
};

/// Of names such as "F_tyre_FL", "Damper Pot LF", "accHubRR", "zfl" and "Radlast_VL" (German corners and words, too;
/// words of Italian, French and Spanish, with or without accents).
NameMeaning MeaningOf(std::string_view name);

/// Of the names of one recording or one vehicle. What stands for a place only beside others of its kind is read by
/// these: "pot_F" and "pot_R" are front and rear, "pot_L" and "pot_R" left and right, "Weg v" and "Weg h" German front
/// and rear. An "F", "R" or "L" that stands alone at the end means front, rear (not where posts stand left and right,
/// for it may be right) and left.
std::vector<NameMeaning> MeaningsOf(const std::vector<std::string>& names, bool has_sides);

/// Whether both name parts of a vehicle or rig, such as "post" and "strut", and none in common.
bool NameOtherParts(const NameMeaning& one, const NameMeaning& other);

/// From 0, nothing in common, to 1, the same; -1 where they are at different places.
double Likeness(const NameMeaning& one, const NameMeaning& other);

}  // namespace fourpost
