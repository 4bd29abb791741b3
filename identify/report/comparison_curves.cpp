#include "identify/report/comparison_curves.h"

#include <iterator>
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
  OrderedJson json = {{"runs", std::move(names)}, {"bands", std::move(bands)}};
  for (const ComparedCurves& part : curves) json[part.id] = part.curves;
  return json;
}

}  // namespace fourpost
