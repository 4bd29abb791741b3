#include "identify/experiments/time_history/kalman_noise_json.h"

#include <vector>

#include "identify/study_file/result_reader.h"

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
  const nlohmann::json json = ReadResultFile(result);
  if (!json.is_object() || !json.contains("kalman_noise")) return std::nullopt;
  const nlohmann::json& list = json["kalman_noise"];
  if (!list.is_array() || list.empty()) return std::nullopt;
  const nlohmann::json& told = list.front();
  try {
    const auto process = told.at("process_sd").get<std::vector<double>>();
    KalmanNoise noise;
    noise.process_sd = Eigen::Map<const Eigen::VectorXd>(process.data(), static_cast<Eigen::Index>(process.size()));
    noise.sensor_sd.resize(static_cast<Eigen::Index>(history.signals.size()));
    for (std::size_t i = 0; i < history.signals.size(); ++i)
      noise.sensor_sd[static_cast<Eigen::Index>(i)] = told.at("sensor_sd").at(history.signals[i].name).get<double>();
    return noise;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace fourpost
