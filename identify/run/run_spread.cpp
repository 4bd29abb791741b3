#include "identify/run/run_spread.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/text/diagnostics.h"
#include "identify/run/findings.h"
#include "identify/study_file/result_reader.h"

namespace fourpost {
namespace {

using Eigen::Index;

Eigen::MatrixXd FromLowerTriangle(const nlohmann::json& rows) {
  const auto size = static_cast<Index>(rows.size());
  Eigen::MatrixXd matrix(size, size);
  for (Index i = 0; i < size; ++i)
    for (Index j = 0; j <= i; ++j)
      matrix(i, j) = matrix(j, i) = rows.at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j));
  return matrix;
}

Eigen::VectorXd Vector(const nlohmann::json& numbers) {
  const std::vector<double> values = numbers;
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Index>(values.size()));
}

Lattice LatticeOf(const nlohmann::json& parameters) {
  constexpr double kSteps = 1000;  // draws have none
  std::vector<LatticeAxis> axes;
  for (const nlohmann::json& parameter : parameters) {
    const double lower = parameter.at("lower");
    const double upper = parameter.at("upper");
    axes.push_back({parameter.at("name"), lower, upper, (upper - lower) / kSteps});
  }
  return Lattice(std::move(axes));
}

/// None after a correction to the full geometry, which goes on from the best alone and has costs of its own.
std::vector<EndedStart> OthersIn(const nlohmann::json& runs, std::size_t parameters) {
  if (std::any_of(runs.begin(), runs.end(), [](const nlohmann::json& run) { return run["from"] == "fit"; })) return {};
  std::vector<EndedStart> others;
  for (const nlohmann::json& run : runs) {
    if (run["end"] != "converged" || run["agrees"] == true || !run["cost"].is_number()) continue;
    if (run["values"].size() == parameters) others.push_back({run["cost"], Vector(run["values"])});
  }
  return others;
}

RunSpread SpreadOf(const nlohmann::json& result) {
  const nlohmann::json& parameters = result.at("parameters");
  const nlohmann::json& intervals = result.at("intervals");
  const nlohmann::json& covariance = intervals.at("covariance");
  RunSpread spread{.parameters = {.lattice = LatticeOf(parameters)}};
  spread.parameters.values.resize(static_cast<Index>(parameters.size()));
  const std::vector<std::string> judged = covariance.at("parameters");
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    spread.parameters.values[static_cast<Index>(i)] = parameters[i].at("value");
    spread.units.push_back(parameters[i].at("unit"));
    if (std::find(judged.begin(), judged.end(), parameters[i].at("name")) != judged.end())
      spread.parameters.judged.push_back(static_cast<Index>(i));
  }
  spread.parameters.noise = FromLowerTriangle(covariance.at("noise"));
  spread.parameters.total = FromLowerTriangle(covariance.at("total"));
  if (covariance.contains("moved_by_missing")) spread.parameters.moved = Vector(covariance["moved_by_missing"]);
  spread.cost = result.at("cost");
  spread.inflation = std::max(1.0, result.at("identifiability").at("sd_inflation").get<double>());
  spread.is_corrected = !intervals.at("moved_by_post_noise").empty();
  spread.confidence = intervals.at("confidence");
  spread.others = OthersIn(result.at("starts").at("runs"), parameters.size());
  return spread;
}

bool HasCovariance(const nlohmann::json& result) {
  if (!result.is_object() || !result.contains("intervals") || !result["intervals"].is_object()) return false;
  const nlohmann::json covariance = result["intervals"].value("covariance", nlohmann::json::object());
  return covariance.is_object() && covariance.contains("parameters") && !covariance["parameters"].empty();
}

}  // namespace

std::vector<std::string> RunSpread::Held() const {
  std::vector<std::string> names;
  for (std::size_t j = 0; j < parameters.lattice.size(); ++j)
    if (std::find(parameters.judged.begin(), parameters.judged.end(), static_cast<Index>(j)) == parameters.judged.end())
      names.push_back(parameters.lattice.axes()[j].name);
  return names;
}

std::string RunSpread::HeldText() const {
  std::string text;
  for (const std::string& name : Held()) text += (text.empty() ? "" : ", ") + name;
  return text;
}

bool HasRunSpread(const std::filesystem::path& run) { return HasCovariance(ReadResultFile(run / "result.json")); }

RunSpread ReadRunSpread(const std::filesystem::path& run) {
  const std::filesystem::path file = run / "result.json";
  const nlohmann::json result = ReadResultFile(file);
  if (!HasCovariance(result)) Refuse(kRunWithoutCovariance, {file.string()});
  try {
    RunSpread spread = SpreadOf(result);
    const auto judged = static_cast<Index>(spread.parameters.judged.size());
    const ParameterSpread& read = spread.parameters;
    const bool fits = read.moved.size() == 0 || read.moved.size() == judged;
    if (read.noise.rows() == judged && read.total.rows() == judged && fits) return spread;
  } catch (const nlohmann::json::exception&) {
  } catch (const std::invalid_argument&) {  // bounds that make no lattice
  }
  Refuse(kRunCovarianceDamaged, {file.string()});
}

}  // namespace fourpost
