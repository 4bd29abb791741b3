#include "identify/api/errors.h"

#include "analysis/text/nearest.h"
#include "identify/api/findings.h"

namespace fourpost::api {

std::vector<Finding> FindingsOf(const Diagnostics& diagnostics) {
  std::vector<Finding> findings;
  for (const Diagnostic& item : diagnostics.items())
    findings.push_back({.code = item.id,
                        .is_error = item.severity == Severity::kError,
                        .file = item.place.file,
                        .line = item.place.line,
                        .argument = item.place.option,
                        .text = item.message});
  return findings;
}

void RefuseName(const std::string& noun, const std::string& name, const std::vector<std::string>& known) {
  Guarded([&] { Refuse(kNameUnknown, {}, {noun, name, DidYouMeanOrAll(name, known)}); });
  throw std::logic_error("unreachable");
}

}  // namespace fourpost::api
