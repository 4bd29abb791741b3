#include "identify/study_file/own_fault.h"

#include <algorithm>

namespace fourpost {

Diagnostics WithoutOwnFaults(const Diagnostics& found, std::initializer_list<const Finding*> kinds,
                             Diagnostics& diagnostics) {
  Diagnostics rest;
  for (const Diagnostic& item : found.items()) {
    const bool is_own =
        item.severity == Severity::kError &&
        std::any_of(kinds.begin(), kinds.end(), [&](const Finding* kind) { return item.id == kind->id(); });
    (is_own ? diagnostics : rest).Add(item);
  }
  return rest;
}

}  // namespace fourpost
