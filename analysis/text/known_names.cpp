#include "analysis/text/known_names.h"

#include "analysis/text/enumeration.h"
#include "analysis/text/nearest.h"

namespace fourpost {

std::string KnownNames(std::string_view name, std::span<const std::string> known) {
  constexpr std::size_t kFew = 12;
  const std::string near = DidYouMean(name, known);
  if (!near.empty() || known.empty() || known.size() > kFew) return near;
  return "; it has " + Enumeration(known);
}

}  // namespace fourpost
