#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/files/csv_writer.h"
#include "analysis/text/text_table.h"
#include "identify/plan/plan.h"
#include "identify/study_file/warnings_json.h"
#include "vehicles/posts/height_signals.h"
#include "vehicles/posts/post_motions.h"
#include "vehicles/requests/history_channel.h"
#include "vehicles/requests/history_files.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

std::string Minutes(double seconds) { return Rounded(seconds / 60, 3); }

std::string RunsTable(const Plan& plan) {
  TextTable table({"run", "repeats", "min each", "min"});
  for (const PlannedRun& run : plan.runs)
    if (run.repeats > 0)
      table.Add({run.name, std::to_string(run.repeats), Minutes(run.time_s), Minutes(run.repeats * run.time_s)});
  return table.Format();
}

std::string RunsWords(const Plan& plan) {
  const std::string possible = std::to_string(plan.runs.size()) + " possible runs and measurements";
  if (plan.design.cost_s > 0)
    return "The plan takes " + Minutes(plan.design.cost_s) + " of " + Minutes(plan.rig.time_s) + " min, out of " +
           possible + ":\n\n" + RunsTable(plan);
  const bool is_known = plan.design.meets && !plan.rig.wanted.empty();
  return (is_known ? "All that is wanted is known already; none of " : "Nothing is gained by any of ") + possible +
         ".\n";
}

std::string ParametersTable(const Plan& plan) {
  const bool has_wanted = !plan.rig.wanted.empty();
  std::vector<std::string> head = {"parameter", "value", "sd now", "with plan", "shared evenly"};
  if (has_wanted) head.emplace_back("wanted");
  head.emplace_back("unit");
  TextTable table(std::move(head));
  for (const PlannedParameter& one : plan.parameters) {
    std::vector<std::string> cells = {one.name, InUnit(one.value, one.unit, 4), InUnit(one.before, one.unit, 3),
                                      InUnit(one.after, one.unit, 3), InUnit(one.even, one.unit, 3)};
    if (has_wanted) cells.push_back(one.wanted > 0 ? InUnit(one.wanted, one.unit, 3) : "");
    cells.push_back(one.unit);
    table.Add(std::move(cells));
  }
  return table.Format();
}

std::string BeyondReachWords(const Plan& plan) {
  std::string names;
  for (const PlannedParameter& one : plan.parameters)
    if (one.IsBeyondReach()) names += (names.empty() ? "" : ", ") + one.name;
  if (names.empty()) return "";
  return "All runs together narrow these by less than a tenth: " + names +
         ". Measure them directly, or move the car otherwise.\n";
}

std::string CertificateWords(const Plan& plan) {
  if (!plan.design.efficiency) return "";
  return "No plan in this time makes the standard deviations smaller than " +
         Rounded(100 * *plan.design.efficiency, 3) + " % of these (geometric mean).\n";
}

Json ParameterJson(const PlannedParameter& one) {
  return {{"name", one.name},
          {"unit", one.unit},
          {"value", one.value},
          {"sd_now", one.before},
          {"sd_with_plan", one.after},
          {"sd_shared_evenly", one.even},
          {"sd_with_all", one.best},
          {"wanted", one.wanted > 0 ? Json(one.wanted) : Json(nullptr)},
          {"beyond_reach", one.IsBeyondReach()}};
}

std::string RunsCsv(const Plan& plan) {
  CsvWriter csv({"run", "repeats", "minutes_each", "minutes"});
  for (const PlannedRun& run : plan.runs)
    csv.Add(run.name).Add(run.repeats).Add(run.time_s / 60).Add(run.repeats * run.time_s / 60);
  return csv.text();
}

std::string ParametersCsv(const Plan& plan) {
  CsvWriter csv({"parameter", "unit", "value", "sd_now", "sd_with_plan", "sd_shared_evenly", "sd_with_all", "wanted"});
  for (const PlannedParameter& one : plan.parameters)
    csv.Add(one.name)
        .Add(one.unit)
        .Add(one.value)
        .Add(one.before)
        .Add(one.after)
        .Add(one.even)
        .Add(one.best)
        .Add(one.wanted > 0 ? one.wanted : std::nan(""));
  return csv.text();
}

/// "heave 10 mm 0.5 Hz .. 5 Hz" as "heave_10_mm_0.5_Hz_5_Hz".
std::string AsFileName(const std::string& name) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string file;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool is_point = c == '.' && i + 1 < name.size() && is_digit(name[i + 1]);
    if (is_letter || is_digit(c) || is_point) file += c;
    else if (!file.empty() && file.back() != '_') file += '_';
  }
  return file.empty() ? "run" : file;
}

/// With a number where runs of other names have the same: "run_2". Case does not tell files apart everywhere.
std::string UnusedName(const std::string& name, std::set<std::string>& used) {
  const auto lower = [](std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
  };
  std::string unused = name;
  for (int i = 2; !used.insert(lower(unused)).second; ++i) unused = name + '_' + std::to_string(i);
  return unused;
}

/// Heights of the posts in a run, at rest first: mean offsets are relative to that.
TimeHistory DriveOf(const Plan& plan, const RigRun& run) {
  SteppedSine sines;
  for (const double frequency : run.frequency_Hz)
    sines.dwells.push_back({.frequency_Hz = frequency,
                            .amplitude_m = run.amplitude.At(frequency),
                            .duration_s = plan.rig.SettlingOf(frequency) + plan.rig.MeasuringOf(frequency)});
  const PostMotion motion = FollowPattern(sines.Signal(), run.shape);
  constexpr double kSamplesPerCycle = 10;
  constexpr double kLeast_Hz = 100;
  TimeHistory history{.rate_Hz = std::max(kLeast_Hz, std::ceil(kSamplesPerCycle * run.frequency_Hz.back()))};
  constexpr double kRest_s = 1;
  const TimeGrid grid{.end_s = kRest_s + sines.Duration(), .rate_Hz = history.rate_Hz};
  history.posts.resize(grid.count(), std::ssize(run.shape));
  history.readings.resize(grid.count(), 0);
  std::vector<PostState> posts(run.shape.size());
  for (Eigen::Index k = 0; k < grid.count(); ++k) {
    motion(history.TimeAt(k) - kRest_s, posts);
    for (std::size_t p = 0; p < posts.size(); ++p) history.posts(k, static_cast<Eigen::Index>(p)) = posts[p].height;
  }
  return history;
}

}  // namespace

std::string PlanText(const Plan& plan) {
  std::string text =
      RunsWords(plan) + '\n' + ParametersTable(plan) + '\n' + BeyondReachWords(plan) + CertificateWords(plan);
  if (plan.gain_over_even > 1.005)
    text += "The same time shared evenly over all runs makes them " + Rounded(plan.gain_over_even, 3) +
            " times as large.\n";
  text += "Standard deviations are those of noise and of the stated model error, for a model that lacks nothing.\n";
  if (plan.is_of_fit) text += "Those now are what the fit allows for noise alone; its intervals allow for more.\n";
  return text;
}

Json PlanJson(const Plan& plan) {
  Json runs = Json::array();
  for (const PlannedRun& run : plan.runs)
    runs.push_back(
        {{"name", run.name}, {"is_on_rig", run.run.has_value()}, {"repeats", run.repeats}, {"time_s", run.time_s}});
  Json parameters = Json::array();
  for (const PlannedParameter& one : plan.parameters) parameters.push_back(ParameterJson(one));
  return {{"subject", plan.subject},
          {"time_s", plan.rig.time_s},
          {"planned_time_s", plan.design.cost_s},
          {"planned_runs", std::move(runs)},
          {"planned_parameters", std::move(parameters)},
          {"efficiency", plan.design.efficiency ? Json(*plan.design.efficiency) : Json(nullptr)},
          {"meets_wanted", plan.design.meets},
          {"gain_over_even", plan.gain_over_even},
          {"warnings", WarningsJson(plan.findings)}};
}

std::vector<std::pair<std::string, std::string>> PlanFiles(const Plan& plan) {
  std::vector<std::pair<std::string, std::string>> files = {{"plan.csv", RunsCsv(plan)},
                                                            {"parameters.csv", ParametersCsv(plan)}};
  std::set<std::string> names;
  for (const PlannedRun& run : plan.runs) {
    if (run.repeats == 0 || !run.run) continue;
    const RigRun& rig_run = plan.rig.runs[*run.run];
    const TimeHistory history = DriveOf(plan, rig_run);
    const std::vector<HistoryChannel> channels = ChannelsOf(plan.vehicle, history, {});
    const std::string name = UnusedName("drive_" + AsFileName(rig_run.name), names);
    files.emplace_back(name + ".csv", HistoryCsv(history, channels));
    files.emplace_back(name + ".drv", HistoryDrive(rig_run.name, history, channels));
  }
  return files;
}

}  // namespace fourpost
