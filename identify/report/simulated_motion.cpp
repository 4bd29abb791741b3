#include "identify/report/simulated_motion.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "analysis/signals/spectrum.h"
#include "identify/report/coordinate_sensors.h"
#include "vehicles/condensed/condensed_vehicle.h"

namespace fourpost {
namespace {

/// What a screen shows.
constexpr double kFrames_Hz = 60;
/// Two, and what a line between frames needs to keep half of an amplitude.
constexpr double kFramesPerPeriod = 3;
/// Where no frequency is known: three in a period of 80 Hz, beyond what cars do visibly.
constexpr double kFine_Hz = 240;
/// About a MB of a page.
constexpr double kMostNumbers = 200000;
/// Of each coordinate's rms: less than a picture shows.
constexpr double kError = 1e-2;

/// Above which a signal has less than that of its rms.
double HighestFrequency(const Eigen::VectorXd& values, double rate_Hz) {
  constexpr std::size_t kSegment = 512;
  const auto count = static_cast<std::size_t>(values.size());
  if (count < 4) return 0;
  const std::span<const double> signal(values.data(), count);
  const Spectrum spectrum = WelchSpectrum(signal, signal, rate_Hz, std::min(kSegment, count));
  double all = 0;
  for (const double power : spectrum.first) all += power;
  double above = 0;
  std::size_t k = spectrum.first.size() - 1;
  while (k > 0 && (above += spectrum.first[k]) < kError * kError * all) --k;
  return spectrum.frequency_Hz[k];
}

/// From one sample to the next that is shown.
Eigen::Index StrideOf(const TimeHistory& history) {
  double highest_Hz = 0;
  for (Eigen::Index c = 0; c < history.readings.cols(); ++c)
    highest_Hz = std::max(highest_Hz, HighestFrequency(history.readings.col(c), history.rate_Hz));
  const double wanted_Hz = std::max(kFrames_Hz, kFramesPerPeriod * highest_Hz);
  return std::max<Eigen::Index>(1, static_cast<Eigen::Index>(history.rate_Hz / wanted_Hz));
}

/// Every so many rows, as many as there may be.
Eigen::MatrixXd Every(Eigen::Index stride, const Eigen::MatrixXd& rows, Eigen::Index most) {
  const Eigen::Index count = std::min(most, (rows.rows() + stride - 1) / stride);
  return rows(Eigen::seqN(0, count, stride), Eigen::all);
}

}  // namespace

HistoryMotion SimulatedMotion(const Vehicle& vehicle, const PostMotion& posts, TimeGrid when, double upper_Hz) {
  const CondensedModel model = CondensedVehicle(vehicle).At(vehicle.ParameterValues());
  const double columns = static_cast<double>(model.mass.rows()) + static_cast<double>(vehicle.posts.size());
  const double least_Hz = std::max(kFrames_Hz, kFramesPerPeriod * upper_Hz);
  when.rate_Hz = upper_Hz > 0 ? least_Hz : kFine_Hz;
  when.end_s = std::min(when.end_s, when.start_s + kMostNumbers / (columns * least_Hz));
  RigView rig = RigViewOf(vehicle);
  rig.sensors = CoordinateSensors(model);
  TimeHistory history = SimulateCondensed(WithCoordinatesAsSensors(model), rig, posts, when, {.error = kError}).history;
  history.DropFirst(when.lead_count());
  const Eigen::Index stride = upper_Hz > 0 ? 1 : StrideOf(history);
  const auto most = static_cast<Eigen::Index>(kMostNumbers / columns);
  return {.start_s = history.start_s,
          .rate_Hz = history.rate_Hz / static_cast<double>(stride),
          .posts = Every(stride, history.posts, most),
          .coordinates = Every(stride, history.readings, most)};
}

}  // namespace fourpost
