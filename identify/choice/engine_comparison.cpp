#include "identify/choice/engine_comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "identify/choice/choice_words.h"
#include "identify/choice/findings.h"

namespace fourpost {
namespace {

/// Compares the change of the best settings against the present one with slower engines.
class EngineComparison {
 public:
  EngineComparison(const ChoiceRequest& request, const WorkHooks& hooks, Choice& choice, Diagnostics& findings)
      : request_(request), hooks_(hooks), choice_(choice), findings_(findings) {}

  bool Histories(ComparedSettings& compared) {
    std::vector<std::size_t> rows = Shortlist();
    std::erase_if(rows, [&](std::size_t row) { return row == choice_.present || compared.tried.count(row) > 0; });
    compared.tried.insert(rows.begin(), rows.end());
    const std::size_t before = choice_.checks.size();
    if (!rows.empty()) Compare(EngineCheck::Engine::kHistories, request_.histories, rows, compared.present);
    return choice_.checks.size() > before || choice_.is_interrupted;
  }

  void Full() {
    std::optional<SettingScore> present;
    if (request_.full) Compare(EngineCheck::Engine::kFull, request_.full, {*choice_.best}, present);
    Report();
  }

 private:
  /// The best setting, and those that are the best most often besides; not the present one, which all are compared
  /// with.
  std::vector<std::size_t> Shortlist() const {
    std::vector<std::size_t> rows;
    for (std::size_t s = 0; s < choice_.rows.size(); ++s)
      if (choice_.rows[s].is_admitted && s != *choice_.best && s != choice_.present) rows.push_back(s);
    std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
      const RatedSetting& first = choice_.rows[a];
      const RatedSetting& second = choice_.rows[b];
      return std::pair(-first.best_probability, first.change.mean) <
             std::pair(-second.best_probability, second.change.mean);
    });
    rows.insert(rows.begin(), *choice_.best);
    rows.resize(std::min(rows.size(), request_.settings.shortlist));
    return rows;
  }

  /// `present_by_engine`: empty before it was computed.
  void Compare(EngineCheck::Engine engine, const MetricsOf& metrics_of, const std::vector<std::size_t>& rows,
               std::optional<SettingScore>& present_by_engine) {
    // Histories know no modes, and so not all that limits are set on.
    SettingsFile objectives = request_.settings;
    objectives.limits.clear();
    const SettableCar by_spectra{&objectives, request_.spectra};
    const SettableCar by_engine{&objectives, metrics_of};
    const Setting& present = choice_.rows[choice_.present].setting;
    std::vector<Setting> settings = {present};
    for (const std::size_t row : rows)
      if (row != choice_.present) settings.push_back(choice_.rows[row].setting);
    const std::vector<SettingScore> fast = ScoresOf(by_spectra, settings, request_.fitted, request_.threads, {});
    if (present_by_engine) settings.erase(settings.begin());
    std::vector<SettingScore> slow = ScoresOf(by_engine, settings, request_.fitted, request_.threads, hooks_);
    choice_.is_interrupted = slow.size() < settings.size();
    if (choice_.is_interrupted) return;
    if (present_by_engine) slow.insert(slow.begin(), *present_by_engine);
    present_by_engine = slow.front();
    std::size_t next = 1;
    for (const std::size_t row : rows) {
      if (row == choice_.present) continue;
      const std::size_t i = next++;
      if (!slow[0].IsGood() || !slow[i].IsGood() || !fast[i].IsGood()) {
        findings_.Report(kEngineWithoutRide, {request_.settings.file.string()},
                         {EngineWords(engine), slow[0].IsGood() ? slow[i].failure : slow[0].failure});
        continue;
      }
      for (std::size_t o = 0; o < request_.settings.objectives.size(); ++o)
        choice_.checks.push_back({engine, row, o, fast[i].objectives[o] / fast[0].objectives[o] - 1,
                                  slow[i].objectives[o] / slow[0].objectives[o] - 1});
      choice_.checks.push_back({engine, row, std::nullopt,
                                Compromise(request_.settings.objectives, fast[i], fast[0]) - 1,
                                Compromise(request_.settings.objectives, slow[i], slow[0]) - 1});
    }
  }

  static std::string EngineWords(EngineCheck::Engine engine) {
    return engine == EngineCheck::Engine::kHistories ? "time histories of the reduced model" : "the multibody system";
  }

  std::string ObjectiveName(std::size_t objective) const {
    return request_.metrics[request_.settings.objectives[objective].metric].name;
  }

  void Report() {
    const Place file{request_.settings.file.string()};
    for (const auto engine : {EngineCheck::Engine::kHistories, EngineCheck::Engine::kFull})
      for (std::size_t o = 0; o < request_.settings.objectives.size(); ++o) ReportDisagreement(file, engine, o);
    ReportOrder(file);
  }

  /// Of all settings the one that differs most.
  void ReportDisagreement(const Place& file, EngineCheck::Engine engine, std::size_t objective) {
    const EngineCheck* worst = nullptr;
    std::size_t compared = 0;
    std::size_t beyond = 0;
    for (const EngineCheck& check : choice_.checks) {
      if (check.engine != engine || check.objective != objective) continue;
      ++compared;
      beyond += std::abs(check.Difference()) > request_.settings.agreement ? 1 : 0;
      if (worst == nullptr || std::abs(check.Difference()) > std::abs(worst->Difference())) worst = &check;
    }
    if (beyond > 0)
      findings_.Report(kEnginesDisagree, file,
                       {std::to_string(beyond), std::to_string(compared), ObjectiveName(objective), EngineWords(engine),
                        SharePercent(request_.settings.agreement),
                        SettingText(request_.settings.knobs, choice_.rows[worst->row].setting),
                        SharePercent(worst->by_spectra), SharePercent(worst->by_engine)});
  }

  /// Whether a slower engine prefers another setting of the shortlist, or the present one.
  void ReportOrder(const Place& file) {
    for (const auto engine : {EngineCheck::Engine::kHistories, EngineCheck::Engine::kFull}) {
      std::size_t preferred = choice_.present;
      double least = 0;
      bool is_compared = false;
      for (const EngineCheck& check : choice_.checks) {
        if (check.engine != engine || check.objective) continue;
        is_compared = true;
        if (check.by_engine < least) {
          least = check.by_engine;
          preferred = check.row;
        }
      }
      if (is_compared && !choice_.rows[preferred].is_indistinct)
        findings_.Report(kEngineOrder, file,
                         {EngineWords(engine), SettingText(request_.settings.knobs, choice_.rows[preferred].setting),
                          SharePercent(least)});
    }
  }

  const ChoiceRequest& request_;
  const WorkHooks& hooks_;
  Choice& choice_;
  Diagnostics& findings_;
};

}  // namespace

bool CompareHistories(const ChoiceRequest& request, ComparedSettings& compared, const WorkHooks& hooks, Choice& choice,
                      Diagnostics& findings) {
  return request.histories && EngineComparison(request, hooks, choice, findings).Histories(compared);
}

void CompareFull(const ChoiceRequest& request, const WorkHooks& hooks, Choice& choice) {
  EngineComparison(request, hooks, choice, choice.findings).Full();
}

}  // namespace fourpost
