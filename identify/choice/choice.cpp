#include "identify/choice/choice.h"

#include <algorithm>
#include <cmath>

#include "identify/choice/engine_comparison.h"
#include "identify/choice/engine_error.h"
#include "identify/choice/findings.h"
#include "identify/choice/setting_rating.h"
#include "identify/choice/setting_search.h"

namespace fourpost {
namespace {

/// Knobs whose positions change no metric that counts.
void FindIdleKnobs(const SettableCar& car, const ChoiceRequest& request, Choice& choice) {
  constexpr double kVisible = 1e-9;
  const std::vector<Knob>& knobs = request.settings.knobs;
  const Setting present = PresentSetting(knobs);
  const SettingScore reference = ScoreOf(car, present, request.fitted);
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    bool has_effect = false;
    const auto last = static_cast<int>(knobs[k].positions.size()) - 1;
    for (const int position : {0, last / 2, last}) {
      Setting setting = present;
      setting[k] = position;
      const SettingScore score = ScoreOf(car, setting, request.fitted);
      has_effect = has_effect || !score.IsGood() ||
                   std::abs(Compromise(request.settings.objectives, score, reference) - 1) > kVisible;
      for (std::size_t l = 0; score.IsGood() && l < score.margins.size(); ++l)
        has_effect =
            has_effect || std::abs(score.margins[l] - reference.margins[l]) > kVisible * std::abs(reference.margins[l]);
    }
    if (!has_effect)
      choice.findings.Report(kKnobIdle, {request.settings.file.string(), knobs[k].line}, {knobs[k].name});
  }
}

/// A best setting at the end of a knob's positions asks for more of them.
void FindEnds(const ChoiceRequest& request, Choice& choice) {
  const std::vector<Knob>& knobs = request.settings.knobs;
  const Setting& best = choice.rows[*choice.best].setting;
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    const auto last = static_cast<int>(knobs[k].positions.size()) - 1;
    if (last >= 2 && (best[k] == 0 || best[k] == last))
      choice.findings.Report(kBestAtEnd, {request.settings.file.string(), knobs[k].line},
                             {knobs[k].name, PositionText(knobs[k], best[k])});
  }
}

/// Rated by spectra, and again with what time histories say of the best ones until these are compared.
Choice RateByEngines(const ChoiceRequest& request, const SettingTable& table, const Choice& unrated,
                     const WorkHooks& hooks) {
  constexpr int kMostRounds = 4;
  Choice rated = unrated;
  RateSettings(request, table, {}, rated);
  Diagnostics compared;
  ComparedSettings settings;
  for (int round = 0; round < kMostRounds && rated.best; ++round) {
    const bool is_new = CompareHistories(request, settings, hooks, rated, compared);
    if (!is_new) break;
    Choice again = unrated;
    again.checks = std::move(rated.checks);
    again.is_interrupted = rated.is_interrupted;
    RateSettings(request, table,
                 EngineErrors(request.settings, table.settings, rated.present, again.checks, request.draws.rows()),
                 again);
    rated = std::move(again);
    if (rated.is_interrupted) break;
  }
  if (rated.best && request.histories && !rated.is_interrupted && rated.best != rated.present &&
      settings.tried.count(*rated.best) == 0)
    compared.Report(kBestNotCompared, {request.settings.file.string()},
                    {SettingText(request.settings.knobs, rated.rows[*rated.best].setting)});
  rated.findings.Add(compared);
  return rated;
}

}  // namespace

std::size_t Choice::IndistinctCount() const {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const RatedSetting& row) { return row.is_indistinct; }));
}

std::size_t Choice::ComparedCount() const {
  return static_cast<std::size_t>(std::count_if(checks.begin(), checks.end(), [](const EngineCheck& check) {
    return check.engine == EngineCheck::Engine::kHistories && !check.objective;
  }));
}

Choice Choose(const ChoiceRequest& request, const WorkHooks& hooks) {
  Choice choice;
  const SettableCar car{&request.settings, request.spectra};
  const PromisingSettings promising = FindPromising(car, request.fitted, request.threads, hooks);
  choice.lattice = SettingCount(request.settings.knobs);
  choice.evaluated = promising.evaluated;
  choice.was_searched = promising.was_searched;
  choice.is_interrupted = promising.is_interrupted;
  if (choice.is_interrupted) return choice;
  FindIdleKnobs(car, request, choice);
  Eigen::MatrixXd draws = request.draws;
  if (draws.rows() == 0)
    draws =
        Eigen::Map<const Eigen::RowVectorXd>(request.fitted.data(), static_cast<Eigen::Index>(request.fitted.size()));
  const SettingTable table = TableOf(car, promising.settings, draws, request.threads, hooks);
  choice.is_interrupted = table.is_interrupted;
  if (choice.is_interrupted) return choice;
  ChoiceRequest with_draws = request;
  with_draws.draws = draws;
  choice = RateByEngines(with_draws, table, choice, hooks);
  if (!choice.best) return choice;
  FindEnds(request, choice);
  if (!choice.is_interrupted) CompareFull(request, hooks, choice);
  return choice;
}

}  // namespace fourpost
