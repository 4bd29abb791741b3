#include "identify/experiments/four_post/station_lint.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <utility>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "analysis/text/found.h"
#include "analysis/text/short_number.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/real_factor.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

/// An accelerometer's place on its link, and what it measured at the low frequencies of all runs, over the gain of the
/// loudest of its body there.
struct Station {
  std::string name;
  Eigen::Vector3d place;
  std::vector<Complex> measured;
};

bool IsVertical(const Sensor& sensor) {
  constexpr double kUpright = 0.99;
  return sensor.type == Sensor::Type::kAccelerometer && sensor.point.link > 0 && sensor.axis.z() > kUpright;
}

/// Below this a body on its suspension moves as one piece.
constexpr double kRigidBelow_Hz = 1;

/// Vertical accelerometers of a link that every run has.
std::vector<Station> StationsOf(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs, int link) {
  std::vector<Station> stations;
  for (std::size_t s = 0; s < vehicle.sensors.size(); ++s) {
    const Sensor& sensor = vehicle.sensors[s];
    if (!IsVertical(sensor) || sensor.point.link != link) continue;
    Station station{.name = sensor.name, .place = sensor.point.xyz};
    for (const MeasuredRun& run : runs)
      for (const MeasuredChannel& channel : run.channels)
        for (std::size_t i = 0; channel.sensor == s && i < channel.response.size(); ++i)
          if (run.excitation.frequency_Hz[i] <= kRigidBelow_Hz) station.measured.push_back(channel.response[i]);
    stations.push_back(std::move(station));
  }
  std::size_t most = 0;
  for (const Station& station : stations) most = std::max(most, station.measured.size());
  std::erase_if(stations, [&](const Station& station) { return station.measured.size() < most || most == 0; });
  for (std::size_t i = 0; i < most; ++i) {
    double loudest = std::numeric_limits<double>::min();
    for (const Station& station : stations) loudest = std::max(loudest, std::abs(station.measured[i]));
    for (Station& station : stations) station.measured[i] /= loudest;
  }
  return stations;
}

/// Heave, and the slopes along and across the body, through all stations but one.
struct RigidMotion {
  /// 3 x samples; zero for a slope that the stations do not determine.
  Eigen::MatrixXcd motion;
  /// Root mean square of what the stations are off from it.
  double rms = 0;
  bool is_known = false;
};

RigidMotion MotionWithout(const std::vector<Station>& stations, std::size_t left_out) {
  const auto samples = static_cast<Eigen::Index>(stations.front().measured.size());
  const auto rows = static_cast<Eigen::Index>(stations.size()) - 1;
  Eigen::MatrixXd shape(rows, 3);
  Eigen::MatrixXcd measured(rows, samples);
  Eigen::Index row = 0;
  for (std::size_t s = 0; s < stations.size(); ++s) {
    if (s == left_out) continue;
    shape.row(row) << 1, stations[s].place.x(), stations[s].place.y();
    for (Eigen::Index i = 0; i < samples; ++i) measured(row, i) = stations[s].measured[static_cast<std::size_t>(i)];
    ++row;
  }
  // A centimetre is no spread.
  const LeastNorm solver(shape, 1e-2);
  const Eigen::MatrixXcd motion = solver.PseudoInverse().cast<Complex>() * measured;
  const double squares = (shape.cast<Complex>() * motion - measured).squaredNorm();
  return {.motion = motion,
          .rms = std::sqrt(squares / static_cast<double>(samples * std::max<Eigen::Index>(rows - solver.rank(), 1))),
          .is_known = rows > solver.rank()};
}

/// How far a station is from the motion of the others, and what would explain it.
struct Stray {
  std::size_t station = 0;
  double rms = 0;
  double others_rms = std::numeric_limits<double>::infinity();
  RigidMotion others;
};

Eigen::VectorXcd MeasuredAt(const Station& station) {
  return Eigen::Map<const Eigen::VectorXcd>(station.measured.data(),
                                            static_cast<Eigen::Index>(station.measured.size()));
}

Eigen::VectorXcd MotionAt(const RigidMotion& others, const Eigen::Vector3d& place) {
  const Eigen::RowVector3cd shape(Complex(1), Complex(place.x()), Complex(place.y()));
  return (shape * others.motion).transpose();
}

/// `words`: of the finding so far.
Found ExplanationOf(const Station& station, const RigidMotion& others, const ChannelWarnings& warnings,
                    std::vector<std::string> words) {
  constexpr double kMost = 0.9;
  const auto with = [&words](const Finding& kind, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    return Found{&kind, words};
  };
  const Eigen::VectorXcd measured = MeasuredAt(station);
  const Eigen::VectorXcd expected = MotionAt(others, station.place);
  const auto [factor, by_factor] = RealFactorOf(measured, expected);
  const auto [forward, by_forward] = RealFactorOf(measured - expected, others.motion.row(1).transpose());
  const auto [left, by_left] = RealFactorOf(measured - expected, others.motion.row(2).transpose());
  if (factor < 0 && by_factor > kMost) return with(kStationSign, {warnings.Turned(station.name)});
  if (by_forward > kMost && by_forward >= by_left)
    return with(kStationAlong, {ShortNumber(std::abs(forward), 2), forward > 0 ? "forward" : "back"});
  if (by_left > kMost)
    return with(kStationAlong, {ShortNumber(std::abs(left), 2), left > 0 ? "to the left" : "to the right"});
  if (by_factor > kMost) return with(kStationScale, {ShortNumber(factor, 2)});
  return with(kStationStray, {});
}

void LintBody(const std::vector<Station>& stations, ChannelWarnings& warnings) {
  // Sensors of a rig are good to some per cent, and bodies bend a little.
  constexpr double kNoticeable = 0.1;
  constexpr double kFarMoreThanOthers = 3;
  Stray stray;
  for (std::size_t s = 0; s < stations.size(); ++s) {
    RigidMotion others = MotionWithout(stations, s);
    if (!others.is_known || others.rms >= stray.others_rms) continue;
    const Eigen::VectorXcd measured = MeasuredAt(stations[s]);
    const double rms = std::sqrt((measured - MotionAt(others, stations[s].place)).squaredNorm() /
                                 static_cast<double>(measured.size()));
    stray = {s, rms, others.rms, std::move(others)};
  }
  if (stray.rms < kNoticeable || stray.rms < kFarMoreThanOthers * stray.others_rms) return;
  const Station& station = stations[stray.station];
  const Found found =
      ExplanationOf(station, stray.others, warnings,
                    {station.name, ShortNumber(100 * stray.rms, 2), ShortNumber(100 * stray.others_rms, 2)});
  warnings.Report(*found.kind, station.name, found.words);
}

}  // namespace

void LintStations(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs, ChannelWarnings& warnings) {
  for (std::size_t link = 1; link < vehicle.links.size(); ++link) {
    const std::vector<Station> stations = StationsOf(vehicle, runs, static_cast<int>(link));
    if (stations.size() > 2) LintBody(stations, warnings);
  }
}

}  // namespace fourpost
