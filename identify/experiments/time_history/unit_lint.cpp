#include "identify/experiments/time_history/unit_lint.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/text/short_number.h"
#include "identify/experiments/time_history/findings.h"
#include "identify/study_file/channel_source_text.h"
#include "identify/study_file/thousandfold.h"

namespace fourpost {
namespace {

/// What no rig for vehicles does, nor any road: a travel, and a root mean square of the velocity.
constexpr double kMostTravel_m = 5;
constexpr double kMostSpeed = 5;

struct PostMotionSize {
  double travel_m = 0;
  double speed_rms = 0;
};

PostMotionSize SizeOf(const std::vector<double>& heights, double rate_Hz) {
  if (heights.size() < 2) return {};
  const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
  double sum = 0;
  for (std::size_t k = 1; k < heights.size(); ++k) sum += std::pow((heights[k] - heights[k - 1]) * rate_Hz, 2);
  return {*most - *least, std::sqrt(sum / static_cast<double>(heights.size() - 1))};
}

class UnitLinter {
 public:
  UnitLinter(const TimeHistories& histories, Severity severity, Diagnostics& diagnostics)
      : plan_(histories.plan), severity_(severity), diagnostics_(diagnostics) {}

  /// False where the posts move as no rig does: nothing else can be judged then.
  bool CheckPosts(const MeasuredHistory& history) {
    PostMotionSize most;
    for (const std::vector<double>& heights : history.heights) {
      const PostMotionSize one = SizeOf(heights, history.rate_Hz);
      most.travel_m = std::max(most.travel_m, one.travel_m);
      most.speed_rms = std::max(most.speed_rms, one.speed_rms);
    }
    if (most.travel_m <= kMostTravel_m && most.speed_rms <= kMostSpeed) return true;
    ReportPosts(history, 1,
                "they move over " + ShortNumber(most.travel_m, 2) + " m, at " + ShortNumber(most.speed_rms, 2) +
                    " m/s rms, which no rig does");
    return false;
  }

  void CheckChannels(const MeasuredHistory& history, const Eigen::MatrixXd& modelled) {
    std::vector<int> direction;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < history.signals.size(); ++i) {
      const Eigen::VectorXd model = modelled.col(static_cast<Eigen::Index>(i));
      const double deviation = std::sqrt((model.array() - model.mean()).square().mean());
      ratios.push_back(deviation > 0 ? history.signals[i].Deviation() / deviation : 1);
      direction.push_back(ThousandfoldOf(ratios.back()));
    }
    const bool is_common =
        direction.size() > 1 && direction.front() != 0 &&
        std::all_of(direction.begin(), direction.end(), [&](int d) { return d == direction.front(); });
    // A linear vehicle's channels go with its posts.
    if (is_common && StatedOf(history) != nullptr && !StatedOf(history)->posts.empty()) {
      ReportPosts(history, -direction.front(),
                  "all " + std::to_string(direction.size()) + " channels read about " +
                      (direction.front() > 0 ? "1000 times" : "a thousandth of") + " what the vehicle file gives");
      return;
    }
    for (std::size_t i = 0; i < direction.size(); ++i)
      if (direction[i] != 0) ReportChannel(history, history.signals[i], direction[i], ratios[i]);
  }

 private:
  const StudyHistory* StatedOf(const MeasuredHistory& history) const {
    const auto found = std::find_if(plan_.histories.begin(), plan_.histories.end(),
                                    [&](const StudyHistory& one) { return one.name == history.name; });
    return found == plan_.histories.end() ? nullptr : &*found;
  }

  static std::vector<std::filesystem::path> FilesOf(const StudyHistory& history) {
    std::vector<std::filesystem::path> files = {history.file};
    for (const OtherFile& other : history.preparation.others) files.push_back(other.path);
    return files;
  }

  void Report(const Finding& finding, int line, const std::vector<std::string>& words) {
    if (severity_ == Severity::kError) diagnostics_.Report(finding, {plan_.file, line}, words);
    else diagnostics_.ReportAsWarning(finding, {plan_.file, line}, words);
  }

  void ReportPosts(const MeasuredHistory& history, int direction, const std::string& why) {
    const StudyHistory* const stated = StatedOf(history);
    if (stated == nullptr) return;
    std::string line;
    for (const auto& [post, source] : stated->posts)
      line += (line.empty() ? "posts: {" : ", ") + post + ": " +
              SourceText(WithUnitMeant(source, direction, FilesOf(*stated)));
    Report(kPostsUnitMistaken, stated->posts.empty() ? stated->line : stated->posts.front().second.line,
           {history.name, why, line + "}"});
  }

  void ReportChannel(const MeasuredHistory& history, const MeasuredSignal& signal, int direction, double ratio) {
    const StudyHistory* const stated = StatedOf(history);
    if (stated == nullptr) return;
    Report(kChannelThousandfold, signal.source.line,
           {signal.name, history.name, ShortNumber(ratio, 2),
            signal.name + ": " + SourceText(WithUnitMeant(signal.source, direction, FilesOf(*stated)))});
  }

  const HistoryPlan& plan_;
  Severity severity_;
  Diagnostics& diagnostics_;
};

}  // namespace

void LintUnits(const TimeHistories& histories, const Subject& subject, Severity severity, Diagnostics& diagnostics) {
  UnitLinter linter(histories, severity, diagnostics);
  std::vector<MeasuredHistory> likely;
  for (const MeasuredHistory& history : histories.fitted)
    if (linter.CheckPosts(history)) likely.push_back(history);
  if (likely.empty()) return;
  try {
    HistoryResiduals::Options options = histories.Options(subject);
    options.cost = HistoryCost::kWhitened;
    const HistoryResiduals residuals(subject.Condensed(), likely, options);
    const std::vector<Eigen::MatrixXd> modelled = residuals.Modelled(subject.vehicle().ParameterValues());
    for (std::size_t h = 0; h < likely.size(); ++h) linter.CheckChannels(likely[h], modelled[h]);
  } catch (const std::runtime_error&) {
    // What cannot be simulated at the file's values says so in the fit.
  }
}

}  // namespace fourpost
