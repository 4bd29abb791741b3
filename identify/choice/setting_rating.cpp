#include "identify/choice/setting_rating.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/text/text_table.h"
#include "identify/choice/choice_words.h"
#include "identify/choice/findings.h"

namespace fourpost {
namespace {

using Eigen::Index;

constexpr std::size_t kMostRuns = 5;
/// Settings whose beliefs a run is planned on.
constexpr std::size_t kMostRivals = 200;

/// Rates settings by a table of them.
class Rating {
 public:
  Rating(const ChoiceRequest& request, const SettingTable& table, const std::vector<Eigen::MatrixXd>& errors,
         Choice& choice)
      : request_(request), settings_(request.settings), table_(table), errors_(errors), choice_(choice) {}

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
  Place SettingsPlace() const { return {settings_.file.string()}; }

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
    if (kept_.empty()) Refuse(kPresentWithoutRide, SettingsPlace(), {table_.failures[choice_.present]});
    if (static_cast<Index>(kept_.size()) < Draws())
      choice_.findings.Report(kDrawsLeftOut, SettingsPlace(),
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
        Refuse(kObjectiveZero, SettingsPlace(), {request_.metrics[settings_.objectives[o].metric].name});
    const Index count = objectives_.front().rows();
    cost_ = Eigen::MatrixXd::Zero(count, objectives_.front().cols());
    for (std::size_t o = 0; o < objectives_.size(); ++o) {
      const Eigen::RowVectorXd present = objectives_[o].row(static_cast<Index>(choice_.present));
      relative_.push_back(objectives_[o].array().rowwise() / present.array());
      if (!errors_.empty()) relative_[o].array() *= errors_[o](Eigen::all, kept_).array();
      objectives_[o] = relative_[o].array().rowwise() * present.array();
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
      choice_.findings.Report(kSettingsWithoutRide, SettingsPlace(),
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

  /// How far a metric is beyond its limit where it is nearest to it.
  std::string NearestText(std::size_t limit, std::size_t s, double margin) const {
    const MetricLimit& of = settings_.limits[limit];
    const Metric& metric = request_.metrics[of.metric];
    std::string text = "'" + metric.name + "' of ";
    if (of.least) text += "at least " + FormatRounded(*of.least, metric);
    if (of.most) text += std::string(of.least ? " and " : "") + "at most " + FormatRounded(*of.most, metric);
    return text + ": the nearest, " + SettingText(settings_.knobs, choice_.rows[s].setting) + ", misses it by " +
           FormatRounded(-margin, metric);
  }

  static std::string FormatRounded(double si, const Metric& metric) {
    return InUnit(si, metric.unit, 3) + (metric.unit.empty() ? "" : ' ' + metric.unit);
  }

  std::string Certainty() const { return Rounded(100 * settings_.certainty, 3) + " %"; }

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
                              {NearestText(l, nearest, most), Certainty()});
    }
    if (is_one_unattainable || margins_.empty()) return;
    std::size_t nearest = choice_.present;
    for (std::size_t s = 0; s < choice_.rows.size(); ++s)
      if (has_answer_[s] && choice_.rows[s].all_met > choice_.rows[nearest].all_met) nearest = s;
    const std::vector<double>& met = choice_.rows[nearest].limits_met;
    const auto binding = static_cast<std::size_t>(std::min_element(met.begin(), met.end()) - met.begin());
    choice_.findings.Report(
        kLimitsContradict, SettingsPlace(),
        {Certainty(), SettingText(settings_.knobs, choice_.rows[nearest].setting),
         SharePercent(choice_.rows[nearest].all_met), request_.metrics[settings_.limits[binding].metric].name});
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

  /// Of the car and of bench fits.
  Eigen::MatrixXd KeptParameters() const {
    Eigen::MatrixXd kept(static_cast<Index>(kept_.size()), request_.draws.cols() + request_.bench_draws.cols());
    kept.leftCols(request_.draws.cols()) = request_.draws(kept_, Eigen::all);
    if (request_.bench_draws.size() > 0)
      kept.rightCols(request_.bench_draws.cols()) = request_.bench_draws(kept_, Eigen::all);
    return kept;
  }

  /// Draws whose parameters vary.
  void FindDeciding() {
    const std::vector<std::size_t> contenders = Contenders();
    if (contenders.size() < 2) return;
    Eigen::MatrixXd cost(static_cast<Index>(contenders.size()), cost_.cols());
    for (std::size_t c = 0; c < contenders.size(); ++c)
      cost.row(static_cast<Index>(c)) = cost_.row(static_cast<Index>(contenders[c]));
    const auto rival = std::find(contenders.begin(), contenders.end(), choice_.rival) - contenders.begin();
    choice_.deciding = DecidingParameters(cost, 0, static_cast<std::size_t>(rival), KeptParameters());
    std::erase_if(choice_.deciding, [](const DecidingParameter& one) { return one.explained <= 0 && one.gain <= 0; });
    choice_.runs = InformativeRuns(cost, settings_.repeatability, kMostRuns);
    for (InformativeRun& run : choice_.runs) run.setting = contenders[run.setting];
  }

  const ChoiceRequest& request_;
  const SettingsFile& settings_;
  const SettingTable& table_;
  const std::vector<Eigen::MatrixXd>& errors_;
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

}  // namespace

void RateSettings(const ChoiceRequest& request, const SettingTable& table, const std::vector<Eigen::MatrixXd>& errors,
                  Choice& choice) {
  Rating(request, table, errors, choice).Run();
}

}  // namespace fourpost
