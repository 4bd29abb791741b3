#include "identify/live/live_vehicle.h"

#include <limits>
#include <string>
#include <utility>

#include "identify/experiments/fit_balance.h"
#include "vehicles/response/hysteresis.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

std::vector<double> ValuesOf(const ReducedData& data) {
  std::vector<double> values;
  for (const Parameter& parameter : data.parameters) values.push_back(parameter.value);
  return values;
}

void Blank(double frequency_Hz, FrequencyResponse& response) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < response.frequency_Hz.size(); ++i) {
    if (response.frequency_Hz[i] != frequency_Hz) continue;
    for (ChannelResponse& channel : response.channels) {
      channel.response[i] = {kNone, kNone};
      channel.mean[i] = channel.second_harmonic[i] = kNone;
    }
  }
}

std::vector<Sensor> SensorsOf(const ReducedData& data) {
  std::vector<Sensor> sensors = data.sensors;
  for (int i = 0; i < data.coordinates; ++i)
    sensors.push_back({.name = "coordinate_" + std::to_string(i + 1), .type = Sensor::Type::kDisplacement});
  return sensors;
}

/// Adds rows of zeros, or of the identity.
void AddRows(Eigen::Index count, bool is_identity, Eigen::MatrixXd& rows) {
  const Eigen::Index first = rows.rows();
  rows.conservativeResize(first + count, Eigen::NoChange);
  if (is_identity) rows.bottomRows(count).setIdentity();
  else rows.bottomRows(count).setZero();
}

CondensedModel WithCoordinateRows(CondensedModel model) {
  const Eigen::Index n = model.mass.rows();
  AddRows(n, true, model.on_position);
  for (Eigen::MatrixXd* rows : {&model.on_velocity, &model.on_acceleration, &model.on_post_height,
                                &model.on_post_velocity, &model.on_post_acceleration})
    AddRows(n, false, *rows);
  return model;
}

}  // namespace

LiveVehicle::LiveVehicle(ReducedData data) : vehicle_(std::move(data)), sensors_(SensorsOf(vehicle_.data())) {
  Set(ValuesOf(vehicle_.data()));
}

void LiveVehicle::Set(std::span<const double> values) {
  model_ = WithCoordinateRows(vehicle_.At(values));
  values_.assign(values.begin(), values.end());
}

bool LiveVehicle::IsHysteretic() const { return HasHysteresis(model_); }

FrequencyResponse LiveVehicle::Response(const Excitation& excitation) const {
  if (IsHysteretic()) {
    excitation.Validate(data().posts.size());
    FrequencyResponse none = ResponseRecorder(sensors_, excitation).Take();
    for (const double frequency : excitation.frequency_Hz) Blank(frequency, none);
    return none;
  }
  PeriodicResponse found = SolveHarmonicBalance(model_, sensors_, excitation, kFitBalance);
  for (const double frequency : found.unconverged_Hz) Blank(frequency, found.response);
  return std::move(found.response);
}

std::vector<Mode> LiveVehicle::Modes() const { return ModesOf(model_); }

}  // namespace fourpost
