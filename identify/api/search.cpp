#include <fourpost/search.h>

#include "analysis/text/nearest.h"
#include "identify/api/errors.h"
#include "identify/api/findings.h"
#include "identify/refine/search_method_list.h"

namespace fourpost::api {
namespace {

Lattice LatticeOf(const std::vector<Axis>& axes) {
  std::vector<LatticeAxis> own;
  for (const Axis& axis : axes) own.push_back({axis.name, axis.lower, axis.upper, axis.precision, axis.is_discrete});
  Diagnostics found;
  for (const std::string& fault : LatticeFaults(own)) found.Report(kSearchAxes, {}, {fault});
  if (found.HasErrors()) throw FaultyInput(found);
  return Lattice(std::move(own));
}

/// A count of residuals is not asked for: methods that need as many as axes do without.
Problem ProblemOf(const std::vector<Axis>& axes, const Residuals& residuals) {
  return {LatticeOf(axes), [residuals](const Eigen::VectorXd& values) {
            Evaluation evaluation;
            evaluation.residuals = residuals(values);
            return evaluation;
          }};
}

void RequireMethod(const std::string& method) {
  if (std::find(kMethodNames.begin(), kMethodNames.end(), method) == kMethodNames.end())
    Refuse(kSearchMethod, {}, {method, DidYouMeanOrAll(method, kMethodNames)});
}

}  // namespace

Minimum Minimise(const std::vector<Axis>& axes, const Residuals& residuals, const SearchOptions& options) {
  return Guarded([&] {
    RequireMethod(options.method);
    Archive archive(ProblemOf(axes, residuals), options.threads);
    StopRules rules{.max_evaluations = options.evaluations};
    rules.target_cost = options.target;
    const SearchResult result = RunMethod(MethodPreset(options.method, archive.problem()), archive, options.seed, rules,
                                          {.count = 1}, {.stop = options.stop});
    if (result.candidates.empty()) throw SimulationError(kSearchAllFailed, {result.reason});
    return Minimum{.values = result.best().values,
                   .cost = result.best().cost,
                   .evaluations = archive.counts().paid,
                   .reason = result.reason};
  });
}

}  // namespace fourpost::api
