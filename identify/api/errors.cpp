#include "identify/api/errors.h"

#include <algorithm>
#include <cmath>

#include "analysis/text/found.h"
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

void EndSimulation(const SimulationError& error) {
  const std::string text = error.what();
  const std::string without_id = WithoutId(text);
  std::vector<Finding> findings;
  if (without_id.size() < text.size())
    findings.push_back({.code = text.substr(without_id.size() + 2, text.size() - without_id.size() - 3),
                        .is_error = true,
                        .text = without_id});
  throw Error(Error::Kind::kSimulation, text, std::move(findings));
}

void RefuseArgument(const std::string& why) {
  Diagnostics found;
  found.Report(kArgumentRefused, {}, {why});
  throw Error(Error::Kind::kInput, found.Format(), FindingsOf(found));
}

void RequireFinite(const std::string& what, std::span<const double> numbers) {
  const auto is_finite = [](double number) { return std::isfinite(number); };
  if (!std::all_of(numbers.begin(), numbers.end(), is_finite)) Refuse(kNumberNotFinite, {}, {what});
}

}  // namespace fourpost::api
