#include <map>

#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "identify/study_file/study_edit.h"
#include "identify/suggest/addition_source.h"

namespace fourpost {
namespace {

constexpr const char* NounOf(Sensor::Type type) {
  switch (type) {
    case Sensor::Type::kAccelerometer: return "accelerometers";
    case Sensor::Type::kDisplacement: return "displacements";
    case Sensor::Type::kStrut: return "struts";
    case Sensor::Type::kLoadCell: return "load cells";
    case Sensor::Type::kGyro: return "gyros";
  }
  return "";
}

void Add(const std::string& study, const std::vector<std::string>& sensors, const std::string& name,
         std::vector<Addition>& additions) {
  Addition delay{.mechanism = "delay", .elements = {name}};
  delay.words = "delay of " + name;
  delay.study = [=](double amount) {
    StudyEdit edit(study);
    const std::string value = FormatNumber(AtDigits(1e3 * amount, 4)) + " ms";
    return edit.CorrectChannels(sensors, "delay", value) ? edit.Text() : "";
  };
  delay.first = 1e-3;
  delay.least = -0.1;
  delay.greatest = 0.1;
  Addition scale{.mechanism = "scale", .elements = {name}};
  scale.words = "scale of " + name;
  scale.study = [=](double amount) {
    StudyEdit edit(study);
    const double factor = AtDigits(1 + amount, 5);
    if (!edit.CorrectChannels(sensors, "scale", FormatNumber(factor))) return std::string();
    // Else a channel would fit better the smaller it is.
    edit.ScaleNoise(sensors, factor);
    return edit.Text();
  };
  scale.first = 0.02;
  scale.least = -0.25;
  scale.greatest = 0.35;
  for (Addition* addition : {&delay, &scale}) additions.push_back(std::move(*addition));
}

}  // namespace

void AddChannelAdditions(const AdditionSource& source, const std::string& study, std::vector<Addition>& additions) {
  std::map<Sensor::Type, std::vector<std::string>> kinds;
  std::vector<std::string> all;
  for (const std::string& name : MeasuredSensors(study))
    for (const Sensor& sensor : source.vehicle().sensors)
      if (sensor.name == name) {
        kinds[sensor.type].push_back(name);
        all.push_back(name);
        Add(study, {name}, "'" + name + "'", additions);
      }
  for (const auto& [type, names] : kinds)
    if (names.size() > 1) Add(study, names, std::string("all ") + NounOf(type), additions);
  if (kinds.size() > 1) Add(study, all, "all channels", additions);
}

}  // namespace fourpost
