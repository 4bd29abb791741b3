#include "identify/experiments/time_history/time_histories.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/text/number.h"
#include "analysis/text/progress_text.h"
#include "analysis/text/text_table.h"
#include "analysis/text/units.h"
#include "identify/experiments/time_history/findings.h"
#include "identify/experiments/time_history/history_block.h"
#include "identify/experiments/time_history/kalman_progress.h"
#include "identify/experiments/time_history/unit_lint.h"
#include "identify/study_file/source_recording.h"

namespace fourpost {
namespace {

HistoryCost ReadCost(const StrictMap& study) {
  const std::optional<std::string> cost = study.Text("cost");
  if (!cost) return HistoryCost::kWhitened;
  const auto* const found = std::find(kHistoryCostNames.begin(), kHistoryCostNames.end(), *cost);
  if (found != kHistoryCostNames.end()) return static_cast<HistoryCost>(found - kHistoryCostNames.begin());
  study.Fault(study.Get("cost"), kHistoryCostUnknown, {*cost, SuggestLegal(*cost, kHistoryCostNames)});
  return HistoryCost::kWhitened;
}

/// Only whitened residuals say what an estimated start is weighed by.
void CheckReleases(const HistoryPlan& plan, Diagnostics& diagnostics) {
  if (plan.cost == HistoryCost::kWhitened) return;
  for (const StudyHistory& history : plan.histories)
    if (history.release && !history.is_validation)
      diagnostics.Report(kReleaseCost, {plan.file, history.line},
                         {history.name, std::string(kHistoryCostNames[static_cast<std::size_t>(plan.cost)])});
}

/// What a Kalman filter cannot serve.
void CheckPrediction(const HistoryPlan& plan, const Vehicle& vehicle, Diagnostics& diagnostics) {
  if (plan.cost != HistoryCost::kPrediction) return;
  for (const StudyHistory& history : plan.histories)
    if (history.filter && !history.is_validation)
      diagnostics.Report(kPredictionFilter, {plan.file, history.line}, {history.name});
  for (const Damper& damper : vehicle.dampers) {
    if (damper.hydraulic) diagnostics.Report(kPredictionHydraulic, {vehicle.file, damper.source_line}, {damper.name});
    if (damper.law.Sticks()) diagnostics.Report(kPredictionFriction, {vehicle.file, damper.source_line}, {damper.name});
  }
}

/// Whitened residuals are over a deviation.
void CheckDeviations(const HistoryPlan& plan, const std::vector<MeasuredHistory>& histories, Diagnostics& diagnostics) {
  if (plan.cost != HistoryCost::kWhitened || plan.model_error.history > 0) return;
  for (const MeasuredHistory& history : histories)
    for (const MeasuredSignal& signal : history.signals) {
      if (signal.noise_sd > 0) continue;
      const auto entry = std::find_if(plan.histories.begin(), plan.histories.end(),
                                      [&](const StudyHistory& other) { return other.name == history.name; });
      diagnostics.Report(kHistoryWithoutWeight, {plan.file, entry->line}, {signal.name, history.name});
    }
}

void Add(Sha256& digest, const Eigen::VectorXd& values) {
  digest.Add(std::vector<double>(values.begin(), values.end()));
}

void Add(Sha256& digest, const MeasuredHistory& history) {
  digest.Add(history.name);
  fourpost::AddTo(digest, history.setting);
  if (history.release) {
    digest.Add("release");
    digest.Add(static_cast<double>(history.release->from));
    for (const Release::Hold& hold : history.release->held) {
      digest.Add(hold.sensor);
      digest.Add(hold.reading_m.value_or(-1e9));
    }
  }
  for (const double number : {history.rate_Hz, history.TimeAt(0), history.filter ? history.filter->cutoff_Hz : 0.0,
                              history.filter ? static_cast<double>(history.filter->order) : 0.0, history.process_sd})
    digest.Add(number);
  std::vector<PostState> posts(history.posts.count);
  for (Eigen::Index k = -history.first; k < history.count; ++k) {
    history.posts.motion(history.TimeAt(k), posts);
    for (const PostState& post : posts) digest.Add(post.height);
  }
  for (const MeasuredSignal& signal : history.signals) {
    digest.Add(static_cast<double>(signal.sensor));
    digest.Add(signal.noise_sd);
    Add(digest, signal.values);
    for (const char is_unknown : signal.is_unknown) digest.Add(static_cast<double>(is_unknown));
  }
  for (const double value : history.correction.reshaped()) digest.Add(value);
}

}  // namespace

std::unique_ptr<Experiment> TimeHistories::Read(const StrictMap& study) {
  if (!study.Has("histories")) return nullptr;
  auto read = std::make_unique<TimeHistories>();
  read->plan = {
      .file = study.file(),
      .histories = ReadHistories(study.Get("histories"), study.Get("channels"), study.file(), study.diagnostics()),
      .cost = ReadCost(study)};
  // Faults of what both share are reported once, by the stepped sines where they are read.
  const bool has_sines = study.Has("recordings") || HistoriesOf(read->plan.histories, false).empty();
  Diagnostics reported_elsewhere;
  read->plan.model_error = ReadModelError(has_sines ? study.ReportingTo(reported_elsewhere) : study);
  return read;
}

std::vector<ExperimentFile> TimeHistories::Files() const {
  std::vector<ExperimentFile> files;
  for (const StudyHistory& history : plan.histories) {
    const auto use = history.is_validation ? ExperimentFile::Use::kValidation : ExperimentFile::Use::kFitted;
    files.push_back({.path = history.file, .line = history.line, .use = use});
    for (const OtherFile& other : history.preparation.others)
      files.push_back({.path = other.path, .line = history.line, .use = use});
  }
  return files;
}

void TimeHistories::LeaveOutValidation() {
  std::erase_if(plan.histories, [](const StudyHistory& history) { return history.is_validation; });
}

std::vector<double> TimeHistories::Settings() const {
  std::vector<double> settings;
  for (const StudyHistory& history : plan.histories)
    if (history.setting && !history.is_validation) settings.push_back(*history.setting);
  return settings;
}

void TimeHistories::Load(const Subject& subject, Diagnostics& diagnostics) {
  const Vehicle& vehicle = subject.vehicle();
  for (StudyHistory& history : plan.histories) MapByName(vehicle, history);
  const std::optional<std::vector<MeasuredHistory>> histories =
      LoadHistories(HistoriesOf(plan.histories, false), plan.file, vehicle, diagnostics, subject.control());
  validation =
      LoadValidation(HistoriesOf(plan.histories, true), plan.file, vehicle, diagnostics, left_out_, subject.control());
  CheckPrediction(plan, vehicle, diagnostics);
  CheckReleases(plan, diagnostics);
  if (!histories) return;
  CheckDeviations(plan, *histories, diagnostics);
  fitted = *histories;
  steps_s.clear();
}

void TimeHistories::AddTo(Sha256& data, Sha256& settings) const {
  if (fitted.empty()) return;
  for (const MeasuredHistory& history : fitted) Add(data, history);
  settings.Add(plan.model_error.history);
  settings.Add(static_cast<double>(plan.cost));
}

HistoryResiduals::Options TimeHistories::Options(const Subject& subject) const {
  return {.cost = plan.cost,
          .model_error = plan.model_error.history,
          .steps_s = steps_s,
          .noise = kalman_noise,
          .noise_search = {.deadline_s = subject.deadline_s()}};
}

std::optional<ResidualBlock> TimeHistories::Residuals(const Subject& subject) const {
  if (fitted.empty()) return std::nullopt;
  return HistoryBlock(subject.Condensed(), fitted, Options(subject), subject.calibrations());
}

std::optional<ResidualBlock> TimeHistories::UnpreparedResiduals(const Subject& subject) const {
  if (fitted.empty()) return std::nullopt;
  HistoryResiduals::Options options = Options(subject);
  options.cost = HistoryCost::kWhitened;
  return HistoryBlock(subject.Condensed(), fitted, options);
}

bool TimeHistories::HasDeviations() const { return fitted.empty() || plan.cost != HistoryCost::kCompromise; }

bool TimeHistories::MeasuresForce() const {
  const auto is_force = [](const MeasuredSignal& signal) { return ParseUnit(signal.unit)->dimension == kForce; };
  // What an actuator does is a force that was measured as well.
  return std::any_of(fitted.begin(), fitted.end(), [&](const MeasuredHistory& history) {
    return std::any_of(history.signals.begin(), history.signals.end(), is_force) || history.HasMovingActuator();
  });
}

void TimeHistories::Prepare(const Subject& subject, const WorkHooks& hooks) {
  FindSteps(subject);
  if (plan.cost != HistoryCost::kPrediction) return;
  kalman_noise.clear();
  try {
    for (const MeasuredHistory& history : fitted)
      kalman_noise.push_back(KalmanPredictor(history).Estimate(
          subject.Condensed()->At(history.setting.At(subject.vehicle().ParameterValues())),
          {.deadline_s = subject.deadline_s(), .progress = KalmanProgress(hooks)}));
  } catch (const TimedOut&) {
    Refuse(kKalmanTooSlow, {plan.file}, {FormatNumber(subject.deadline_s())});
  }
}

/// Once for all that is made of these histories. Where there are none, the residuals will say why; those of a release
/// have its start to find first.
void TimeHistories::FindSteps(const Subject& subject) {
  const auto is_released = [](const MeasuredHistory& history) { return history.release.has_value(); };
  if (!steps_s.empty() || std::any_of(fitted.begin(), fitted.end(), is_released)) return;
  std::vector<double> found;
  try {
    for (const MeasuredHistory& history : fitted)
      found.push_back(HistoryStep(history,
                                  subject.Condensed()->At(history.setting.At(subject.vehicle().ParameterValues())),
                                  RigViewOf(subject.vehicle()), Options(subject).error));
  } catch (const std::runtime_error&) {
    return;
  }
  steps_s = std::move(found);
}

void TimeHistories::Check(const Subject& subject, Severity wrong_posts, Diagnostics& diagnostics) const {
  LintUnits(*this, subject, wrong_posts, diagnostics);
}

Experiment::Geometry TimeHistories::CheckGeometry(const Subject& subject, const std::vector<double>& values,
                                                  const WorkHooks& hooks) {
  const bool is_corrected = plan.cost != HistoryCost::kPrediction;
  std::optional<std::vector<HistoryCheck>> found = CheckHistories(
      subject, fitted, Options(subject).error, is_corrected, values, [&hooks](const std::string& work, double t) {
        hooks.Show("fit: check of linear kinematics, " + work + " at " + Rounded(std::max(0.0, t), 3) + " s");
        return !hooks.IsStopped();
      });
  if (!found) return Geometry::kInterrupted;
  checks = *std::move(found);
  return IsCorrectionDue(checks) ? Geometry::kCorrectionDue : Geometry::kGood;
}

void TimeHistories::Correct() {
  for (std::size_t h = 0; h < checks.size(); ++h) fitted[h].correction = checks[h].correction;
}

void TimeHistories::CorrectAs(const Experiment& other) {
  const auto& like = dynamic_cast<const TimeHistories&>(other);
  const std::vector<MeasuredHistory>& corrected = like.fitted;
  if (fitted.size() == corrected.size()) steps_s = like.steps_s;
  for (std::size_t h = 0; h < std::min(fitted.size(), corrected.size()); ++h)
    if (fitted[h].count == corrected[h].count) fitted[h].correction = corrected[h].correction;
}

bool TimeHistories::Reads(const RecordedTable& table) const {
  std::vector<std::string> times = kTimeColumn.names;
  for (const StudyHistory& history : plan.histories)
    if (history.time) times.push_back(history.time->name);
  return !table.FindColumn("frequency_Hz") && std::any_of(times.begin(), times.end(), [&](const std::string& name) {
    return table.FindColumn(name).has_value();
  });
}

}  // namespace fourpost
