#include "identify/choice/choice.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "analysis/text/text_table.h"
#include "identify/choice/findings.h"
#include "identify/choice/setting_search.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr std::size_t kMostRuns = 5;
/// Settings whose beliefs a run is planned on, and how likely one must be the best to be among them.
constexpr std::size_t kMostRivals = 200;

std::string Percent(double share, int digits = 3) { return Rounded(100 * share, digits) + " %"; }

/// Rates settings by a table of them.
class Rating {
 public:
  Rating(const ChoiceRequest& request, const SettingTable& table, Choice& choice)
      : request_(request), settings_(request.settings), table_(table), choice_(choice) {}

  void Run() {
    FindPresent();
    KeepDraws();
    SetCost();
    for (std::size_t s = 0; s < table_.settings.size(); ++s) choice_.rows.push_back(Rate(s));
    Admit();
    if (!choice_.best) return;
    RateAdmitted();
    FindFront();
    FindClicks();
    FindDeciding();
  }

  /// Rows x draws: 1 for the present setting.
  const Eigen::MatrixXd& cost() const { return cost_; }

 private:
  Place File() const { return {settings_.file.string()}; }

  void FindPresent() {
    const Setting present = PresentSetting(settings_.knobs);
    choice_.present = static_cast<std::size_t>(std::find(table_.settings.begin(), table_.settings.end(), present) -
                                               table_.settings.begin());
  }

  /// A car that cannot stand as it is, is none that was measured.
  void KeepDraws() {
    const auto present = static_cast<Index>(choice_.present);
    for (Index d = 0; d < Draws(); ++d)
      if (std::isfinite(table_.objectives.front()(present, d))) kept_.push_back(d);
    if (kept_.empty()) Refuse(kPresentWithoutRide, File(), {table_.failures[choice_.present]});
    if (static_cast<Index>(kept_.size()) < Draws())
      choice_.findings.Report(kDrawsLeftOut, File(),
                              {std::to_string(Draws() - static_cast<Index>(kept_.size())), std::to_string(Draws()),
                               table_.failures[choice_.present]});
    for (const Eigen::MatrixXd& of : table_.objectives) objectives_.push_back(of(Eigen::all, kept_));
    for (const Eigen::MatrixXd& of : table_.margins) margins_.push_back(of(Eigen::all, kept_));
    // A setting has an answer where every car that is left has one.
    for (std::size_t s = 0; s < table_.settings.size(); ++s)
      has_answer_.push_back(objectives_.front().row(static_cast<Index>(s)).allFinite());
  }

  Index Draws() const { return table_.objectives.front().cols(); }

  void SetCost() {
    for (std::size_t o = 0; o < objectives_.size(); ++o)
      if (!(objectives_[o].row(static_cast<Index>(choice_.present)).minCoeff() > 0))
        Refuse(kObjectiveZero, File(), {request_.metrics[settings_.objectives[o].metric].name});
    const Index count = objectives_.front().rows();
    cost_ = Eigen::MatrixXd::Zero(count, objectives_.front().cols());
    for (std::size_t o = 0; o < objectives_.size(); ++o) {
      relative_.push_back(objectives_[o].array().rowwise() /
                          objectives_[o].row(static_cast<Index>(choice_.present)).array());
      cost_ += settings_.objectives[o].weight * relative_[o];
    }
  }

  RatedSetting Rate(std::size_t s) const {
    RatedSetting row{.setting = table_.settings[s]};
    if (!has_answer_[s]) {
      row.failure = table_.failures[s];
      return row;
    }
    const auto i = static_cast<Index>(s);
    for (std::size_t o = 0; o < objectives_.size(); ++o) {
      row.objectives.push_back(objectives_[o].row(i).mean());
      row.changes.push_back(Summarise((relative_[o].row(i).array() - 1).matrix().transpose()));
    }
    row.change = Summarise((cost_.row(i).array() - 1).matrix().transpose());
    Eigen::ArrayXd all = Eigen::ArrayXd::Ones(cost_.cols());
    for (const Eigen::MatrixXd& margin : margins_) {
      const Eigen::ArrayXd met = (margin.row(i).transpose().array() >= 0).cast<double>();
      row.limits_met.push_back(met.mean());
      all *= met;
    }
    row.all_met = all.mean();
    row.is_admitted = row.all_met >= settings_.certainty;
    return row;
  }

  std::vector<bool> Admitted() const {
    std::vector<bool> admitted;
    for (const RatedSetting& row : choice_.rows) admitted.push_back(row.is_admitted);
    return admitted;
  }

  void Admit() {
    const auto failed = static_cast<std::size_t>(std::count(has_answer_.begin(), has_answer_.end(), false));
    if (failed > 0) {
      const auto first = std::find(has_answer_.begin(), has_answer_.end(), false) - has_answer_.begin();
      const RatedSetting& row = choice_.rows[static_cast<std::size_t>(first)];
      choice_.findings.Report(kSettingsWithoutRide, File(),
                              {std::to_string(failed), std::to_string(choice_.rows.size()),
                               SettingText(settings_.knobs, row.setting), row.failure});
    }
    const std::vector<bool> admitted = Admitted();
    if (std::none_of(admitted.begin(), admitted.end(), [](bool is) { return is; })) return ReportLimits();
    decision_ = Decide(cost_, admitted);
    choice_.best = decision_.best;
    choice_.rival = decision_.Rival();
  }

  /// The quantile of a margin that must not be negative.
  double CertainMargin(std::size_t limit, std::size_t s) const {
    std::vector<double> sorted;
    for (const double margin : margins_[limit].row(static_cast<Index>(s))) sorted.push_back(margin);
    std::sort(sorted.begin(), sorted.end());
    const double at = (1 - settings_.certainty) * static_cast<double>(sorted.size());
    return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(at + 1e-9))];
  }

  /// What a metric reaches where it is nearest to its limit.
  std::string NearestText(std::size_t limit, std::size_t s, double margin) const {
    const MetricLimit& of = settings_.limits[limit];
    const Metric& metric = request_.metrics[of.metric];
    const double reached =
        of.most && (!of.least || margin == CertainMargin(limit, s)) ? *of.most - margin : *of.least + margin;
    return "'" + metric.name + "' of " +
           (of.most ? "at most " + FormatRounded(*of.most, metric) : "at least " + FormatRounded(*of.least, metric)) +
           ": the nearest, " + SettingText(settings_.knobs, choice_.rows[s].setting) + ", has " +
           FormatRounded(reached, metric);
  }

  static std::string FormatRounded(double si, const Metric& metric) {
    return InUnit(si, metric.unit, 3) + (metric.unit.empty() ? "" : ' ' + metric.unit);
  }

  /// No setting is admitted: by which limits, and by how much.
  void ReportLimits() {
    bool is_one_unattainable = false;
    for (std::size_t l = 0; l < margins_.size(); ++l) {
      std::size_t nearest = 0;
      double most = -HUGE_VAL;
      for (std::size_t s = 0; s < choice_.rows.size(); ++s)
        if (has_answer_[s] && CertainMargin(l, s) > most) {
          most = CertainMargin(l, s);
          nearest = s;
        }
      if (most >= 0) continue;
      is_one_unattainable = true;
      choice_.findings.Report(kLimitUnattainable, {settings_.file.string(), settings_.limits[l].line},
                              {NearestText(l, nearest, most), Percent(settings_.certainty)});
    }
    if (is_one_unattainable || margins_.empty()) return;
    std::size_t nearest = 0;
    for (std::size_t s = 0; s < choice_.rows.size(); ++s)
      if (has_answer_[s] && choice_.rows[s].all_met > choice_.rows[nearest].all_met) nearest = s;
    const std::vector<double>& met = choice_.rows[nearest].limits_met;
    const auto binding = static_cast<std::size_t>(std::min_element(met.begin(), met.end()) - met.begin());
    choice_.findings.Report(
        kLimitsContradict, File(),
        {Percent(settings_.certainty), SettingText(settings_.knobs, choice_.rows[nearest].setting),
         Percent(choice_.rows[nearest].all_met), request_.metrics[settings_.limits[binding].metric].name});
  }

  void RateAdmitted() {
    for (std::size_t s = 0; s < choice_.rows.size(); ++s) {
      const auto i = static_cast<Index>(s);
      RatedSetting& row = choice_.rows[s];
      row.best_probability = decision_.best_probability[i];
      row.regret = decision_.regret[i];
      row.beside_best = {decision_.difference[i], decision_.difference_sd[i], decision_.lower[i], decision_.upper[i]};
      row.is_indistinct = decision_.is_indistinct[s];
    }
  }

  void FindFront() {
    if (objectives_.size() != 2) return;
    choice_.front = ParetoFront(relative_[0].rowwise().mean(), relative_[1].rowwise().mean(), Admitted());
    for (const std::size_t row : choice_.front) choice_.rows[row].is_on_front = true;
  }

  void FindClicks() {
    std::map<Setting, std::size_t> places;
    for (std::size_t s = 0; s < choice_.rows.size(); ++s) places.emplace(choice_.rows[s].setting, s);
    const RatedSetting& best = choice_.rows[*choice_.best];
    for (std::size_t k = 0; k < settings_.knobs.size(); ++k) {
      ClickLoss click{.knob = k, .loss = std::nan("")};
      for (const Setting& neighbour : NeighboursOf(settings_.knobs, best.setting)) {
        const auto place = places.find(neighbour);
        if (neighbour[k] == best.setting[k] || place == places.end() || !has_answer_[place->second]) continue;
        const RatedSetting& row = choice_.rows[place->second];
        click.loss = std::fmax(click.loss, row.beside_best.mean);
        click.leaves_limits = click.leaves_limits || !row.is_admitted;
      }
      choice_.clicks.push_back(click);
    }
  }

  /// Rows that may be the best, the best one first.
  std::vector<std::size_t> Contenders() const {
    std::vector<std::size_t> contenders;
    for (std::size_t s = 0; s < choice_.rows.size(); ++s)
      if (s != *choice_.best && (choice_.rows[s].is_indistinct || choice_.rows[s].best_probability > 0))
        contenders.push_back(s);
    std::stable_sort(contenders.begin(), contenders.end(), [&](std::size_t a, std::size_t b) {
      return choice_.rows[a].best_probability > choice_.rows[b].best_probability;
    });
    contenders.insert(contenders.begin(), *choice_.best);
    contenders.resize(std::min(contenders.size(), kMostRivals));
    return contenders;
  }

  /// Draws whose parameters vary.
  void FindDeciding() {
    const std::vector<std::size_t> contenders = Contenders();
    if (contenders.size() < 2) return;
    Eigen::MatrixXd cost(static_cast<Index>(contenders.size()), cost_.cols());
    for (std::size_t c = 0; c < contenders.size(); ++c)
      cost.row(static_cast<Index>(c)) = cost_.row(static_cast<Index>(contenders[c]));
    const auto rival = std::find(contenders.begin(), contenders.end(), choice_.rival) - contenders.begin();
    choice_.deciding = DecidingParameters(cost, 0, static_cast<std::size_t>(rival), request_.draws(kept_, Eigen::all));
    std::erase_if(choice_.deciding, [](const DecidingParameter& one) { return one.explained <= 0 && one.gain <= 0; });
    choice_.runs = InformativeRuns(cost, settings_.repeatability, kMostRuns);
    for (InformativeRun& run : choice_.runs) run.setting = contenders[run.setting];
  }

  const ChoiceRequest& request_;
  const SettingsFile& settings_;
  const SettingTable& table_;
  Choice& choice_;
  std::vector<Index> kept_;
  std::vector<Eigen::MatrixXd> objectives_;
  std::vector<Eigen::MatrixXd> margins_;
  /// To the present setting of the same car.
  std::vector<Eigen::MatrixXd> relative_;
  std::vector<bool> has_answer_;
  Eigen::MatrixXd cost_;
  Decision decision_;
};

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

/// Compares the change of the best settings against the present one with slower engines.
class EngineComparison {
 public:
  EngineComparison(const ChoiceRequest& request, const WorkHooks& hooks, Choice& choice)
      : request_(request), hooks_(hooks), choice_(choice) {}

  void Run() {
    if (request_.histories) Compare(EngineCheck::Engine::kHistories, request_.histories, Shortlist());
    if (request_.full && !choice_.is_interrupted) Compare(EngineCheck::Engine::kFull, request_.full, {*choice_.best});
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

  void Compare(EngineCheck::Engine engine, const MetricsOf& metrics_of, const std::vector<std::size_t>& rows) {
    const SettableCar by_spectra{&request_.settings, request_.spectra};
    const SettableCar by_engine{&request_.settings, metrics_of};
    const Setting& present = choice_.rows[choice_.present].setting;
    std::vector<Setting> settings = {present};
    for (const std::size_t row : rows)
      if (row != choice_.present) settings.push_back(choice_.rows[row].setting);
    const std::vector<SettingScore> fast = ScoresOf(by_spectra, settings, request_.fitted, request_.threads, {});
    const std::vector<SettingScore> slow = ScoresOf(by_engine, settings, request_.fitted, request_.threads, hooks_);
    choice_.is_interrupted = slow.empty();
    if (choice_.is_interrupted) return;
    std::size_t next = 1;
    for (const std::size_t row : rows) {
      if (row == choice_.present) continue;
      const std::size_t i = next++;
      if (!slow[0].IsGood() || !slow[i].IsGood() || !fast[i].IsGood()) {
        choice_.findings.Report(kEngineWithoutRide, {request_.settings.file.string()},
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
      choice_.findings.Report(
          kEnginesDisagree, file,
          {std::to_string(beyond), std::to_string(compared), ObjectiveName(objective), EngineWords(engine),
           Percent(request_.settings.agreement), SettingText(request_.settings.knobs, choice_.rows[worst->row].setting),
           Percent(worst->by_spectra), Percent(worst->by_engine)});
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
        choice_.findings.Report(
            kEngineOrder, file,
            {EngineWords(engine), SettingText(request_.settings.knobs, choice_.rows[preferred].setting),
             Percent(least)});
    }
  }

  const ChoiceRequest& request_;
  const WorkHooks& hooks_;
  Choice& choice_;
};

}  // namespace

std::size_t Choice::IndistinctCount() const {
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const RatedSetting& row) { return row.is_indistinct; }));
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
    draws = Eigen::Map<const Eigen::RowVectorXd>(request.fitted.data(), static_cast<Index>(request.fitted.size()));
  const SettingTable table = TableOf(car, promising.settings, draws, request.threads, hooks);
  choice.is_interrupted = table.is_interrupted;
  if (choice.is_interrupted) return choice;
  ChoiceRequest with_draws = request;
  with_draws.draws = draws;
  Rating(with_draws, table, choice).Run();
  if (!choice.best) return choice;
  FindEnds(request, choice);
  EngineComparison(request, hooks, choice).Run();
  return choice;
}

}  // namespace fourpost
