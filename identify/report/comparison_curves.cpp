#include "identify/report/comparison_curves.h"

#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "analysis/report/picture_number.h"

namespace fourpost {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// The band [Hz] in which a run was fitted; null where it has none.
OrderedJson BandOf(const ComparedRun& run) {
  const std::vector<nlohmann::json> band = ListAt(run.result, "band_Hz");
  if (band.size() != 2 || !band[0].is_number() || !band[1].is_number() || !(band[1].get<double>() > 0)) return nullptr;
  return {PictureNumber(band[0].get<double>()), PictureNumber(band[1].get<double>())};
}

/// {"value", "lower", "upper"} in the unit of its file: the interval, null where there is none.
OrderedJson FittedJson(std::size_t run, const ReportedParameter& parameter) {
  return {{"run", run},
          {"unit", parameter.unit},
          {"value", PictureNumber(parameter.value)},
          {"lower", PictureNumber(parameter.lower_95)},
          {"upper", PictureNumber(parameter.upper_95)}};
}

/// Parameters that two runs or more fitted in one unit.
OrderedJson SharedParameters(const std::vector<ComparedRun>& runs) {
  OrderedJson list = OrderedJson::array();
  std::map<std::string, std::size_t> places;
  for (std::size_t run = 0; run < runs.size(); ++run)
    for (const ReportedParameter& parameter : runs[run].parameters) {
      const auto [place, is_new] = places.emplace(parameter.name, list.size());
      if (is_new) list.push_back({{"name", parameter.name}, {"unit", parameter.unit}, {"runs", OrderedJson::array()}});
      OrderedJson& shared = list[place->second];
      if (shared["unit"] == parameter.unit) shared["runs"].push_back(FittedJson(run, parameter));
    }
  OrderedJson several = OrderedJson::array();
  for (OrderedJson& parameter : list)
    if (parameter["runs"].size() > 1) several.push_back(std::move(parameter));
  return several;
}

}  // namespace

std::vector<ComparedCurves> CurvesOf(const std::vector<ComparedRun>& runs, ExperimentReports experiments) {
  std::vector<RunFolder> folders;
  for (const ComparedRun& run : runs) folders.push_back(run.Folder());
  std::vector<ComparedCurves> all;
  for (const ExperimentReport* experiment : experiments) {
    std::vector<ComparedCurves> curves = experiment->Compare(folders);
    std::move(curves.begin(), curves.end(), std::back_inserter(all));
  }
  return all;
}

OrderedJson ComparisonJson(const std::vector<ComparedRun>& runs, const std::vector<ComparedCurves>& curves) {
  OrderedJson names = OrderedJson::array();
  OrderedJson bands = OrderedJson::array();
  for (const ComparedRun& run : runs) {
    names.push_back(run.name);
    bands.push_back(BandOf(run));
  }
  OrderedJson json = {{"runs", std::move(names)}, {"bands", std::move(bands)}, {"parameters", SharedParameters(runs)}};
  for (const ComparedCurves& part : curves) json[part.id] = part.curves;
  return json;
}

}  // namespace fourpost
