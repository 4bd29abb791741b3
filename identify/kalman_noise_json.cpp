#include "identify/kalman_noise_json.h"

#include <fstream>
#include <vector>

namespace fourpost {

using Json = nlohmann::ordered_json;

Json KalmanNoiseJson(const MeasuredHistory& history, const KalmanNoise& noise) {
  Json sensors = Json::object();
  for (std::size_t i = 0; i < history.signals.size(); ++i)
    sensors[history.signals[i].name] = noise.sensor_sd[static_cast<Eigen::Index>(i)];
  return {{"recording", history.name},
          {"process_sd", std::vector<double>(noise.process_sd.begin(), noise.process_sd.end())},
          {"sensor_sd", sensors}};
}

std::optional<KalmanNoise> ReadKalmanNoise(const std::filesystem::path& result, const MeasuredHistory& history) {
  std::ifstream file(result);
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("kalman_noise") || json["kalman_noise"].empty()) return std::nullopt;
  const Json& told = json["kalman_noise"][0];
  try {
    const auto process = told.at("process_sd").get<std::vector<double>>();
    KalmanNoise noise;
    noise.process_sd = Eigen::Map<const Eigen::VectorXd>(process.data(), static_cast<Eigen::Index>(process.size()));
    noise.sensor_sd.resize(static_cast<Eigen::Index>(history.signals.size()));
    for (std::size_t i = 0; i < history.signals.size(); ++i)
      noise.sensor_sd[static_cast<Eigen::Index>(i)] = told.at("sensor_sd").at(history.signals[i].name).get<double>();
    return noise;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace fourpost
