#include "vehicles/ride_metrics/ride_metrics.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace fourpost {
namespace {

class Names {
 public:
  void Add(std::string name, double value, const char* unit) {
    metrics_.push_back({.name = std::move(name), .value = value, .unit = unit});
  }
  std::vector<NamedMetric> Take() { return std::move(metrics_); }

 private:
  std::vector<NamedMetric> metrics_;
};

void AddComfort(const RideMetrics::Comfort& comfort, Names& names) {
  const std::string weighted = comfort.point + "." + std::string(WeightingName(comfort.weighting));
  names.Add(weighted, comfort.weighted.rms, "m/s^2");
  names.Add(comfort.point + ".mtvv", comfort.weighted.mtvv, "m/s^2");
  names.Add(comfort.point + ".vdv", comfort.weighted.vdv, "m/s^1.75");
  names.Add(comfort.point + ".rms", comfort.rms, "m/s^2");
  names.Add(comfort.point + ".primary", comfort.primary, "m/s^2");
  names.Add(comfort.point + ".secondary", comfort.secondary, "m/s^2");
}

void AddWheel(const RideMetrics::Wheel& wheel, Names& names) {
  names.Add(wheel.tyre + ".variation", wheel.Variation(), "1");
  names.Add(wheel.tyre + ".load_rms", wheel.rms_N, "N");
  names.Add(wheel.tyre + ".least_load", wheel.least_N, "N");
  names.Add(wheel.tyre + ".off_ground", wheel.off_ground, "1");
}

void AddStrut(const RideMetrics::Strut& strut, Names& names) {
  names.Add(strut.damper + ".travel", strut.travel_rms_m, "m");
  names.Add(strut.damper + ".bump", -strut.least_m, "m");
  names.Add(strut.damper + ".rebound", strut.most_m, "m");
  names.Add(strut.damper + ".speed", strut.speed_rms, "m/s");
  names.Add(strut.damper + ".speed_95", strut.speed_95, "m/s");
  names.Add(strut.damper + ".power", strut.power_W, "W");
}

void AddBody(const RideMetrics::Body& body, Names& names) {
  names.Add("body.heave", body.heave_rms, "m");
  names.Add("body.pitch", body.pitch_rms, "rad");
  names.Add("body.roll", body.roll_rms, "rad");
  names.Add("body.heave_acceleration", body.heave_acceleration, "m/s^2");
  names.Add("body.pitch_acceleration", body.pitch_acceleration, "rad/s^2");
  names.Add("body.roll_acceleration", body.roll_acceleration, "rad/s^2");
  names.Add("body.pitch_We", body.pitch_weighted, "rad/s^2");
  names.Add("body.roll_We", body.roll_weighted, "rad/s^2");
  names.Add("body.mean_heave", body.mean_heave, "m");
}

}  // namespace

std::vector<NamedMetric> NamedMetrics(const RideMetrics& metrics) {
  Names names;
  for (const RideMetrics::Comfort& comfort : metrics.comfort) AddComfort(comfort, names);
  for (const RideMetrics::Wheel& wheel : metrics.wheels) AddWheel(wheel, names);
  for (const RideMetrics::Axle& axle : metrics.axles) {
    names.Add(axle.name + ".variation", axle.variation, "1");
    if (axle.ride_height_rms) names.Add(axle.name + ".ride_height", *axle.ride_height_rms, "m");
  }
  names.Add("car.variation", metrics.variation, "1");
  names.Add("car.load_variance", metrics.load_variance, "N^2");
  for (const RideMetrics::Strut& strut : metrics.struts) AddStrut(strut, names);
  for (const RideMetrics::Stop& stop : metrics.stops) {
    const std::string side = stop.stop + (stop.is_bump ? ".bump_stop" : ".rebound_stop");
    names.Add(side + ".remaining", stop.left_m, "m");
    names.Add(side + ".contact", stop.contact, "1");
  }
  if (metrics.body) AddBody(*metrics.body, names);
  return names.Take();
}

void SumWheels(const RideInstruments& instruments, RideMetrics& metrics) {
  double all_static = 0;
  metrics.load_variance = 0;
  for (const RideMetrics::Wheel& wheel : metrics.wheels) {
    metrics.load_variance += wheel.rms_N * wheel.rms_N;
    all_static += wheel.static_N * wheel.static_N;
  }
  metrics.variation = std::sqrt(metrics.load_variance / all_static);
  for (std::size_t a = 0; a < metrics.axles.size(); ++a) {
    double variance = 0;
    double squared = 0;
    for (const std::size_t i : instruments.axles[a].tyres) {
      variance += metrics.wheels[i].rms_N * metrics.wheels[i].rms_N;
      squared += metrics.wheels[i].static_N * metrics.wheels[i].static_N;
    }
    metrics.axles[a].load_variance = variance;
    metrics.axles[a].variation = std::sqrt(variance / squared);
  }
}

}  // namespace fourpost
