#include "identify/choice/run_choice.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/text/text_table.h"
#include "identify/choice/car_metrics.h"
#include "identify/choice/findings.h"
#include "identify/run/run_draws.h"
#include "identify/study_file/result_reader.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// The draws of the free parameters as values of all parameters.
Eigen::MatrixXd AllParameters(const RunDraws& draws, const Vehicle& vehicle) {
  const std::vector<double> fitted = vehicle.ParameterValues();
  Eigen::MatrixXd all = Eigen::Map<const Eigen::RowVectorXd>(fitted.data(), static_cast<Index>(fitted.size()))
                            .replicate(draws.values.rows(), 1);
  for (std::size_t j = 0; j < draws.names.size(); ++j)
    for (std::size_t p = 0; p < vehicle.parameters.size(); ++p)
      if (vehicle.parameters[p].name == draws.names[j])
        all.col(static_cast<Index>(p)) = draws.values.col(static_cast<Index>(j));
  return all;
}

/// What the fit has seen, of result.json.
struct FittedRange {
  /// Upper end of the band [Hz]; NaN: not known.
  double highest_Hz = std::nan("");
  /// By the damper's name, of bump and rebound the faster one [m/s].
  std::map<std::string, double> damper_speeds;
};

FittedRange RangeOf(const nlohmann::json& result) {
  FittedRange range;
  try {
    if (result.contains("band_Hz") && result["band_Hz"].is_array()) range.highest_Hz = result["band_Hz"].at(1);
    for (const nlohmann::json& covered : result.value("covered", nlohmann::json::array())) {
      const std::string quantity = covered.at("quantity");
      if (quantity != "bump_speed" && quantity != "rebound_speed") continue;
      double& speed = range.damper_speeds[covered.at("element")];
      speed = std::max(speed, covered.at("upper").get<double>());
    }
  } catch (const nlohmann::json::exception&) {  // written by hand, or by another version
  }
  return range;
}

/// How much of the objectives lies beyond the band of the fit.
void CheckBand(const CarMetrics& car, const ChoiceRequest& request, const Eigen::MatrixXd& all, double highest_Hz,
               Diagnostics& findings) {
  constexpr double kVisible = 0.1;
  if (!(highest_Hz > request.settings.lower_Hz && highest_Hz < request.settings.upper_Hz)) return;
  SettingsFile within = request.settings;
  within.upper_Hz = highest_Hz;
  const std::vector<double> present =
      ValuesAt(request.settings.knobs, PresentSetting(request.settings.knobs), request.fitted);
  const Eigen::MatrixXd inside = car.Spectra(within)(present);
  const std::vector<double> weights = request.settings.RoadWeights();
  for (const Objective& objective : request.settings.objectives) {
    const double ratio = OverRoads(inside, objective.metric, weights) / OverRoads(all, objective.metric, weights);
    const double beyond = 1 - ratio * ratio;
    if (beyond > kVisible)
      findings.Report(
          kRoadBeyondBand, {request.settings.file.string()},
          {Rounded(100 * beyond, 2) + " %", request.metrics[objective.metric].name, Rounded(highest_Hz, 3)});
  }
}

/// Dampers that the roads move faster than the recordings did.
void CheckSpeeds(const CarMetrics& car, const Vehicle& vehicle, const ChoiceRequest& request, const FittedRange& range,
                 Diagnostics& findings) {
  const std::vector<double> present =
      ValuesAt(request.settings.knobs, PresentSetting(request.settings.knobs), request.fitted);
  const Eigen::MatrixXd speeds = car.DamperSpeeds(request.settings, present);
  for (Index d = 0; d < speeds.cols(); ++d) {
    const auto seen = range.damper_speeds.find(vehicle.dampers[static_cast<std::size_t>(d)].name);
    Index worst = 0;
    const double fastest = speeds.col(d).maxCoeff(&worst);
    if (seen == range.damper_speeds.end() || !(fastest > seen->second)) continue;
    const auto beyond = (speeds.col(d).array() > seen->second).count();
    findings.Report(kRoadBeyondSpeeds, {request.settings.file.string()},
                    {std::to_string(beyond), std::to_string(speeds.rows()), seen->first, Rounded(seen->second, 2),
                     Rounded(fastest, 2), request.settings.roads[static_cast<std::size_t>(worst)].name});
  }
}

/// Parameters of the benches beside those of the car.
void AddBenches(const std::vector<BenchDoubt>& benches, ChoiceRequest& request) {
  for (const BenchDoubt& bench : benches) {
    const Index before = request.bench_draws.cols();
    request.bench_draws.conservativeResize(bench.draws.rows(), before + bench.draws.cols());
    request.bench_draws.rightCols(bench.draws.cols()) = bench.draws;
    for (const std::string& name : bench.parameters) request.parameters.push_back(name + " of " + bench.name);
  }
}

/// Of the present setting at the fitted values.
Eigen::MatrixXd PresentMetrics(const ChoiceRequest& request) {
  const Place place{request.settings.file.string()};
  try {
    return request.spectra(ValuesAt(request.settings.knobs, PresentSetting(request.settings.knobs), request.fitted));
  } catch (const std::runtime_error& error) {
    Refuse(kPresentWithoutRide, place, {error.what()});
  } catch (const std::invalid_argument& error) {
    Refuse(kPresentWithoutRide, place, {error.what()});
  }
}

}  // namespace

ChoiceAnswer ChooseForRun(const RunChoiceRequest& request, const WorkHooks& hooks) {
  std::error_code failure;
  const bool is_run = std::filesystem::is_directory(request.run, failure);
  Diagnostics faults;
  const std::optional<Vehicle> vehicle = ReadVehicle(is_run ? request.run / "vehicle.urdf" : request.run, faults);
  if (!vehicle) throw FaultyInput(faults);
  const CarMetrics car(*vehicle);
  std::optional<SettingsFile> settings = ReadSettingsFile(request.settings, *vehicle, car.metrics(), faults);
  if (!settings) throw FaultyInput(faults);
  ChoiceAnswer answer{.subject = request.run.filename().string()};
  // Of "run/" too.
  if (answer.subject.empty()) answer.subject = request.run.parent_path().filename().string();
  ChoiceRequest& asked = answer.request;
  asked.settings = *std::move(settings);
  BenchDraws benches = DrawBenches(asked.settings.knobs, asked.settings.file,
                                   {.car = is_run ? request.run : std::filesystem::path(),
                                    .count = asked.settings.draws,
                                    .seed = asked.settings.seed,
                                    .threads = request.threads},
                                   hooks);
  if (benches.is_interrupted) {
    answer.choice.is_interrupted = true;
    return answer;
  }
  asked.metrics = car.metrics();
  asked.spectra = car.Spectra(asked.settings);
  asked.fitted = vehicle->ParameterValues();
  asked.threads = request.threads;
  for (const Parameter& parameter : vehicle->parameters) asked.parameters.push_back(parameter.name);
  answer.present_metrics = PresentMetrics(asked);
  if (request.has_checks) {
    asked.histories = car.Histories(asked.settings, CarMetrics::TimeEngine::kReduced);
    asked.full = car.Histories(asked.settings, CarMetrics::TimeEngine::kMultibody);
  }
  Diagnostics findings = std::move(benches.findings);
  FittedRange range;
  if (is_run) {
    const std::optional<RunDraws> draws = DrawFromRun(
        {.run = request.run, .count = asked.settings.draws, .seed = asked.settings.seed, .threads = request.threads},
        hooks);
    if (!draws) {
      answer.choice.is_interrupted = true;
      return answer;
    }
    asked.draws = AllParameters(*draws, *vehicle);
    answer.confidence = draws->confidence;
    findings.Add(draws->findings);
    range = RangeOf(ReadResultFile(request.run / "result.json"));
  } else if (benches.benches.empty()) {
    findings.Report(kChoiceWithoutDoubt, {request.run.string()});
  } else {
    findings.Report(kChoiceBenchDoubtOnly, {request.run.string()});
    asked.draws = Eigen::Map<const Eigen::RowVectorXd>(asked.fitted.data(), static_cast<Index>(asked.fitted.size()))
                      .replicate(static_cast<Index>(asked.settings.draws), 1);
  }
  AddBenches(benches.benches, asked);
  answer.benches = std::move(benches.benches);
  CheckBand(car, asked, answer.present_metrics, range.highest_Hz, findings);
  CheckSpeeds(car, *vehicle, asked, range, findings);
  hooks.Find(findings);
  answer.choice = Choose(asked, hooks);
  if (answer.choice.best) {
    const auto values_of = [&](std::size_t row) {
      return ValuesAt(asked.settings.knobs, answer.choice.rows[row].setting, asked.fitted);
    };
    answer.present_spectra = car.SpectraAt(asked.settings, values_of(answer.choice.present));
    answer.best_spectra = car.SpectraAt(asked.settings, values_of(*answer.choice.best));
    answer.best_metrics = asked.spectra(values_of(*answer.choice.best));
  }
  findings.Add(answer.choice.findings);
  answer.choice.findings = std::move(findings);
  // They refer to the vehicle, which ends here.
  asked.spectra = asked.histories = asked.full = {};
  return answer;
}

}  // namespace fourpost
