#include "identify/report/simulated_motion.h"

#include <algorithm>

#include "identify/report/coordinate_sensors.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {
namespace {

/// What a screen shows, and some hundred kB of a page.
constexpr double kFrames_Hz = 60;
constexpr double kMostNumbers = 60000;
/// Of each coordinate's rms: less than a picture shows.
constexpr double kError = 1e-2;

}  // namespace

HistoryMotion SimulatedMotion(const Vehicle& vehicle, const PostMotion& posts, TimeGrid when) {
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const double columns = static_cast<double>(model.mass.rows()) + static_cast<double>(vehicle.posts.size());
  when.rate_Hz = std::min(kFrames_Hz, kMostNumbers / (columns * (when.end_s - when.start_s)));
  RigView rig = RigViewOf(vehicle);
  rig.sensors = CoordinateSensors(model);
  TimeHistory history = SimulateCondensed(WithCoordinatesAsSensors(model), rig, posts, when, {.error = kError}).history;
  history.DropFirst(when.lead_count());
  return {.start_s = history.start_s,
          .rate_Hz = history.rate_Hz,
          .posts = std::move(history.posts),
          .coordinates = std::move(history.readings)};
}

}  // namespace fourpost
