#include "identify/choice/choice_words.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "analysis/text/counted.h"
#include "analysis/text/enumeration.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

std::string ObjectiveWords(const ChoiceAnswer& answer) {
  std::vector<std::string> names;
  for (const Objective& objective : answer.request.settings.objectives)
    names.push_back(answer.MetricOf(objective).name);
  return Enumeration(names);
}

}  // namespace

std::string TwoDecimals(double share) {
  std::ostringstream text;
  // No "-0.00".
  text << std::fixed << std::setprecision(2) << std::round(1e4 * share) / 100 + 0.0;
  return text.str();
}

std::string SharePercent(double share) { return TwoDecimals(share) + " %"; }

std::string IntervalPercent(const DrawSummary& summary) {
  return TwoDecimals(summary.lower) + " .. " + TwoDecimals(summary.upper);
}

std::string ScopeWords(const ChoiceAnswer& answer) {
  const Choice& choice = answer.choice;
  std::vector<std::string> knobs;
  for (const Knob& knob : answer.knobs()) knobs.push_back(knob.name);
  std::string text = std::to_string(choice.lattice) + " settings of " + Enumeration(knobs);
  if (choice.was_searched) text += ", " + std::to_string(choice.evaluated) + " of them searched by dvHDE";
  if (static_cast<std::int64_t>(choice.rows.size()) < choice.evaluated)
    text += ", the best " + std::to_string(choice.rows.size()) + " in all possible cars";
  text += "; " + Counted(answer.request.settings.roads.size(), "road") + "; ";
  if (!answer.has_doubt()) return text + "one car, whose standard deviations are not known.";
  text += Counted(answer.draws(), "possible car");
  return text + (answer.confidence.empty() ? "." : " of the fit's intervals (" + answer.confidence + ").");
}

std::string DoubtWords(const ChoiceAnswer& answer) {
  if (!answer.choice.best || !answer.has_doubt()) return "";
  std::vector<std::string> held;
  if (!answer.confidence.empty()) held.emplace_back("the car's parameters");
  for (const BenchDoubt& bench : answer.benches)
    held.push_back("the laws of " + Enumeration(bench.knobs) + " from the bench fit '" + bench.name + "' (" +
                   bench.confidence + ")");
  std::vector<std::string> not_held = {"what the model lacks on these roads"};
  const std::size_t compared = answer.choice.ComparedCount();
  const std::string by_engine = "the difference between spectra and time histories";
  if (compared == 0) not_held.push_back(by_engine);
  const std::vector<std::string> exact = answer.ExactKnobs();
  if (!exact.empty()) not_held.push_back("the numbers of " + Enumeration(exact));
  if (answer.HasStraightLines()) not_held.emplace_back("straight lines between benched positions");
  return "P(best) and regret include the uncertainty of " + Enumeration(held) +
         " (noise, held parameters and model error in their recordings)" +
         (compared > 0 ? ", and " + by_engine + " as of " + Counted(compared, "setting") : "") + ". They exclude " +
         Enumeration(not_held) + ", so they are too sure.";
}

std::string VerdictWords(const ChoiceAnswer& answer) {
  const Choice& choice = answer.choice;
  if (!choice.best) return "No setting meets the limits: nothing is chosen.";
  const RatedSetting& best = choice.rows[*choice.best];
  const std::string name = answer.NameOf(*choice.best);
  if (choice.best == choice.present) return "The present setting, " + name + ", is the best.";
  std::string text =
      "The best setting is " + name + ": " + ObjectiveWords(answer) + " change by " + SharePercent(best.change.mean);
  if (answer.has_doubt()) text += " (95 % of cars: " + IntervalPercent(best.change) + " %)";
  text += " against now.";
  if (answer.has_doubt())
    text += " It is the best with probability " + Rounded(best.best_probability, 2) + "; its expected regret is " +
            SharePercent(best.regret) + ".";
  return text;
}

std::string IndistinctWords(const ChoiceAnswer& answer) {
  const Choice& choice = answer.choice;
  if (!choice.best || !answer.has_doubt()) return "";
  const std::size_t others = choice.IndistinctCount() - 1;
  const std::string of = " of " + Counted(choice.rows.size(), "setting");
  if (others == 0) return "It is distinguished from all others" + of + ".";
  std::string text = Counted(others, "other setting") + of +
                     " cannot be distinguished from it (the interval of the paired difference holds zero)";
  return text + (choice.rows[choice.present].is_indistinct && choice.best != choice.present
                     ? ", the present one among them."
                     : ".");
}

std::string ClickWords(const ChoiceAnswer& answer) {
  if (!answer.choice.best) return "";
  std::vector<std::string> parts;
  for (const ClickLoss& click : answer.choice.clicks) {
    const std::string& name = answer.knobs()[click.knob].name;
    if (std::isnan(click.loss)) continue;
    parts.push_back(name + ' ' + SharePercent(click.loss) + (click.leaves_limits ? " and leaves the limits" : ""));
  }
  return parts.empty() ? "" : "One click beside it costs at most: " + Enumeration(parts) + ".";
}

std::string DecidingWords(const ChoiceAnswer& answer) {
  const Choice& choice = answer.choice;
  if (!choice.best || choice.deciding.empty()) return "";
  constexpr std::size_t kMost = 3;
  constexpr double kLeast = 0.05;
  const std::string rival = "the best setting and its likeliest rival, " + answer.NameOf(choice.rival);
  std::vector<std::string> parts;
  for (const DecidingParameter& one : choice.deciding) {
    if (parts.size() == kMost || one.explained < kLeast) break;
    parts.push_back(
        answer.request.parameters[one.parameter] + " (" + Rounded(100 * one.explained, 2) + " % of its variance" +
        (one.gain > 0 ? "; known, it would lower the expected regret by " + SharePercent(one.gain) : "") + ")");
  }
  if (parts.empty()) return "No single parameter's doubt decides between " + rival + ".";
  return "Doubt of these decides between " + rival + ": " + Enumeration(parts) + ".";
}

std::string RunWords(const ChoiceAnswer& answer) {
  const Choice& choice = answer.choice;
  if (!choice.best || !answer.has_doubt()) return "";
  if (choice.runs.empty())
    return "No run on the rig would decide more: in no possible car is another setting the best.";
  // Of the expected regret, below which a run is not worth its time.
  constexpr double kWorth = 0.1;
  const InformativeRun& run = choice.runs.front();
  const std::string repeats = Rounded(100 * answer.request.settings.repeatability, 2) + " %";
  if (run.gain < kWorth * choice.rows[*choice.best].regret)
    return "No run on the rig that repeats within " + repeats + " would decide more: settings differ by less.";
  return "Test next: " + answer.NameOf(run.setting) +
         " beside the present setting, which lowers the expected regret by " + SharePercent(run.gain) +
         " (one run repeats within " + repeats + ").";
}

std::string EngineWords(const ChoiceAnswer& answer) {
  const Choice& choice = answer.choice;
  if (!choice.best || choice.checks.empty()) return "";
  double most = 0;
  bool has_full = false;
  for (const EngineCheck& check : choice.checks) {
    if (check.objective || check.engine != EngineCheck::Engine::kFull) continue;
    has_full = true;
    // What ranks the settings.
    double ranked = check.by_spectra;
    for (const EngineCheck& other : choice.checks)
      if (!other.objective && other.engine == EngineCheck::Engine::kHistories && other.row == check.row)
        ranked = other.by_engine;
    most = std::max(most, std::abs(check.by_engine - ranked));
  }
  if (!has_full) return "";
  const auto within = std::count_if(choice.rows.begin(), choice.rows.end(), [&](const RatedSetting& row) {
    return row.is_admitted && row.beside_best.mean <= most;
  });
  const auto others = static_cast<std::size_t>(within - 1);
  return "The multibody system and the reduced model differ by " + SharePercent(most) +
         " in the change of all objectives together; " + Counted(others, "other setting") +
         (others == 1 ? " is" : " are") + " within that of the best one.";
}

}  // namespace fourpost
