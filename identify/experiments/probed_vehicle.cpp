#include "identify/experiments/probed_vehicle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "vehicles/response/tyre_pull.h"

namespace fourpost {

using Eigen::Index;

ProbedVehicle::ProbedVehicle(Vehicle vehicle) : vehicle_(std::move(vehicle)) {
  vehicle_.sensors.clear();
  const auto add_strut = [&](const std::string& name, const ForceLine& line) {
    vehicle_.sensors.push_back({.name = name, .type = Sensor::Type::kStrut, .point = {}, .line = line, .wheelpan = {}});
  };
  for (const Damper& damper : vehicle_.dampers) add_strut(damper.name, damper.line);
  dampers_ = static_cast<Index>(vehicle_.sensors.size());
  for (const Spring& spring : vehicle_.springs)
    if (spring.kind != Spring::Kind::kGas) add_strut(spring.name, spring.line);
  springs_ = static_cast<Index>(vehicle_.sensors.size()) - dampers_;
  std::vector<std::size_t> tyres(vehicle_.tyres.size());
  std::iota(tyres.begin(), tyres.end(), 0);
  for (Sensor& sensor : ForceSensors(vehicle_, tyres)) vehicle_.sensors.push_back(std::move(sensor));
}

void ProbedVehicle::AddSteady(const FrequencyResponse& response, const CondensedModel& model,
                              CoveredRanges& ranges) const {
  for (std::size_t c = 0; c < response.channels.size(); ++c) {
    const ChannelResponse& channel = response.channels[c];
    const auto place = static_cast<Index>(c);
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      const double amplitude = std::abs(channel.response[i]) * response.amplitude_m[i];
      const double mean = i < channel.mean.size() ? channel.mean[i] : 0;
      if (place < dampers_) {
        const double speed = 2 * std::numbers::pi * response.frequency_Hz[i] * amplitude;
        ranges.Add(CoveredQuantity::kBumpSpeed, channel.name, 0, speed);
        ranges.Add(CoveredQuantity::kReboundSpeed, channel.name, 0, speed);
      } else if (place < dampers_ + springs_) {
        ranges.Add(CoveredQuantity::kSpringTravel, channel.name, mean - amplitude, mean + amplitude);
      } else {
        const auto tyre = static_cast<std::size_t>(place - dampers_ - springs_);
        const double load = model.preloads.tyre[tyre] + mean;
        ranges.Add(CoveredQuantity::kTyreLoad, vehicle_.tyres[tyre].name, load - amplitude, load + amplitude);
      }
    }
  }
}

void ProbedVehicle::AddMotion(const Eigen::MatrixXd& readings, double rate_Hz, const CondensedModel& model,
                              CoveredRanges& ranges) const {
  const Index last = readings.rows() - 2;
  if (last < 1) return;
  for (Index c = 0; c < readings.cols(); ++c) {
    const std::string& name = vehicle_.sensors[static_cast<std::size_t>(c)].name;
    if (c < dampers_) {
      const Eigen::VectorXd speed = rate_Hz / 2 * (readings.col(c).tail(last) - readings.col(c).head(last));
      ranges.Add(CoveredQuantity::kBumpSpeed, name, 0, std::max(0.0, -speed.minCoeff()));
      ranges.Add(CoveredQuantity::kReboundSpeed, name, 0, std::max(0.0, speed.maxCoeff()));
    } else if (c < dampers_ + springs_) {
      ranges.Add(CoveredQuantity::kSpringTravel, name, readings.col(c).minCoeff(), readings.col(c).maxCoeff());
    } else {
      const auto tyre = static_cast<std::size_t>(c - dampers_ - springs_);
      const double load = model.preloads.tyre[tyre];
      ranges.Add(CoveredQuantity::kTyreLoad, vehicle_.tyres[tyre].name, load + readings.col(c).minCoeff(),
                 load + readings.col(c).maxCoeff());
    }
  }
}

}  // namespace fourpost
