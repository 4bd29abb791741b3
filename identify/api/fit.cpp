#include <fourpost/fit.h>

#include <limits>

#include "analysis/files/output_folder.h"
#include "identify/api/errors.h"
#include "identify/api/result_reader.h"
#include "identify/run/findings.h"
#include "identify/run/fit_run.h"

namespace fourpost::api {

Result Fit(const Study& study, const std::filesystem::path& folder, const FitOptions& options) {
  const std::filesystem::path file = study.Write(folder / kInputsFolder);
  return Guarded([&] {
    const FitRequest request{.study = file,
                             .output = folder,
                             .seed = options.seed,
                             .threads = options.threads,
                             .resume = options.resume,
                             .accept_unidentified = options.accept_unidentified,
                             .accept_implausible = options.accept_implausible};
    FitProgress progress{.best_cost = std::numeric_limits<double>::infinity()};
    const auto show = [&] {
      if (options.progress) options.progress(progress);
    };
    FitRunHooks hooks;
    hooks.work.stop = options.stop;
    hooks.work.show = [&](const std::string& text) {
      progress.stage = text;
      show();
    };
    hooks.find = [&](const Diagnostics& found) {
      if (options.warn)
        for (const Finding& finding : FindingsOf(found)) options.warn(finding);
    };
    hooks.fit = [&](const fourpost::FitOptions&) {
      FitHooks asked;
      asked.stop = options.stop;
      asked.progress = [&](const fourpost::FitProgress& now) {
        progress = {
            .stage = std::string(now.stage), .evaluations = now.paid, .failed = now.failed, .best_cost = now.best_cost};
        show();
      };
      return asked;
    };
    const FitRun run = FitStudy(request, hooks);
    if (!run.is_written)
      throw SimulationError(run.fit.end == FitEnd::kInterrupted ? kFitInterrupted : kFitWithoutResults,
                            {std::string(FitEndName(run.fit.end)), run.fit.message});
    return ResultOf(run.json, folder);
  });
}

}  // namespace fourpost::api
