#include "identify/experiments/time_history/history_names.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "analysis/text/named.h"
#include "analysis/text/nearest.h"
#include "analysis/text/units.h"
#include "identify/experiments/time_history/findings.h"
#include "identify/study_file/findings.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

bool IsAmong(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class NameCheck {
 public:
  NameCheck(const StudyHistory& study, const std::string& file, const Vehicle& vehicle, Diagnostics& diagnostics)
      : study_(study),
        file_(file),
        vehicle_(vehicle),
        diagnostics_(diagnostics),
        posts_(NamesOf(vehicle.posts)),
        sensors_(NamesOf(vehicle.sensors)),
        actuators_(NamesOf(vehicle.actuators)) {}

  bool Run() {
    CheckChannels();
    if (study_.release) CheckRelease();
    // Posts that are not named rest.
    if ((study_.release || !study_.actuators.empty()) && study_.posts.empty()) return good_;
    for (const std::string& post : posts_)
      if (std::none_of(study_.posts.begin(), study_.posts.end(), [&](const auto& one) { return one.first == post; }))
        Fault(kHistoryPostMissing, study_.line, {study_.name, post});
    return good_;
  }

 private:
  void Fault(const Finding& finding, int line, const std::vector<std::string>& words) {
    diagnostics_.Report(finding, {file_, line}, words);
    good_ = false;
  }

  void Check(const Finding& finding, const std::string& name, const std::vector<std::string>& names, int line) {
    if (!IsAmong(name, names)) Fault(finding, line, {name, DidYouMeanOrAll(name, names)});
  }

  void CheckChannels() {
    if (study_.channels.empty()) Fault(kNoChannelByName, study_.line, {DidYouMeanOrAll("", sensors_)});
    for (const auto& [post, source] : study_.posts) Check(kHistoryPostUnknown, post, posts_, source.line);
    for (const auto& [actuator, source] : study_.actuators)
      Check(kHistoryActuatorUnknown, actuator, actuators_, source.line);
    for (const auto& [actuator, load] : study_.loads_N)
      Check(kHistoryActuatorUnknown, actuator, actuators_, study_.line);
    for (const auto& [sensor, source] : study_.channels) Check(kHistorySensorUnknown, sensor, sensors_, source.line);
  }

  void CheckRelease() {
    for (const Release::Hold& hold : study_.release->held) {
      Check(kHistorySensorUnknown, hold.sensor, sensors_, hold.line);
      for (const Sensor& sensor : vehicle_.sensors)
        if (sensor.name == hold.sensor && ParseUnit(UnitOf(sensor.type))->dimension != kLength)
          Fault(kReleaseOfOtherSensor, hold.line, {hold.sensor});
    }
    for (const Damper& damper : vehicle_.dampers)
      if (damper.hydraulic) Fault(kReleaseHydraulic, study_.line, {study_.name, damper.name});
  }

  const StudyHistory& study_;
  const std::string& file_;
  const Vehicle& vehicle_;
  Diagnostics& diagnostics_;
  std::vector<std::string> posts_;
  std::vector<std::string> sensors_;
  std::vector<std::string> actuators_;
  bool good_ = true;
};

}  // namespace

bool CheckHistoryNames(const StudyHistory& study, const std::string& file, const Vehicle& vehicle,
                       Diagnostics& diagnostics) {
  return NameCheck(study, file, vehicle, diagnostics).Run();
}

}  // namespace fourpost
