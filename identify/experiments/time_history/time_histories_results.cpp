// What a fit by time histories leaves: tables, files and keys of result.json.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/text/text_table.h"
#include "analysis/text/units.h"
#include "identify/experiments/time_history/covered_histories.h"
#include "identify/experiments/time_history/findings.h"
#include "identify/experiments/time_history/history_bands.h"
#include "identify/experiments/time_history/history_fit_files.h"
#include "identify/experiments/time_history/history_lint.h"
#include "identify/experiments/time_history/history_misfits.h"
#include "identify/experiments/time_history/history_tyre_pull_lint.h"
#include "identify/experiments/time_history/kalman_noise_json.h"
#include "identify/experiments/time_history/motion_file.h"
#include "identify/experiments/time_history/time_histories.h"
#include "identify/fit/fit.h"
#include "identify/residuals/history_misfit_json.h"
#include "identify/residuals/history_table.h"
#include "vehicles/requests/engine_text.h"
#include "vehicles/requests/history_files.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

/// HistoryMisfit::misfit, where the cost has one. Noise of posts is allowed for as in FitResult::Misfit().
void AddDeviations(const HistoryResiduals& residuals, const FitResult& fit,
                   const std::vector<Eigen::MatrixXd>& modelled, std::vector<HistoryMisfit>& misfits) {
  std::vector<Eigen::VectorXd> by_posts;
  try {
    if (fit.input_noise_squares > 0) by_posts = residuals.ByPostNoise(fit.values);
  } catch (const std::runtime_error&) {
    // Noise with which the motion cannot be computed.
  }
  auto misfit = misfits.begin();
  for (std::size_t h = 0; h < modelled.size(); ++h)
    for (std::size_t s = 0; s < residuals.histories()[h].signals.size(); ++s, ++misfit) {
      const MeasuredSignal& signal = residuals.histories()[h].signals[s];
      const auto column = static_cast<Eigen::Index>(s);
      const auto model = modelled[h].col(column);
      const Eigen::VectorXd error = model - signal.MeasuredOr(model);
      const auto measured = static_cast<double>(error.size() - signal.UnknownCount(1));
      const double by_post = by_posts.empty() ? 0 : by_posts[h][column];
      const double off =
          std::sqrt(error.squaredNorm() / measured) / residuals.DeviationOf(signal) / std::hypot(1, by_post);
      if (std::isfinite(off)) misfit->misfit = off;
    }
}

/// Table and files; `name` of the files. `reduced`: by the residuals, whatever engine has modelled them.
std::vector<HistoryMisfit> Show(const TimeHistories& experiment, const Vehicle& vehicle,
                                const HistoryResiduals& residuals, const FitResult& fit,
                                const std::vector<Eigen::MatrixXd>& modelled,
                                const std::vector<Eigen::MatrixXd>& reduced, bool has_one_step, const std::string& name,
                                std::string& text, ExperimentResults& results) {
  const HistoryPlan& plan = experiment.plan;
  const std::vector<MeasuredHistory>& histories = residuals.histories();
  const std::vector<double>& values = fit.values;
  std::vector<HistoryMisfit> misfits = HistoryMisfits(histories, modelled);
  if (plan.cost == HistoryCost::kWhitened) AddDeviations(residuals, fit, modelled, misfits);
  if (has_one_step) AddOneStepErrors(histories, residuals.Predicted(values), misfits);
  LintHistories(plan.file, plan.histories, vehicle, values, residuals, reduced, misfits, results.findings);
  LintTyrePulls(vehicle, values, histories, residuals.Steps(), results.findings);
  AddYardsticks(YardstickRecords(experiment.fitted), YardstickRecords(histories), misfits);
  text += HistoryTable(misfits) + '\n';
  const std::string yardsticks = YardstickTable(misfits, results.text);
  if (!yardsticks.empty()) text += yardsticks + '\n';
  results.files.emplace_back(name + ".csv", HistoryFitCsv(histories, modelled));
  auto misfit = misfits.begin();
  for (std::size_t h = 0; h < histories.size(); ++h) {
    const auto next = misfit + static_cast<std::ptrdiff_t>(histories[h].signals.size());
    const std::string number = histories.size() == 1 ? "" : "_" + std::to_string(h + 1);
    results.files.emplace_back(name + number + ".svg", HistoryFitSvg(histories[h], modelled[h], {misfit, next}));
    misfit = next;
  }
  return misfits;
}

/// How the fitted vehicle moved in each.
void AddMotions(const std::vector<double>& values, const HistoryResiduals& residuals,
                std::vector<RecordedHistory>& motions) {
  const std::vector<double> steps = residuals.Steps();
  for (std::size_t h = 0; h < steps.size(); ++h) {
    const MeasuredHistory& history = residuals.histories()[h];
    const CondensedModel model = residuals.ModelOf(history, values);
    const Eigen::Index columns = static_cast<Eigen::Index>(history.posts.count) + model.mass.rows();
    motions.push_back(
        {history.name, HistorySimulation(history, steps[h]).Motion(model, FrameStride(history, columns))});
  }
}

/// How a state changes with its unknowns.
Eigen::MatrixXd StatesByUnknowns(const Release& release, const CondensedModel& model,
                                 const HistorySimulation::Start& start) {
  constexpr double kApart = 1e-6;
  Eigen::MatrixXd by(start.state.size(), start.estimate.unknowns.size());
  for (Eigen::Index j = 0; j < by.cols(); ++j) {
    Eigen::VectorXd moved = start.estimate.unknowns;
    moved[j] += kApart;
    by.col(j) = (ReleasedState(release, model, moved) - start.state) / kApart;
  }
  return by;
}

/// From where the fitted vehicle is let go: readings of all displacement sensors above rest, and their rates, with
/// standard deviations of the estimate, given the fitted parameters.
void AddReleases(const Vehicle& vehicle, const std::vector<double>& values, const HistoryResiduals& residuals,
                 std::string& text, ExperimentResults& results) {
  for (std::size_t h = 0; h < residuals.histories().size(); ++h) {
    const MeasuredHistory& history = residuals.histories()[h];
    if (!history.release) continue;
    const CondensedModel model = residuals.ModelOf(history, values);
    const Eigen::Index n = model.mass.rows();
    const HistorySimulation::Start start = HistorySimulation(history, residuals.Steps()[h]).StartOf(model);
    const Eigen::MatrixXd by = StatesByUnknowns(*history.release, model, start);
    Json sensors = Json::array();
    TextTable table({"released from", "mm above rest", "sd", "mm/s", "sd"});
    for (std::size_t s = 0; s < vehicle.sensors.size(); ++s) {
      if (ParseUnit(UnitOf(vehicle.sensors[s].type))->dimension != kLength) continue;
      const Eigen::RowVectorXd row = model.on_position.row(static_cast<Eigen::Index>(s));
      const auto reading = [&](Eigen::Index first) { return (row * start.state.segment(first, n))(0); };
      const auto sd = [&](Eigen::Index first) {
        if (by.cols() == 0) return 0.0;
        const Eigen::RowVectorXd along = row * by.middleRows(first, n);
        return std::sqrt(std::max(0.0, (along * start.estimate.covariance * along.transpose())(0)));
      };
      sensors.push_back({{"name", vehicle.sensors[s].name},
                         {"position_m", reading(0)},
                         {"position_sd_m", sd(0)},
                         {"velocity_mps", reading(n)},
                         {"velocity_sd_mps", sd(n)}});
      table.Add({vehicle.sensors[s].name, Rounded(1e3 * reading(0), 4), Rounded(1e3 * sd(0), 2),
                 Rounded(1e3 * reading(n), 4), Rounded(1e3 * sd(n), 2)});
    }
    results.json["releases"].push_back(
        {{"recording", history.name}, {"start_s", history.TimeAt(0)}, {"sensors", std::move(sensors)}});
    text += history.name + ", let go at " + Rounded(history.TimeAt(0), 4) + " s\n" + table.Format() + '\n';
  }
}

void AddEngine(const MeasuredHistory& history, bool is_fitted, const HistoryEngine& by, double error,
               ExperimentResults& results) {
  Json entry = {{"recording", history.name}, {"fitted", is_fitted}};
  entry.update(EngineJson(by, error));
  if (!history.preparations.empty()) entry["preparation"] = history.preparations;
  results.json["histories"].push_back(entry);
  (is_fitted ? results.text : results.unseen_text) += FitEngineText(history.name, by);
}

void AddEngines(const TimeHistories& experiment, double error, ExperimentResults& results) {
  for (std::size_t h = 0; h < experiment.checks.size(); ++h) {
    const std::string& name = experiment.fitted[h].name;
    const HistoryEngine& by = experiment.checks[h].by;
    AddEngine(experiment.fitted[h], true, by, error, results);
    if (by.engine == Engine::kReduced && by.kinematics_error && by.kinematics_error->IsVisible())
      results.findings.Report(kHistoryKinematicsVisible, {experiment.plan.file},
                              {name, KinematicsText(*by.kinematics_error)});
  }
  if (!experiment.checks.empty()) results.text += '\n';
}

/// Histories kept for validation and what the fitted vehicle makes of each, by the engine that it needs.
struct Predictions {
  std::vector<MeasuredHistory> histories;
  std::vector<Eigen::MatrixXd> modelled;
  std::vector<HistoryEngine> by;
  /// By the reduced model, which remarks and the motion shown are of, and its steps.
  std::vector<Eigen::MatrixXd> reduced;
  std::vector<double> steps_s;
};

/// Of those that the fitted vehicle can go through; a fit stands without the others.
Predictions PredictAll(const TimeHistories& experiment, const Subject& subject, const FitResult& fit, double error,
                       ExperimentResults& results) {
  Predictions out;
  for (const MeasuredHistory& history : experiment.validation) {
    Diagnostics found;
    try {
      const HistoryResiduals residuals(subject.Condensed(), {history}, {});
      Eigen::MatrixXd reduced = residuals.Modelled(fit.values).front();
      EngineHistory answer = SimulateBy({.error = error}, history, subject.vehicle(), fit.values).value();
      out.histories.push_back(history);
      out.modelled.push_back(residuals.WithStart(0, fit.values, answer.modelled));
      out.by.push_back(std::move(answer.by));
      out.reduced.push_back(std::move(reduced));
      out.steps_s.push_back(residuals.Steps().front());
    } catch (const std::runtime_error& failure) {
      found.Report(kHistoryNotPredicted, {experiment.plan.file}, {history.name, failure.what()});
    }
    if (std::optional<LeftOutRecording> left_out = LeftOutFor(found, history.name, {}, results.findings))
      results.json["validation_left_out"].push_back(LeftOutJson(*left_out));
  }
  return out;
}

void AddValidation(const TimeHistories& experiment, const Subject& subject, const FitResult& fit, double error,
                   ExperimentResults& results, std::vector<RecordedHistory>& motions) {
  const Predictions predictions = PredictAll(experiment, subject, fit, error, results);
  if (predictions.histories.empty()) return;
  const HistoryResiduals residuals(
      subject.Condensed(), predictions.histories,
      {.model_error = experiment.Options(subject).model_error, .steps_s = predictions.steps_s});
  results.json["validation"] =
      HistoryMisfitsJson(Show(experiment, subject.vehicle(), residuals, fit, predictions.modelled, predictions.reduced,
                              false, "validation", results.unseen_text, results));
  for (std::size_t h = 0; h < predictions.by.size(); ++h)
    AddEngine(predictions.histories[h], false, predictions.by[h], error, results);
  AddReleases(subject.vehicle(), fit.values, residuals, results.unseen_text, results);
  AddMotions(fit.values, residuals, motions);
}

}  // namespace

ExperimentResults TimeHistories::Results(const Subject& subject, const FitResult& fit) const {
  ExperimentResults results;
  for (const LeftOutRecording& recording : left_out_)
    results.json["validation_left_out"].push_back(LeftOutJson(recording));
  if (fitted.empty() && validation.empty()) return results;
  const double error = Options(subject).error;
  std::vector<RecordedHistory> motions;
  if (!fitted.empty()) {
    const HistoryResiduals residuals(subject.Condensed(), fitted, Options(subject));
    const std::vector<Eigen::MatrixXd> modelled = residuals.Modelled(fit.values);
    const std::vector<HistoryMisfit> misfits =
        Show(*this, subject.vehicle(), residuals, fit, modelled, modelled, plan.cost == HistoryCost::kPrediction,
             "history", results.text, results);
    results.json["channels"] = HistoryMisfitsJson(misfits);
    results.json["history_cost"] = kHistoryCostNames[static_cast<std::size_t>(plan.cost)];
    results.json["history_discrepancy"] = DiscrepancyJson(HistoryDiscrepancies(fitted, modelled));
    results.json["covered"] = CoveredJson(CoveredByHistories(subject.vehicle(), fit.values, fitted, residuals.Steps()));
    results.shares = ErrorShares(misfits);
    AddReleases(subject.vehicle(), fit.values, residuals, results.text, results);
    AddMotions(fit.values, residuals, motions);
    // A fit that was cut short says nothing of its kinematics.
    if (fit.end != FitEnd::kInterrupted) AddEngines(*this, error, results);
  }
  for (std::size_t h = 0; h < kalman_noise.size(); ++h)
    results.json["kalman_noise"].push_back(KalmanNoiseJson(fitted[h], kalman_noise[h]));
  if (!validation.empty()) AddValidation(*this, subject, fit, error, results, motions);
  // A report cannot compute it anew: the folder of a run has no recordings.
  results.files.emplace_back("motion.csv", MotionCsv(subject.vehicle(), motions));
  return results;
}

}  // namespace fourpost
