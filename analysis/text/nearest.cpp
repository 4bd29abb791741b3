#include "analysis/text/nearest.h"

#include <algorithm>
#include <vector>

namespace fourpost {
namespace {

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

/// Damerau-Levenshtein distance in its form of optimal string alignment: a swapped pair counts as one edit and is not
/// edited again.
std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool equal = a[i - 1] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (equal ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

/// Nobody types longer ones, and comparing two of megabytes would take hours.
constexpr std::size_t kLongestName = 200;

template <typename Name>
std::optional<std::string_view> Nearest(std::string_view name, std::span<const Name> legal) {
  std::optional<std::string_view> nearest;
  std::size_t least = 0;
  if (name.size() > kLongestName) return nearest;
  const std::string lower = LowerCase(name);
  for (const Name& candidate : legal) {
    if (candidate.size() > kLongestName) continue;
    const std::size_t distance = EditDistance(lower, LowerCase(candidate));
    const bool near_enough = 3 * distance <= std::max(name.size(), candidate.size());
    if (!near_enough || (nearest && distance >= least)) continue;
    nearest = candidate;
    least = distance;
  }
  return nearest;
}

std::string Suffix(std::optional<std::string_view> nearest) {
  return nearest ? ", did you mean '" + std::string(*nearest) + "'?" : std::string();
}

template <typename Name>
std::string SuffixOrAll(std::string_view name, std::span<const Name> legal) {
  std::string text = Suffix(Nearest(name, legal));
  if (!text.empty()) return text;
  for (const std::string_view candidate : legal)
    text += (text.empty() ? "; there are " : ", ") + std::string(candidate);
  return text;
}

}  // namespace

std::optional<std::string_view> NearestName(std::string_view name, std::span<const std::string_view> legal) {
  return Nearest(name, legal);
}

std::optional<std::string_view> NearestName(std::string_view name, std::span<const std::string> legal) {
  return Nearest(name, legal);
}

std::string DidYouMean(std::string_view name, std::span<const std::string_view> legal) {
  return Suffix(Nearest(name, legal));
}

std::string DidYouMean(std::string_view name, std::span<const std::string> legal) {
  return Suffix(Nearest(name, legal));
}

std::string DidYouMeanOrAll(std::string_view name, std::span<const std::string_view> legal) {
  return SuffixOrAll(name, legal);
}

std::string DidYouMeanOrAll(std::string_view name, std::span<const std::string> legal) {
  return SuffixOrAll(name, legal);
}

}  // namespace fourpost
