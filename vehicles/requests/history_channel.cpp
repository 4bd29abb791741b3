#include "vehicles/requests/history_channel.h"

#include <cmath>

#include "vehicles/response/response_recorder.h"

namespace fourpost {

std::vector<HistoryChannel> ChannelsOf(const Vehicle& vehicle, const TimeHistory& history,
                                       const std::vector<std::size_t>& sensors) {
  std::vector<HistoryChannel> channels;
  for (std::size_t p = 0; p < vehicle.posts.size(); ++p)
    channels.push_back({"post_" + vehicle.posts[p].name, "m", history.posts.col(static_cast<Eigen::Index>(p))});
  for (const std::size_t i : sensors)
    channels.push_back(
        {vehicle.sensors[i].name, UnitOf(vehicle.sensors[i].type), history.readings.col(static_cast<Eigen::Index>(i))});
  return channels;
}

Extent ExtentOf(const Eigen::VectorXd& values) {
  // Of what swings about zero a sum leaves rounding.
  constexpr double kRounding = 1e-12;
  const double rms = std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
  const double mean = values.mean();
  return {.mean = std::abs(mean) > kRounding * rms ? mean : 0,
          .rms = rms,
          .peak = values.cwiseAbs().maxCoeff(),
          .peak_to_peak = values.maxCoeff() - values.minCoeff()};
}

}  // namespace fourpost
