#include "vehicles/description/mirror_partner.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace fourpost {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 7> kPairs = {
    {{"left", "right"}, {"l", "r"}, {"fl", "fr"}, {"rl", "rr"}, {"lf", "rf"}, {"lr", "rr"}, {"lh", "rh"}}};

bool IsLower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool IsUpper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

/// Whether a word may end before, or begin after, this place.
bool IsSeam(char before, char after) {
  const bool joined = (IsLower(before) || IsUpper(before)) && (IsLower(after) || IsUpper(after));
  return !joined || (IsLower(before) && IsUpper(after));
}

bool IsWord(const std::string& text, std::size_t at, std::size_t length) {
  const std::size_t end = at + length;
  return (at == 0 || IsSeam(text[at - 1], text[at])) && (end == text.size() || IsSeam(text[end - 1], text[end]));
}

/// As it is, with a capital, in capitals.
std::array<std::string, 3> Spellings(std::string word) {
  const auto upper = [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); };
  std::string capital = word;
  capital[0] = upper(capital[0]);
  std::string capitals = word;
  std::transform(capitals.begin(), capitals.end(), capitals.begin(), upper);
  return {std::move(word), capital, capitals};
}

}  // namespace

std::vector<std::string> MirrorPartners(const std::string& left) {
  std::vector<std::string> partners;
  for (const auto& [from, to] : kPairs) {
    const std::array<std::string, 3> words = Spellings(from);
    const std::array<std::string, 3> others = Spellings(to);
    for (std::size_t k = 0; k < words.size(); ++k)
      for (std::size_t at = left.find(words[k]); at != std::string::npos; at = left.find(words[k], at + 1)) {
        if (!IsWord(left, at, words[k].size())) continue;
        std::string partner = left;
        partner.replace(at, words[k].size(), others[k]);
        if (std::find(partners.begin(), partners.end(), partner) == partners.end()) partners.push_back(partner);
      }
  }
  return partners;
}

}  // namespace fourpost
