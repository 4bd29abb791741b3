#include <fourpost/run.h>

#include "identify/api/errors.h"
#include "identify/api/findings.h"
#include "identify/run/run_draws.h"

namespace fourpost::api {

Draws Draw(const std::filesystem::path& run, const DrawOptions& options) {
  return Guarded([&] {
    const DrawRequest request{.run = run,
                              .study = options.noise_of_study,
                              .count = static_cast<std::size_t>(std::max(options.count, 1)),
                              .seed = options.seed,
                              .noise_only = !options.noise_of_study.empty(),
                              .threads = options.threads};
    const std::optional<RunDraws> drawn = DrawFromRun(request, {.stop = options.stop});
    if (!drawn) throw SimulationError(kCallStopped);
    return Draws{.parameters = drawn->names,
                 .units = drawn->units,
                 .values = drawn->values,
                 .held = drawn->held,
                 .warnings = FindingsOf(drawn->findings)};
  });
}

}  // namespace fourpost::api
