#include "identify/command_line/fit_progress.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "analysis/text/progress_text.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/progress_line.h"

namespace fourpost {
namespace {

/// One line of how a fit gets on, what matters first.
class FitLine {
 public:
  explicit FitLine(FitOptions options) : options_(std::move(options)) {}

  void Show(const FitProgress& progress) {
    const double seconds = line_.seconds();
    if (progress.stage != stage_) stage_began_s_ = part_began_s_ = seconds;
    if (progress.profiled != profiled_) part_began_s_ = seconds;
    stage_ = progress.stage;
    profiled_ = progress.profiled;
    const auto computed = static_cast<double>(progress.paid - progress.restored);
    line_.Show(
        std::string(progress.stage) + ": " + Done(progress) + Rate(computed, seconds, "evaluations") +
        Best(progress.best_cost) + "; in all " + std::to_string(progress.paid) + " evaluations (" +
        std::to_string(progress.reused) + " reused, " + std::to_string(progress.failed) + " failed, " +
        std::to_string(progress.restored) + " from the archive)" +
        (progress.coarse > 0 ? "; " + std::to_string(progress.coarse) + " with a quarter of the frequencies" : ""));
  }

 private:
  /// Of this stage, with the time left where the end is known.
  std::string Done(const FitProgress& progress) const {
    const double seconds = line_.seconds();
    if (progress.stage == "search") {
      const std::int64_t all = options_.stop.max_evaluations;
      // The last generation is not cut short.
      const std::int64_t done = std::min(progress.in_stage, all);
      const bool tells_pace = progress.paid > progress.restored;
      return Of(done, all) + " evaluations" + (tells_pace ? TimeLeft(Share(done, all), seconds - stage_began_s_) : "");
    }
    if (progress.stage == "profile") {
      const auto all = static_cast<std::int64_t>(options_.profiled.size());
      const auto done = static_cast<std::int64_t>(progress.profiled);
      return Of(done, all) + " parameters" +
             TimeLeft(Share(done, all), part_began_s_ - stage_began_s_, seconds - part_began_s_);
    }
    return std::to_string(progress.in_stage) + " evaluations";
  }

  static std::string Of(std::int64_t done, std::int64_t all) {
    return std::to_string(done) + " of " + std::to_string(all);
  }

  static double Share(std::int64_t done, std::int64_t all) {
    return static_cast<double>(done) / static_cast<double>(all);
  }

  std::string Best(double cost) const {
    if (!std::isfinite(cost)) return "";
    const RobustLoss& loss = options_.refine.loss;
    return ", best cost " + Rounded(cost, 5) +
           (loss.kind() == LossKind::kNone ? "" : " by " + std::string(loss.name()));
  }

  FitOptions options_;
  ProgressLine line_;
  std::string_view stage_;
  std::size_t profiled_ = 0;
  double stage_began_s_ = 0;
  /// The profile of a parameter.
  double part_began_s_ = 0;
};

}  // namespace

FitHooks ShownFit(const FitOptions& options) {
  const auto line = std::make_shared<FitLine>(options);
  return {.progress = [line](const FitProgress& progress) { line->Show(progress); }, .stop = Interrupted};
}

}  // namespace fourpost
