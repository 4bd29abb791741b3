#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/files/csv_writer.h"
#include "analysis/files/json_text.h"
#include "analysis/text/text_table.h"
#include "identify/command_line/commands.h"
#include "identify/command_line/exit_code.h"
#include "identify/command_line/interrupt.h"
#include "identify/command_line/output_file.h"
#include "identify/command_line/print.h"
#include "identify/command_line/run_folder.h"
#include "identify/command_line/work_progress.h"
#include "identify/inspection/file_kind.h"
#include "identify/study_file/warnings_json.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> kMethods = {"normal", "weighted", "ensemble"};

std::string Csv(const RunDraws& draws) {
  CsvWriter csv(draws.names);
  for (const std::string& unit : draws.units) csv.Add(unit);
  for (Eigen::Index i = 0; i < draws.values.rows(); ++i)
    for (Eigen::Index j = 0; j < draws.values.cols(); ++j) csv.Add(draws.values(i, j));
  return csv.text();
}

/// Linear between draws.
double Quantile(const Eigen::VectorXd& values, double share) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Json Parameters(const RunDraws& draws) {
  Json list = Json::array();
  for (std::size_t j = 0; j < draws.names.size(); ++j) {
    const Eigen::VectorXd values = draws.values.col(static_cast<Eigen::Index>(j));
    list.push_back({{"name", draws.names[j]},
                    {"unit", draws.units[j]},
                    {"fitted", draws.fitted[static_cast<Eigen::Index>(j)]},
                    {"median", Quantile(values, 0.5)},
                    {"range_95", {Quantile(values, 0.025), Quantile(values, 0.975)}}});
  }
  return list;
}

Json Optima(const RunDraws& draws) {
  Json list = Json::array();
  for (const DrawnOptimum& optimum : draws.optima)
    list.push_back({{"cost", optimum.cost},
                    {"share", optimum.share},
                    {"values", std::vector<double>(optimum.values.begin(), optimum.values.end())}});
  return list;
}

std::string AsJson(const DrawsCommand& command, const RunDraws& draws) {
  Json json = {{"run", command.run.filename().string()},
               {"of", command.noise_only ? "noise" : "total"},
               {"method", kMethods[static_cast<std::size_t>(draws.method)]},
               {"count", draws.values.rows()},
               {"seed", command.seed},
               {"evaluations", draws.evaluations},
               {"effective", NumberOrNull(draws.effective)},
               {"ensemble", nullptr},
               {"optima", Optima(draws)},
               {"held", draws.held},
               {"parameters", Parameters(draws)},
               {"warnings", WarningsJson(draws.findings)}};
  if (draws.method == DrawMethod::kEnsemble)
    json["ensemble"] = {
        {"generations", draws.generations}, {"accepted", draws.accepted}, {"correlation", draws.remembered}};
  if (command.output.empty()) {
    Json& rows = json["draws"] = Json::array();
    for (Eigen::Index i = 0; i < draws.values.rows(); ++i) {
      Json row = Json::array();
      for (Eigen::Index j = 0; j < draws.values.cols(); ++j) row.push_back(draws.values(i, j));
      rows.push_back(std::move(row));
    }
  }
  return JsonText(json);
}

std::string MethodText(const DrawsCommand& command, const RunDraws& draws) {
  const std::string count = std::to_string(draws.values.rows()) + " draws";
  if (draws.method == DrawMethod::kNormal)
    return count + " of noise, held parameters and model error together, as the intervals of " + draws.confidence +
           "; normal, within the ranges";
  const std::string evaluations = "; " + std::to_string(draws.evaluations) + " evaluations";
  const std::string worth =
      std::to_string(command.count) + " normal draws were worth " + Rounded(draws.effective, 3) + evaluations;
  if (draws.method == DrawMethod::kWeighted) return count + " of the likelihood, by their weights: " + worth;
  return count + " of the likelihood, by an ensemble sampler of " + std::to_string(draws.generations) +
         " generations, " + Rounded(100 * draws.accepted, 2) + " % of moves accepted: " + worth;
}

std::string Text(const DrawsCommand& command, const RunDraws& draws) {
  TextTable table({"parameter", "fitted", "median", "95 % of draws", "unit"});
  for (std::size_t j = 0; j < draws.names.size(); ++j) {
    const Eigen::VectorXd values = draws.values.col(static_cast<Eigen::Index>(j));
    table.Add({draws.names[j], Rounded(draws.fitted[static_cast<Eigen::Index>(j)], 4),
               Rounded(Quantile(values, 0.5), 4),
               Rounded(Quantile(values, 0.025), 4) + " .. " + Rounded(Quantile(values, 0.975), 4), draws.units[j]});
  }
  std::string text = table.Format() + '\n' + MethodText(command, draws) + '\n';
  if (draws.optima.size() < 2) return text;
  TextTable optima({"optimum", "cost", "share of draws, %"});
  for (std::size_t k = 0; k < draws.optima.size(); ++k)
    optima.Add({std::to_string(k + 1), Rounded(draws.optima[k].cost, 6), Rounded(100 * draws.optima[k].share, 3)});
  return text + '\n' + optima.Format();
}

}  // namespace

int Run(const DrawsCommand& command) {
  RequireFitResult(command.run);
  if (!command.study.empty()) RequireStudyFile(command.study);
  RequireEnding("--output", command.output, "a table", ".csv");
  std::vector<std::filesystem::path> inputs = RunFiles(command.run);
  inputs.push_back(command.study);
  RequireWritable(command.output, inputs);
  CatchInterrupts();
  WorkProgress progress;
  const std::optional<RunDraws> draws = DrawFromRun(command, progress.Hooks());
  if (!draws) return kInterrupted;
  progress.Tell(draws->findings);
  progress.End();
  if (!command.output.empty()) WriteFile(command.output, Csv(*draws));
  if (command.json) Print(AsJson(command, *draws));
  else if (command.output.empty()) Print(Csv(*draws));
  else PrintText(Text(command, *draws));
  return kGood;
}

}  // namespace fourpost
