#include "identify/report/report_tables.h"

#include <algorithm>
#include <cmath>

#include "analysis/files/json_text.h"
#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "analysis/signals/median.h"
#include "analysis/text/counted.h"

namespace fourpost {
namespace {

using html::Cell;
using html::NumberCell;
using html::TextCell;
using Json = nlohmann::json;
using Rows = std::vector<std::vector<Cell>>;

void AddRows(const std::string& group, const Json& object, Rows& rows) {
  if (!object.is_object()) return;
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) AddRows(group.empty() ? key : group + '.' + key, value, rows);
    else if (!value.is_array())
      rows.push_back(
          {TextCell(group.empty() ? key : group + '.' + key), TextCell(value.is_string() ? value.get<std::string>()
                                                                       : value.is_null() ? "none"
                                                                                         : CompactJson(value))});
  }
}

bool AnyHas(const std::vector<Json>& channels, const std::string& key) {
  return std::any_of(channels.begin(), channels.end(),
                     [&](const Json& channel) { return std::isfinite(NumberAt(channel, key)); });
}

/// "212, not white"; empty of older runs.
std::string IndependentSamples(const Json& channel) {
  const double samples = NumberAt(channel, "effective_samples");
  if (!std::isfinite(samples)) return "";
  return ShownDecimals(samples, 0) + (channel.value("residuals_white", true) ? ", white" : ", not white");
}

/// Of channels over time; gain, delay and what the residuals are like where there are any.
std::string HistoryTable(const std::string& title, const std::vector<Json>& channels) {
  if (channels.empty()) return "";
  const bool has_gain = AnyHas(channels, "gain");
  const bool has_noise = AnyHas(channels, "residual_correlation");
  Rows rows;
  for (const Json& channel : channels) {
    rows.push_back({TextCell(TextAt(channel, "recording")),
                    {html::Element("code", "", html::Escaped(TextAt(channel, "name"))), ""},
                    NumberCell(ShownNumber(NumberAt(channel, "nmse_percent"), 3)),
                    NumberCell(ShownDecimals(NumberAt(channel, "vaf_percent"), 2))});
    if (has_gain) {
      rows.back().push_back(NumberCell(ShownDecimals(NumberAt(channel, "gain"), 3)));
      rows.back().push_back(NumberCell(ShownDecimals(1e3 * NumberAt(channel, "delay_s"), 2)));
    }
    if (!has_noise) continue;
    rows.back().push_back(NumberCell(ShownDecimals(NumberAt(channel, "residual_correlation"), 2)));
    rows.back().push_back(NumberCell(IndependentSamples(channel)));
  }
  std::vector<std::string> head = {title, "channel", "NMSE, %", "VAF, %"};
  if (has_gain) head.insert(head.end(), {"gain", "delay, ms"});
  if (has_noise) head.insert(head.end(), {"lag-1 correlation", "independent residuals"});
  return html::Table(head, rows);
}

/// From where the vehicle was let go; empty where it was not.
std::string ReleaseHtml(const Json& result) {
  Rows rows;
  for (const Json& release : ListAt(result, "releases"))
    for (const Json& sensor : ListAt(release, "sensors")) {
      const auto cell = [&](const char* key) { return NumberCell(ShownNumber(1e3 * NumberAt(sensor, key), 3)); };
      rows.push_back({TextCell(TextAt(release, "recording")),
                      {html::Element("code", "", html::Escaped(TextAt(sensor, "name"))), ""},
                      cell("position_m"),
                      cell("position_sd_m"),
                      cell("velocity_mps"),
                      cell("velocity_sd_mps")});
    }
  return rows.empty() ? ""
                      : html::Table({"let go in", "sensor", "mm above rest", "sd", "mm/s", "sd"}, rows) +
                            html::Element("p", "note", "Standard deviations are given the fitted parameters.") + '\n';
}

/// What the channels allow without physics, beside what the model leaves; empty without any.
std::string YardstickHtml(const Json& result) {
  Rows rows;
  for (const char* list : {"channels", "validation"})
    for (const Json& channel : ListAt(result, list)) {
      if (!channel.is_object() || !channel.contains("yardstick") || !channel["yardstick"].is_object()) continue;
      const Json& yardstick = channel["yardstick"];
      const auto cell = [&](const char* key) { return NumberCell(ShownNumber(NumberAt(yardstick, key), 3)); };
      rows.push_back({TextCell(TextAt(channel, "recording")),
                      {html::Element("code", "", html::Escaped(TextAt(channel, "name"))), ""},
                      NumberCell(ShownNumber(NumberAt(channel, "nmse_percent"), 3)),
                      cell("nmse_percent"),
                      cell("repeat_nmse_percent"),
                      cell("coherence"),
                      cell("model_nmse_percent")});
    }
  if (rows.empty()) return "";
  return html::Table(
             {"recording", "channel", "NMSE, %", "best linear model, %", "repeats, %", "coherence", "of the model, %"},
             rows) +
         html::Element("p", "note",
                       "Without physics: the best linear model from the same inputs to the channel, what differs "
                       "between repeats, and coherence. NMSE above the least of linear model and repeats is the "
                       "model's: a better one exists. Below it, the data may allow no more.") +
         '\n';
}

/// The poles of a mode; of a pair of conjugates one.
std::string PolesText(const Json& mode) {
  const std::vector<Json> poles = ListAt(mode, "poles");
  std::string text;
  for (std::size_t i = 0; i + 1 < poles.size(); i += 2) {
    const double re = poles[i].is_number() ? poles[i].get<double>() : NAN;
    const double im = poles[i + 1].is_number() ? poles[i + 1].get<double>() : NAN;
    text += (i == 0 ? "" : ", ") + ShownNumber(re, 4);
    if (im != 0) text += " \u00b1 " + ShownNumber(std::abs(im), 4) + "i";
  }
  return text;
}

/// Motions that hold a twentieth of the energy and more: the three largest, the rest on demand.
std::string EnergyHtml(const Json& mode) {
  constexpr double kLeast = 0.05;
  constexpr std::size_t kFirst = 3;
  std::vector<std::pair<double, std::string>> shares;
  for (const Json& share : ListAt(mode, "energy"))
    if (const double part = NumberAt(share, "share"); part >= kLeast)
      shares.emplace_back(part, TextAt(share, "motion"));
  std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string first;
  std::string rest;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    std::string& text = i < kFirst || shares.size() == kFirst + 1 ? first : rest;
    text += (text.empty() ? "" : ", ") +
            html::Escaped(shares[i].second + ' ' + ShownDecimals(100 * shares[i].first, 0) + "\u00a0%");
  }
  if (rest.empty()) return first;
  return first + " <details class=\"more\"><summary>" + std::to_string(shares.size() - kFirst) + " more</summary>" +
         rest + "</details>";
}

}  // namespace

std::string ProfileTableHtml(const Json& result, const RunContents& run) {
  const std::vector<Json> parameters = ListAt(result, "parameters");
  Rows rows;
  for (const Json& profile : ListAt(result, "profiles")) {
    const auto parameter = std::find_if(parameters.begin(), parameters.end(), [&](const Json& candidate) {
      return TextAt(candidate, "name") == TextAt(profile, "name");
    });
    const std::vector<Json> interval = ListAt(profile, "interval_95");
    if (parameter == parameters.end() || interval.size() != 2) continue;
    const std::string text = UnitOf(*parameter, run);
    const std::optional<Unit> unit = ParseUnit(text);
    const auto end = [&](const Json& value) {
      return value.is_number() ? ShownShort(value.get<double>() / (unit ? unit->si : 1), 4) : std::string("open");
    };
    const bool better = profile.value("found_better", false);
    rows.push_back(
        {{html::Element("code", "", html::Escaped(TextAt(profile, "name"))), ""},
         NumberCell(end(interval[0])),
         NumberCell(end(interval[1])),
         TextCell(ShownUnit(text)),
         {better ? "found a lower cost than the fit: not the best optimum" : "", better ? "remark calls" : "remark"}});
  }
  return rows.empty() ? "" : html::Table({"95 % by profile", "from", "to", "unit", ""}, rows);
}

std::string ChannelTableHtml(const Json& result) {
  std::vector<Json> steady;
  std::vector<Json> histories;
  for (const Json& channel : ListAt(result, "channels"))
    (channel.contains("rms_dB") ? steady : histories).push_back(channel);
  const bool has_noise = AnyHas(steady, "residual_correlation");
  Rows rows;
  for (const Json& channel : steady) {
    rows.push_back({{html::Element("code", "", html::Escaped(TextAt(channel, "name"))), ""},
                    NumberCell(ShownDecimals(NumberAt(channel, "rms_dB"), 2)),
                    NumberCell(ShownDecimals(NumberAt(channel, "rms_deg"), 1))});
    if (has_noise) rows.back().push_back(NumberCell(ShownDecimals(NumberAt(channel, "residual_correlation"), 2)));
  }
  std::vector<std::string> head = {"channel", "rms, dB", "rms, deg"};
  if (has_noise) head.emplace_back("correlation of neighbouring residuals");
  return (rows.empty() ? "" : html::Table(head, rows)) + HistoryTable("fitted recording", histories) +
         HistoryTable("validation recording", ListAt(result, "validation")) +
         html::Folded("What the channels allow without physics", YardstickHtml(result)) + ReleaseHtml(result);
}

std::string ModeTableHtml(const Json& modes) {
  Rows rows;
  if (modes.is_array())
    for (const Json& mode : modes)
      rows.push_back({TextCell(TextAt(mode, "name")),
                      NumberCell(ShownDecimals(NumberAt(mode, "frequency_Hz"), 2)),
                      NumberCell(ShownDecimals(NumberAt(mode, "damping_ratio"), 3)),
                      NumberCell(PolesText(mode)),
                      {EnergyHtml(mode), "wrap"}});
  return rows.empty() ? "" : html::Table({"mode", "Hz", "damping ratio", "poles, 1/s", "kinetic energy"}, rows);
}

std::string ModeSectionHtml(const Json& modes) {
  const std::string table =
      ModeTableHtml(modes) + "<p class=\"note\">About static equilibrium, with mean damper rates.</p>\n";
  // Many modes need the width.
  constexpr std::size_t kBeside = 8;
  return html::Section(
      "modes", "Modes and poles",
      modes.is_array() && modes.size() > kBeside
          ? table + html::Drawn("poles")
          : "<div class=\"pair\"><div>" + table + "</div><div>" + html::Drawn("poles") + "</div></div>\n");
}

std::string SearchNoteHtml(const Json& result) {
  const Json search = result.value("search", Json::object());
  const std::string algorithm = TextAt(search, "algorithm");
  if (algorithm.empty()) return "";
  std::string text = "Searched by <code>" + html::Escaped(algorithm) + "</code>, ended by " +
                     html::Escaped(TextAt(search, "end")) + '.';
  for (const char* key : {"accelerations", "migrations"}) {
    const Json gain = search.value(key, Json::object());
    const double count = NumberAt(gain, "count");
    const double evaluations = NumberAt(gain, "evaluations");
    // A step that took up known points cost nothing and brought nothing.
    if (!(count > 0) || !(evaluations > 0)) continue;
    const double successes = NumberAt(gain, "successes");
    const std::string what = key == std::string_view("migrations") ? "migration" : "acceleration";
    text += ' ' + Counted(static_cast<std::size_t>(count), what) + " took " +
            Counted(static_cast<std::size_t>(evaluations), "evaluation") + "; " +
            (successes > 0 ? ShownDecimals(successes, 0) : "none") + " lowered the best cost.";
  }
  const Json starts = result.value("starts", Json::object());
  text += " Then Ceres refined " + ShownDecimals(NumberAt(starts, "refined"), 0) + " points, of which " +
          ShownDecimals(NumberAt(starts, "agreeing"), 0) + " agree.";
  return "<p class=\"note\">" + text + "</p>\n";
}

std::string StartTableHtml(const Json& result) {
  Rows rows;
  const std::vector<Json> runs = ListAt(result.value("starts", Json()), "runs");
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Json& run = runs[i];
    rows.push_back({NumberCell(std::to_string(i + 1)), TextCell(TextAt(run, "from")),
                    NumberCell(ShownNumber(NumberAt(run, "start_cost"), 6)),
                    NumberCell(ShownNumber(NumberAt(run, "cost"), 6)),
                    NumberCell(ShownDecimals(NumberAt(run, "iterations"), 0)),
                    NumberCell(ShownDecimals(NumberAt(run, "evaluations"), 0)), TextCell(TextAt(run, "end"))});
  }
  if (rows.empty()) return "";
  return html::Table({"", "start", "cost at start", "cost at end", "iterations", "evaluations", "end"}, rows);
}

std::string SettingsHtml(const Json& result) {
  Rows rows;
  for (const char* key : {"seed", "deadline_s", "evaluations", "search", "refine", "criteria", "versions"}) {
    const auto found = result.find(key);
    if (found == result.end()) continue;
    if (found->is_object()) AddRows(key, *found, rows);
    else AddRows("", Json{{key, *found}}, rows);
  }
  return rows.empty() ? ""
                      : "<details><summary>All settings and versions</summary>" +
                            html::Table({"setting", "value"}, rows) + "</details>\n";
}

}  // namespace fourpost
