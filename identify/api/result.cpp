#include <fourpost/fit.h>

#include <fstream>
#include <iterator>
#include <limits>

#include <nlohmann/json.hpp>

#include "identify/api/errors.h"
#include "identify/api/result_reader.h"
#include "identify/report/run_result.h"

namespace fourpost::api {
namespace {

using Json = nlohmann::json;

double Number(const Json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

FittedParameter ParameterOf(const Json& json) {
  FittedParameter parameter{.name = json.value("name", ""),
                            .unit = json.value("unit", ""),
                            .start = Number(json.value("start", Json())),
                            .value = Number(json.value("value", Json())),
                            .sd = Number(json.value("sd", Json())),
                            .state = json.value("state", ""),
                            .is_at_bound = json.value("at_bound", false)};
  const Json interval = json.value("interval_95", Json());
  const bool has_interval = interval.is_array() && interval.size() == 2;
  parameter.lower_95 = Number(has_interval ? interval[0] : Json());
  parameter.upper_95 = Number(has_interval ? interval[1] : Json());
  return parameter;
}

}  // namespace

Result ResultOf(const std::string& text, const std::filesystem::path& folder) {
  const Json json = Json::parse(text);
  // Null of a fit that was interrupted.
  const Json verdict = json.value("verdict", Json());
  Result result{.termination = json.value("termination", ""),
                .explains_data = verdict.is_object() && verdict.value("explains_data", false),
                .cost = Number(json.value("cost", Json())),
                .residuals = json.value("residuals", 0),
                .folder = folder};
  for (const Json& parameter : json.value("parameters", Json::array()))
    result.parameters.push_back(ParameterOf(parameter));
  for (const Json& warning : json.value("warnings", Json::array()))
    result.warnings.push_back(warning.is_string()
                                  ? Finding{.text = warning.get<std::string>()}
                                  : Finding{.code = warning.value("id", ""), .text = warning.value("text", "")});
  return result;
}

Result ReadResult(const std::filesystem::path& folder) {
  return Guarded([&] {
    RunContents run;
    if (std::ifstream in(folder / "result.json", std::ios::binary); in)
      run.files["result.json"] = std::string(std::istreambuf_iterator<char>(in), {});
    // Refuses what no fit has written.
    return ResultOf(FitResultOf(run).dump(), folder);
  });
}

const FittedParameter& Result::At(const std::string& parameter) const {
  std::vector<std::string> known;
  for (const FittedParameter& one : parameters) {
    if (one.name == parameter) return one;
    known.push_back(one.name);
  }
  RefuseName("parameter", parameter, known);
}

}  // namespace fourpost::api
