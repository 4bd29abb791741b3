#include "identify/study/loaded_study.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "analysis/files/near_file.h"
#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "analysis/text/units.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/residuals/calibrated_sensor.h"
#include "identify/study/findings.h"
#include "identify/study/scale_lint.h"
#include "identify/study/study_audit.h"
#include "identify/study_file/findings.h"
#include "vehicles/description/moved_points.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/requests/parameter_setting.h"

namespace fourpost {
namespace {

bool HasRange(const Parameter& parameter) { return parameter.upper > parameter.lower; }

/// Of all recordings to fit, increasing.
std::vector<double> SettingsOf(const Study& study) {
  std::set<double> settings;
  for (const Experiment& experiment : study.experiments)
    for (const double setting : experiment.Settings()) settings.insert(setting);
  return {settings.begin(), settings.end()};
}

std::vector<std::string> NamesOf(const Vehicle& vehicle) {
  std::vector<std::string> names;
  for (const Parameter& parameter : vehicle.parameters) names.push_back(parameter.name);
  return names;
}

/// As a tag, at a setting; `like` what the other parameter is there.
std::string TagText(const Parameter& parameter, const std::string& name, const std::string& like) {
  const auto shown = [&](double value) {
    const double unit = parameter.unit.empty() ? 1 : ParseUnit(parameter.unit)->si;
    return FormatNumber(value / unit) + (parameter.unit.empty() ? "" : " " + parameter.unit);
  };
  std::string text = "  <fp:parameter name=\"" + name + "\" value=\"" + shown(parameter.value) + '"';
  if (HasRange(parameter))
    text += " lower=\"" + shown(parameter.lower) + "\" upper=\"" + shown(parameter.upper) + "\" precision=\"" +
            shown(parameter.precision) + '"';
  if (!like.empty()) text += " like=\"" + like + "\" like_sd=\"" + FormatNumber(parameter.like->sd) + '"';
  return text + " source=\"'" + parameter.name + "' at another setting\"/>\n";
}

/// What a parameter is like at a setting: the other one there, where that follows the control as well; empty without.
std::string LikeAt(const Study& study, const Parameter& parameter, double setting,
                   const std::vector<double>& settings) {
  if (!parameter.like) return "";
  const std::string& other = parameter.like->parameter;
  for (const StudyControl::Follower& follower : study.control.followers) {
    const std::vector<double> knots = KnotsOf(follower, settings);
    if (follower.parameter == other && std::find(knots.begin() + 1, knots.end(), setting) != knots.end())
      return NameAtSetting(other, setting);
  }
  return other;
}

/// Text of the vehicle with the parameters of followers at settings for which it has none.
std::string WithSettings(const Study& study, const Vehicle& vehicle, Diagnostics& diagnostics) {
  const std::vector<std::string> names = NamesOf(vehicle);
  const std::vector<double> settings = SettingsOf(study);
  std::string tags;
  for (const StudyControl::Follower& follower : study.control.followers) {
    const auto found = std::find(names.begin(), names.end(), follower.parameter);
    if (settings.empty())
      diagnostics.Report(kControlWithoutSetting, {study.file.string(), follower.line}, {follower.parameter});
    if (found == names.end()) {
      diagnostics.Report(kFreeUnknown, {study.file.string(), follower.line},
                         {follower.parameter, DidYouMeanOrAll(follower.parameter, names)});
      continue;
    }
    const Parameter& followed = vehicle.parameters[static_cast<std::size_t>(found - names.begin())];
    const std::vector<double> knots = KnotsOf(follower, settings);
    for (std::size_t k = 1; k < knots.size(); ++k)
      if (const std::string name = NameAtSetting(follower.parameter, knots[k]);
          std::find(names.begin(), names.end(), name) == names.end())
        tags += TagText(followed, name, LikeAt(study, followed, knots[k], settings));
  }
  std::string text = vehicle.text;
  text.insert(text.rfind("</robot>"), tags);
  return text;
}

/// Nothing after an error.
std::optional<Vehicle> VehicleOf(const Study& study, Diagnostics& diagnostics) {
  std::optional<Vehicle> vehicle = ReadVehicle(study.vehicle, diagnostics);
  if (!vehicle || study.control.followers.empty()) return vehicle;
  const std::string text = WithSettings(study, *vehicle, diagnostics);
  Diagnostics found_before;
  if (diagnostics.HasErrors()) return std::nullopt;
  return ReadVehicleText(text, study.vehicle, found_before);
}

/// With the followers that are free, all of their settings.
std::vector<std::string> FreeNames(const Study& study) {
  std::vector<std::string> names = study.free;
  const std::vector<double> settings = SettingsOf(study);
  for (const StudyControl::Follower& follower : study.control.followers) {
    if (std::find(study.free.begin(), study.free.end(), follower.parameter) == study.free.end()) continue;
    const std::vector<double> knots = KnotsOf(follower, settings);
    for (std::size_t k = 1; k < knots.size(); ++k)
      if (const std::string name = NameAtSetting(follower.parameter, knots[k]);
          std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  }
  return names;
}

std::vector<std::size_t> FreeParameters(const Study& study, const Vehicle& vehicle, Diagnostics& diagnostics) {
  std::vector<std::size_t> free;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < vehicle.parameters.size(); ++i) {
    names.push_back(vehicle.parameters[i].name);
    const bool is_held = std::find(study.held.begin(), study.held.end(), names.back()) != study.held.end();
    if (study.free.empty() && !is_held && HasRange(vehicle.parameters[i])) free.push_back(i);
  }
  for (const std::string& name : study.held)
    if (std::find(names.begin(), names.end(), name) == names.end())
      diagnostics.Report(kFreeUnknown, {study.file.string(), study.free_line}, {name, DidYouMeanOrAll(name, names)});
  for (const std::string& name : FreeNames(study)) {
    const auto found = std::find(names.begin(), names.end(), name);
    const auto index = static_cast<std::size_t>(found - names.begin());
    if (found == names.end())
      diagnostics.Report(kFreeUnknown, {study.file.string(), study.free_line}, {name, DidYouMeanOrAll(name, names)});
    else if (!HasRange(vehicle.parameters[index]))
      diagnostics.Report(kFreeWithoutRange, {vehicle.file, vehicle.parameters[index].line}, {name});
    else if (std::find(free.begin(), free.end(), index) != free.end())
      diagnostics.Report(kFreeTwice, {study.file.string(), study.free_line}, {name});
    else free.push_back(index);
  }
  if (free.empty() && study.free.empty()) diagnostics.Report(kNothingFree, {vehicle.file});
  for (const std::size_t index : free)
    if (const Parameter& one = vehicle.parameters[index]; one.value < one.lower || one.value > one.upper)
      diagnostics.Report(kFreeOutsideRange, {vehicle.file, one.line}, {one.name});
  return free;
}

/// Points that parameters move stay where they are in the reduced model, so that a fit of it would hold for other ones.
void CheckMovedPoints(const Study& study, const Vehicle& vehicle, const std::vector<std::size_t>& free,
                      Diagnostics& diagnostics) {
  if (std::all_of(study.experiments.begin(), study.experiments.end(),
                  [](const Experiment& experiment) { return experiment.FollowsPoints(); }))
    return;
  const std::vector<bool> moves = MovePoints(vehicle);
  for (const std::size_t index : free)
    if (moves[index])
      diagnostics.Report(kFreeMovesPoints, {study.file.string(), study.free_line}, {vehicle.parameters[index].name});
}

/// Values of `start`, at whose lines faults are, then those of options.
void SetValues(const Study& study, const std::vector<std::string>& set, Vehicle& vehicle, Diagnostics& diagnostics) {
  for (const StudyStart& start : study.start) {
    Diagnostics found;
    SetParameter(start.parameter + "=" + start.value, "start", vehicle, found);
    for (Diagnostic item : found.items()) {
      item.place = {study.file.string(), start.line};
      diagnostics.Add(std::move(item));
    }
  }
  SetParameters(set, vehicle, diagnostics);
}

void CheckCalibrations(const Study& study, const Vehicle& vehicle, Diagnostics& diagnostics) {
  std::vector<std::string> names(CalibratedGroups().begin(), CalibratedGroups().end());
  for (const Sensor& sensor : vehicle.sensors) names.push_back(sensor.name);
  for (const Calibration& calibration : study.calibrations)
    if (std::find(names.begin(), names.end(), calibration.of) == names.end())
      diagnostics.Report(kCalibrationUnknown, {study.file.string(), calibration.line},
                         {calibration.of, DidYouMeanOrAll(calibration.of, names)});
}

/// Whether all files are there that are to be fitted; names the study's own line for one that is not.
bool HasFiles(const Study& study, Diagnostics& diagnostics) {
  bool all = RequireFile(study.vehicle, study.file.string(), study.vehicle_line, diagnostics);
  for (const Experiment& experiment : study.experiments)
    for (const ExperimentFile& file : experiment.Files())
      if (file.use == ExperimentFile::Use::kFitted)
        all = RequireFile(file.path, study.file.string(), file.line, diagnostics) && all;
  return all;
}

}  // namespace

Control ControlOf(const Study& study, const Vehicle& vehicle) {
  return {study.control, SettingsOf(study), NamesOf(vehicle)};
}

bool LoadedStudy::HasDeviations() const {
  return std::all_of(study.experiments.begin(), study.experiments.end(),
                     [](const Experiment& experiment) { return experiment.HasDeviations(); });
}

void LoadedStudy::Prepare(const WorkHooks& hooks) {
  const Subject subject = MakeSubject();
  for (Experiment& experiment : study.experiments) experiment.Prepare(subject, hooks);
}

bool LoadedStudy::CorrectAt(const Eigen::VectorXd& fitted, const WorkHooks& hooks) {
  std::vector<double> values = vehicle.ParameterValues();
  for (std::size_t i = 0; i < free.size(); ++i) values[free[i]] = fitted[static_cast<Eigen::Index>(i)];
  const Subject subject = MakeSubject();
  bool is_due = false;
  for (Experiment& experiment : study.experiments) {
    const Experiment::Geometry geometry = experiment.CheckGeometry(subject, values, hooks);
    if (geometry == Experiment::Geometry::kInterrupted) return false;
    is_due |= geometry == Experiment::Geometry::kCorrectionDue;
  }
  if (is_due)
    for (Experiment& experiment : study.experiments) experiment.Correct();
  return true;
}

VehicleObjective LoadedStudy::MakeObjective(const Subject& subject) const {
  std::vector<ResidualBlock> blocks;
  for (const Experiment& experiment : study.experiments)
    if (std::optional<ResidualBlock> block = experiment.Residuals(subject)) blocks.push_back(*std::move(block));
  return {vehicle, free, std::move(blocks), study.calibrations};
}

std::vector<std::filesystem::path> LoadedStudy::InputFiles() const {
  std::vector<std::filesystem::path> files = {study.file, vehicle.file};
  for (const FileContent& content : vehicle.contents)
    if (std::find(files.begin(), files.end(), content.file) == files.end()) files.emplace_back(content.file);
  for (const Experiment& experiment : study.experiments)
    for (const ExperimentFile& file : experiment.Files()) files.push_back(file.path);
  return files;
}

namespace {

std::optional<LoadedStudy> Loaded(std::optional<Study> study, Diagnostics& diagnostics,
                                  const std::vector<std::string>& set) {
  if (!study) return std::nullopt;
  if (study->problem) {
    diagnostics.Report(kStudyWithoutVehicle, {study->file.string(), study->problem_line});
    return std::nullopt;
  }
  if (!HasFiles(*study, diagnostics)) return std::nullopt;
  std::optional<Vehicle> vehicle = VehicleOf(*study, diagnostics);
  if (!vehicle) {
    for (const Experiment& experiment : study->experiments) experiment.CheckFiles(diagnostics);
    return std::nullopt;
  }
  SetValues(*study, set, *vehicle, diagnostics);
  CheckCalibrations(*study, *vehicle, diagnostics);
  std::vector<std::size_t> free = FreeParameters(*study, *vehicle, diagnostics);
  CheckMovedPoints(*study, *vehicle, free, diagnostics);
  LoadedStudy loaded{*std::move(study), *vehicle, std::move(free), set};
  const Subject subject = loaded.MakeSubject();
  for (Experiment& experiment : loaded.study.experiments) experiment.Load(subject, diagnostics);
  if (diagnostics.HasErrors()) return std::nullopt;
  loaded.fitted_files = FittedFiles(loaded.study);
  loaded.validation_files = ValidationFiles(loaded.study);
  return loaded;
}

}  // namespace

std::optional<LoadedStudy> LoadStudy(const std::filesystem::path& file, Diagnostics& diagnostics,
                                     const std::vector<std::string>& set) {
  return Loaded(ReadStudy(file, diagnostics), diagnostics, set);
}

std::optional<LoadedStudy> LoadStudyText(const std::string& text, const std::filesystem::path& file,
                                         Diagnostics& diagnostics) {
  return Loaded(ReadStudyText(text, file, diagnostics), diagnostics, {});
}

LoadedStudy LoadSoundStudy(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  std::optional<LoadedStudy> loaded = LoadStudy(file, diagnostics);
  if (!loaded || diagnostics.HasErrors()) throw FaultyInput(diagnostics);
  return *std::move(loaded);
}

std::optional<Audit> CheckRecordings(const LoadedStudy& study, Severity wrong_posts, Diagnostics& diagnostics) {
  LintScale(study, diagnostics);
  const Subject subject = study.MakeSubject();
  for (const Experiment& experiment : study.study.experiments) experiment.Check(subject, wrong_posts, diagnostics);
  const std::vector<Diagnostic>& found = diagnostics.items();
  if (std::any_of(found.begin(), found.end(), ContradictsAnAudit)) return std::nullopt;
  std::optional<Audit> audit = AuditStudy(study);
  if (audit) ReportAudit(study, *audit, wrong_posts, diagnostics);
  return audit;
}

}  // namespace fourpost
