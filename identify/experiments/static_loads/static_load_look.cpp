#include "identify/experiments/static_loads/static_load_look.h"

#include "analysis/files/static_loads.h"
#include "analysis/text/number.h"
#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

using Json = nlohmann::ordered_json;

std::string TextOf(const std::vector<StaticMeasurement>& loads) {
  TextTable table({"quantity", "value", "sd", "unit"});
  for (const StaticMeasurement& load : loads)
    table.Add({load.name, Rounded(load.value, 5), Rounded(load.sd, 3), SiUnit(load.dimension)});
  return "static measurements\n" + table.Format();
}

Json JsonOf(const std::vector<StaticMeasurement>& loads) {
  Json quantities = Json::array();
  for (const StaticMeasurement& load : loads)
    quantities.push_back(
        {{"name", load.name}, {"value", load.value}, {"sd", load.sd}, {"unit", SiUnit(load.dimension)}});
  return {{"kind", "static"}, {"quantities", quantities}};
}

bool IsStatic(const RecordedTable& table) { return table.FindColumn("quantity") && table.FindColumn("value"); }

std::optional<RecordingLook> LookAt(const std::filesystem::path& file, const RecordedTable&, Diagnostics& faults) {
  const std::optional<std::vector<StaticMeasurement>> loads = ReadStaticLoads(file, faults);
  if (!loads) return std::nullopt;
  return RecordingLook{TextOf(*loads), JsonOf(*loads)};
}

}  // namespace

const RecordingViewer kStaticLoadViewer{.takes = &IsStatic, .look = &LookAt};

}  // namespace fourpost
