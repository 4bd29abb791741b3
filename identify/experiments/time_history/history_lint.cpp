#include "identify/experiments/time_history/history_lint.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/text/short_number.h"
#include "identify/experiments/time_history/findings.h"
#include "identify/experiments/time_history/history_misfits.h"
#include "identify/experiments/time_history/history_remark.h"
#include "identify/experiments/time_history/point_delay.h"

namespace fourpost {
namespace {

using Cause = HistoryRemark::Cause;

bool Has(const std::vector<HistoryRemark>& remarks, Cause cause) {
  return std::any_of(remarks.begin(), remarks.end(), [&](const HistoryRemark& other) { return other.cause == cause; });
}

/// Of two that are not synchronised with each other it is the one that is farther from all others against the model.
HistoryRemark PointRemark(const PointDelay& point, MisfitsOfOne fitted) {
  const HistoryMisfit& z = fitted[point.displacement];
  const HistoryMisfit& a = fitted[point.acceleration];
  const double common_s = CommonDelay(fitted).value_or(0);
  const bool is_displacement = std::abs(z.delay_s.value_or(0) - common_s) >= std::abs(a.delay_s.value_or(0) - common_s);
  const HistoryMisfit& late = is_displacement ? z : a;
  const HistoryMisfit& other = is_displacement ? a : z;
  const double delay_s = is_displacement ? point.delay_s : -point.delay_s;
  return {Cause::kDelay,
          late.recording,
          late.name,
          {&kChannelLateOfPoint,
           {late.name, late.recording, Lateness(delay_s), other.name, z.name,
            late.name + ": " + DelayRemedy(late, delay_s)}}};
}

/// Of one recording.
class HistoryLinter {
 public:
  HistoryLinter(MisfitsOfOne fitted, const RemediedErrors& fitted_errors, MisfitsOfOne start,
                const RemediedErrors& start_errors, double sample_s, std::vector<std::string> driving)
      : driving_(std::move(driving)),
        fitted_(fitted),
        start_(start),
        start_errors_(start_errors),
        sample_s_(sample_s),
        remarks_(RemarksOn({fitted.begin(), fitted.end()}, sample_s, fitted_errors)) {}

  std::vector<HistoryRemark> Remarks(const std::vector<PointDelay>& points) {
    if (!driving_.empty() && IsMirrored()) return {MirroredActuator()};
    AddSwapsAtStart();
    // Delays against a model that does not fit are not reported.
    if (remarks_.empty() || Has(remarks_, Cause::kDelay)) ChooseDelays(points);
    return std::move(remarks_);
  }

 private:
  /// The other sign of all channels explains most of each, at the values of the file: a fit goes astray.
  bool IsMirrored() const {
    constexpr double kMost_percent = 50;
    // One channel has the wrong sign as well as the force.
    return start_.size() > 1 && std::all_of(start_.begin(), start_.end(), [&](const HistoryMisfit& misfit) {
             return start_errors_.Percent(misfit.recording, misfit.name, -1, 0) < kMost_percent;
           });
  }

  HistoryRemark MirroredActuator() const {
    std::string names;
    for (const std::string& actuator : driving_) names += (names.empty() ? "actuator '" : " and '") + actuator + "'";
    const std::string& recording = start_.front().recording;
    return {Cause::kSign, recording, driving_.front(), {&kActuatorInverted, {recording, names}}};
  }

  /// A fit may hide a swap: what the vehicle file's own values show of one, and the fitted ones do not.
  void AddSwapsAtStart() {
    for (std::size_t i = 0; i < start_.size(); ++i)
      if (start_[i].swapped_with && !fitted_[i].swapped_with)
        remarks_.push_back(
            {Cause::kSwapped,
             start_[i].recording,
             start_[i].name,
             {&kHistoryChannelsSwappedAtStart, {start_[i].name, start_[i].recording, *start_[i].swapped_with}}});
  }

  /// Pairs of one point know nothing of the model; the file's parameters have not been adapted to a delay, which the
  /// fitted ones meet half-way.
  void ChooseDelays(const std::vector<PointDelay>& points) {
    std::vector<HistoryRemark> surer;
    for (const PointDelay& point : points) surer.push_back(PointRemark(point, fitted_));
    if (surer.empty())
      if (std::optional<HistoryRemark> posts = PostDelay(start_, sample_s_); posts && DoesFitShareDelay())
        surer.push_back(*std::move(posts));
    if (surer.empty()) surer = AtStart();
    if (!surer.empty()) remarks_ = std::move(surer);
  }

  /// A fit meets a delay of the posts about half-way; values of a file that is far off have delays of their own, of
  /// which the fitted ones keep nothing.
  bool DoesFitShareDelay() const {
    constexpr double kLeastShare = 0.2;
    return CommonDelay(fitted_).value_or(0) / CommonDelay(start_).value_or(1) > kLeastShare;
  }

  /// Of the channel that is the odd one out for the fitted values too, where that explains more.
  std::vector<HistoryRemark> AtStart() const {
    const auto named = [](MisfitsOfOne recording, const std::string& name) {
      return *std::find_if(recording.begin(), recording.end(), [&](const auto& other) { return other.name == name; });
    };
    std::vector<HistoryRemark> start = RemarksOn({start_.begin(), start_.end()}, sample_s_, start_errors_);
    const bool is_same = start.size() == 1 && remarks_.size() == 1 && start[0].cause == Cause::kDelay &&
                         start[0].channel == remarks_[0].channel && !start[0].channel.empty();
    if (!is_same) return {};
    const std::string& channel = start[0].channel;
    return *named(start_, channel).timed_nmse_percent < *named(fitted_, channel).timed_nmse_percent
               ? start
               : std::vector<HistoryRemark>();
  }

  /// Actuators that alone move the vehicle; empty where posts move it too.
  std::vector<std::string> driving_;
  MisfitsOfOne fitted_;
  MisfitsOfOne start_;
  const RemediedErrors& start_errors_;
  double sample_s_;
  std::vector<HistoryRemark> remarks_;
};

/// Actuators that alone move the vehicle.
std::vector<std::string> DrivingActuators(const Vehicle& vehicle, const MeasuredHistory& history) {
  std::vector<std::string> driving;
  if (history.release || history.HasMovingPost()) return driving;
  for (std::size_t i = 0; i < history.tensions.size(); ++i) {
    const auto [least, most] = std::minmax_element(history.tensions[i].begin(), history.tensions[i].end());
    if (least != most && *least < *most) driving.push_back(vehicle.actuators[i].name);
  }
  return driving;
}

int LineOfChannel(const StudyHistory& history, const std::string& channel) {
  for (const auto* const sources : {&history.channels, &history.actuators})
    for (const auto& [name, source] : *sources)
      if (name == channel) return source.line;
  return history.posts.empty() ? history.line : history.posts.front().second.line;
}

/// Where the steps that the file's values need are too long for the fitted ones.
void LintSteps(const std::vector<double>& values, const HistoryResiduals& residuals, const std::string& file,
               Diagnostics& diagnostics) {
  const std::vector<double> changes = residuals.ChangesByHalfStep(values);
  for (std::size_t h = 0; h < changes.size(); ++h)
    if (changes[h] > residuals.options().error)
      diagnostics.Report(
          kStepTooLong, {file},
          {ShortNumber(1e3 * residuals.Steps()[h]), residuals.histories()[h].name, ShortNumber(100 * changes[h], 2)});
}

/// By the vehicle file's values; what the fitted ones give where those cannot go through the recordings.
std::vector<Eigen::MatrixXd> AtStart(const Vehicle& vehicle, const HistoryResiduals& residuals,
                                     const std::vector<Eigen::MatrixXd>& fitted) {
  try {
    return residuals.Modelled(vehicle.ParameterValues());
  } catch (const std::runtime_error&) {
    return fitted;
  }
}

}  // namespace

void LintHistories(const std::string& study_file, const std::vector<StudyHistory>& stated, const Vehicle& vehicle,
                   const std::vector<double>& values, const HistoryResiduals& residuals,
                   const std::vector<Eigen::MatrixXd>& modelled, const std::vector<HistoryMisfit>& misfits,
                   Diagnostics& diagnostics) {
  const std::vector<MeasuredHistory>& histories = residuals.histories();
  const std::vector<Eigen::MatrixXd> at_start = AtStart(vehicle, residuals, modelled);
  const std::vector<HistoryMisfit> start = HistoryMisfits(histories, at_start);
  const RemediedErrors fitted_errors(histories, modelled);
  const RemediedErrors start_errors(histories, at_start);
  std::size_t first = 0;
  for (const MeasuredHistory& history : histories) {
    const std::size_t count = history.signals.size();
    HistoryLinter linter(MisfitsOfOne(misfits).subspan(first, count), fitted_errors,
                         MisfitsOfOne(start).subspan(first, count), start_errors, 1 / history.rate_Hz,
                         DrivingActuators(vehicle, history));
    const auto entry = std::find_if(stated.begin(), stated.end(),
                                    [&](const StudyHistory& other) { return other.name == history.name; });
    for (const HistoryRemark& remark : linter.Remarks(PointDelays(vehicle, history)))
      diagnostics.Report(*remark.found.kind,
                         {study_file, entry == stated.end() ? 0 : LineOfChannel(*entry, remark.channel)},
                         remark.found.words);
    first += count;
  }
  LintSteps(values, residuals, study_file, diagnostics);
}

}  // namespace fourpost
