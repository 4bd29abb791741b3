#include "identify/suggest/applied_suggestion.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/text/short_number.h"
#include "analysis/text/units.h"
#include "identify/study_file/study_edit.h"
#include "identify/suggest/augmented_study.h"
#include "identify/suggest/vehicle_edit.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/tags/tag.h"

namespace fourpost {
namespace {

/// New parameters with bounds within a factor of their expected values: the wide ones of a test hold values at which
/// nothing of the vehicle is left to see.
std::string WithNarrowBounds(const std::string& text, const SuggestedAddition& suggestion) {
  constexpr double kFactor = 10;
  VehicleEdit edit(text);
  for (std::size_t i = 0; i < suggestion.values.size(); ++i) {
    const tinyxml2::XMLElement* element = edit.Find("fp:parameter", suggestion.addition.parameters[i]);
    const double value = suggestion.values[i];
    if (!element || !(value > 0)) continue;
    const auto bound = [&](const char* name) { return ParseQuantity(AttributeText(*element, name).value_or("")); };
    const auto lower = bound("lower");
    const auto upper = bound("upper");
    if (!lower || !upper || lower->si < 0) continue;  // of a place the size says nothing
    const double least = lower->si > 0 ? std::max(lower->si, value / kFactor) : lower->si;
    const double most = std::min(upper->si, value * kFactor);
    // Rounding must not leave the value outside.
    edit.Set(*element, "lower", FormatQuantity(std::min(AtDigits(least, 4), value), lower->unit_text));
    edit.Set(*element, "upper", FormatQuantity(std::max(AtDigits(most, 4), value), upper->unit_text));
    edit.Set(*element, "precision", FormatQuantity(AtDigits((most - least) / 1e5, 3), upper->unit_text));
  }
  return edit.Text();
}

}  // namespace

AppliedSuggestion Apply(const LoadedStudy& study, const SuggestedAddition& suggestion,
                        const std::filesystem::path& folder) {
  const Addition& addition = suggestion.addition;
  Diagnostics findings;
  Vehicle vehicle = study.vehicle;
  if (!addition.vehicle.empty()) {
    std::optional<Vehicle> read = ReadVehicleText(addition.vehicle, study.vehicle.file, findings);
    if (!read) throw FaultyInput(findings);
    vehicle = WithValuesOf(study.vehicle, *std::move(read));
  }
  std::vector<double> all = vehicle.ParameterValues();
  const auto set = [&](const std::string& name, double value) {
    const std::optional<std::size_t> i = vehicle.IndexOf(name);
    if (i && !vehicle.HasPrior(*i))
      all[*i] = std::clamp(AtDigits(value, 6), vehicle.parameters[*i].lower, vehicle.parameters[*i].upper);
  };
  for (std::size_t i = 0; i < study.free.size(); ++i)
    set(study.vehicle.parameters[study.free[i]].name, suggestion.others[static_cast<Eigen::Index>(i)]);
  for (std::size_t i = 0; i < addition.parameters.size(); ++i) set(addition.parameters[i], suggestion.values[i]);

  StudyEdit edit(addition.study ? addition.study(suggestion.amount) : study.study.text);
  std::vector<std::filesystem::path> files;
  for (const Experiment& experiment : study.study.experiments)
    for (const ExperimentFile& file : experiment.Files()) files.push_back(file.path.lexically_normal());
  edit.Rebase(files, study.study.file.parent_path(), folder);
  edit.SetVehicle("vehicle.urdf");
  edit.AddFree(addition.parameters);
  if (study.vehicle.dampers.size() == 1 && vehicle.dampers.size() > 1)
    edit.NameDamper(study.vehicle.dampers.front().name);
  const std::string text = VehicleTextWithValues(vehicle, all, folder);
  return {.vehicle = addition.vehicle.empty() ? text : WithNarrowBounds(text, suggestion), .study = edit.Text()};
}

}  // namespace fourpost
