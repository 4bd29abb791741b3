#include "identify/recording_lint.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/QR>

#include "analysis/number.h"
#include "identify/modelled_response.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

std::string Shown(double value, const std::string& unit) {
  const double scale = std::pow(10, 1 - std::floor(std::log10(std::abs(value))));
  return FormatNumber(std::round(value * scale) / scale) + " " + unit;
}

/// Warnings about a channel stand at its line of the study.
class ChannelWarnings {
 public:
  ChannelWarnings(const Study& study, Diagnostics& diagnostics) : study_(study), diagnostics_(diagnostics) {}

  void Add(const std::string& channel, const std::string& message) {
    const auto source = std::find_if(study_.channels.begin(), study_.channels.end(),
                                     [&](const auto& entry) { return entry.first == channel; });
    const int line = source == study_.channels.end() ? 0 : source->second.line;
    diagnostics_.Warning(study_.file.string(), line, "'" + channel + "' " + message);
  }

 private:
  const Study& study_;
  Diagnostics& diagnostics_;
};

// Rigid bodies.

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
std::vector<Station> StationsOf(const LoadedStudy& study, int link) {
  std::vector<Station> stations;
  for (std::size_t s = 0; s < study.vehicle.sensors.size(); ++s) {
    const Sensor& sensor = study.vehicle.sensors[s];
    if (!IsVertical(sensor) || sensor.point.link != link) continue;
    Station station{.name = sensor.name, .place = sensor.point.xyz};
    for (const MeasuredRun& run : study.data.runs)
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
  /// 3 x samples; zero for a slope that the stations cannot tell.
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
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-2);
  solver.compute(shape);
  const Eigen::MatrixXcd motion = solver.pseudoInverse().cast<Complex>() * measured;
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

/// The real factor that brings `x` nearest to `y`, and the share of y's squares that it explains.
std::pair<double, double> Explained(const Eigen::VectorXcd& y, const Eigen::VectorXcd& x) {
  const double factor = x.dot(y).real() / std::max(x.squaredNorm(), std::numeric_limits<double>::min());
  return {factor, 1 - (y - factor * x).squaredNorm() / y.squaredNorm()};
}

std::string ExplanationOf(const Station& station, const RigidMotion& others) {
  constexpr double kMost = 0.9;
  const Eigen::VectorXcd measured = MeasuredAt(station);
  const Eigen::VectorXcd expected = MotionAt(others, station.place);
  const auto [factor, by_factor] = Explained(measured, expected);
  const auto [forward, by_forward] = Explained(measured - expected, others.motion.row(1).transpose());
  const auto [left, by_left] = Explained(measured - expected, others.motion.row(2).transpose());
  if (factor < 0 && by_factor > kMost) return "its sign is opposite: turn it round";
  if (by_forward > kMost && by_forward >= by_left)
    return "it moves as if it sat " + Shown(std::abs(forward), "m") + " further " + (forward > 0 ? "forward" : "back") +
           ": check its station in the vehicle file";
  if (by_left > kMost)
    return "it moves as if it sat " + Shown(std::abs(left), "m") + " further to the " + (left > 0 ? "left" : "right") +
           ": check its station in the vehicle file";
  if (by_factor > kMost) return "it reads " + Shown(factor, "times what it should") + ": check its scale";
  return "check its station in the vehicle file, its sign, its scale, and whether it is that channel";
}

void LintBody(const std::vector<Station>& stations, ChannelWarnings& warnings) {
  // Sensors of a rig are good to some per cent, and bodies bend a little.
  constexpr double kFarOff = 0.1;
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
  if (stray.rms < kFarOff || stray.rms < kFarMoreThanOthers * stray.others_rms) return;
  const Station& station = stations[stray.station];
  warnings.Add(station.name, "does not move with its body below 1 Hz, as the other accelerometers there do (off by " +
                                 Shown(100 * stray.rms, "% of the loudest, they by ") +
                                 Shown(100 * stray.others_rms, "%): ") + ExplanationOf(station, stray.others));
}

void LintBodies(const LoadedStudy& study, ChannelWarnings& warnings) {
  for (std::size_t link = 1; link < study.vehicle.links.size(); ++link) {
    const std::vector<Station> stations = StationsOf(study, static_cast<int>(link));
    if (stations.size() > 2) LintBody(stations, warnings);
  }
}

// Signs.

/// Measured and modelled, each frequency of each run that is in the band.
struct Pair {
  Eigen::VectorXcd measured;
  Eigen::VectorXcd modelled;
};

Pair Gather(const std::vector<MeasuredRun>& runs, const std::vector<FrequencyResponse>& modelled, std::size_t sensor) {
  std::vector<Complex> measured;
  std::vector<Complex> model;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const MeasuredChannel& channel : runs[r].channels)
      for (std::size_t i = 0; channel.sensor == sensor && i < channel.response.size(); ++i) {
        const Complex value = modelled[r].channels[sensor].response[i];
        if (!std::isfinite(value.real())) continue;
        measured.push_back(channel.response[i]);
        model.push_back(value);
      }
  const auto count = static_cast<Eigen::Index>(measured.size());
  return {Eigen::Map<Eigen::VectorXcd>(measured.data(), count), Eigen::Map<Eigen::VectorXcd>(model.data(), count)};
}

void LintSigns(const LoadedStudy& study, const std::vector<MeasuredRun>& runs,
               const std::vector<FrequencyResponse>& modelled, ChannelWarnings& warnings) {
  // A vehicle file is a guess: rates and masses off by a third leave 0.7 and more of a correlation.
  constexpr double kOpposite = -0.4;
  for (std::size_t s = 0; s < study.vehicle.sensors.size(); ++s) {
    const auto [measured, model] = Gather(runs, modelled, s);
    if (measured.size() == 0 || model.squaredNorm() == 0) continue;
    const double correlation = model.dot(measured).real() / (model.norm() * measured.norm());
    if (correlation < kOpposite)
      warnings.Add(study.vehicle.sensors[s].name,
                   "moves against what the vehicle would do (correlation " +
                       FormatNumber(std::round(100 * correlation) / 100) +
                       "): its sign is opposite; the formats want up, extension and more load positive");
  }
}

// Wheelpans.

/// Share of the reference post's motion that the post under this tyre makes.
double ShareUnder(const Vehicle& vehicle, int tyre, const Excitation& excitation) {
  for (std::size_t p = 0; p < vehicle.posts.size(); ++p)
    if (vehicle.posts[p].tyre == tyre) return excitation.shape[p];
  return 0;
}

/// Force of the difference that grows with the post's acceleration, as a mass.
struct ExtraMass {
  double kg = 0;
  /// Of the squares that a wrong rate leaves over, the share that the mass explains.
  double explained = 0;
};

/// Where the modelled gain of this sensor is the largest, the body's modes aside [Hz].
double PeakOf(const LoadedStudy& study, const std::vector<FrequencyResponse>& modelled, std::size_t s) {
  constexpr double kBeyondTheBody_Hz = 4;
  double largest = 0;
  double peak_Hz = kBeyondTheBody_Hz;
  for (std::size_t r = 0; r < study.data.runs.size(); ++r) {
    const std::vector<double>& frequencies = study.data.runs[r].excitation.frequency_Hz;
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
      const double gain = std::abs(modelled[r].channels[s].response[i]);
      if (frequencies[i] < kBeyondTheBody_Hz || !(gain > largest)) continue;
      largest = gain;
      peak_Hz = frequencies[i];
    }
  }
  return peak_Hz;
}

ExtraMass ExtraMassOf(const LoadedStudy& study, const std::vector<FrequencyResponse>& modelled, std::size_t s) {
  // Beyond the hop of the wheel, of which a vehicle file may be off, a tyre's force is that of its rate and little
  // else.
  const double from_Hz = 1.3 * PeakOf(study, modelled, s);
  std::vector<Complex> difference;
  std::vector<Complex> force;
  std::vector<Complex> acceleration;
  for (std::size_t r = 0; r < study.data.runs.size(); ++r) {
    const MeasuredRun& run = study.data.runs[r];
    const double share = ShareUnder(study.vehicle, study.vehicle.sensors[s].tyre, run.excitation);
    for (const MeasuredChannel& channel : run.channels)
      for (std::size_t i = 0; channel.sensor == s && i < channel.response.size(); ++i) {
        const double f = run.excitation.frequency_Hz[i];
        const Complex model = modelled[r].channels[s].response[i];
        if (f < from_Hz || !std::isfinite(model.real())) continue;
        difference.push_back(channel.response[i] - model);
        force.push_back(model);
        acceleration.push_back(-std::pow(2 * std::numbers::pi * f, 2) * share);
      }
  }
  const auto count = static_cast<Eigen::Index>(difference.size());
  if (count < 4) return {};
  const Eigen::Map<const Eigen::VectorXcd> y(difference.data(), count);
  const Eigen::Map<const Eigen::VectorXcd> f(force.data(), count);
  const Eigen::Map<const Eigen::VectorXcd> a(acceleration.data(), count);
  // What a tyre rate that is off would leave, of any phase, goes out of both first.
  const double squares = std::max(f.squaredNorm(), std::numeric_limits<double>::min());
  const Eigen::VectorXcd left = y - f * (f.dot(y) / squares);
  const Eigen::VectorXcd mass = a - f * (f.dot(a) / squares);
  const auto [kg, explained] = Explained(left, mass);
  return {kg, explained};
}

void LintWheelpans(const LoadedStudy& study, const std::vector<FrequencyResponse>& modelled,
                   ChannelWarnings& warnings) {
  constexpr double kLight_kg = 4;
  constexpr double kMost = 0.7;
  for (std::size_t s = 0; s < study.vehicle.sensors.size(); ++s) {
    const Sensor& sensor = study.vehicle.sensors[s];
    if (sensor.type != Sensor::Type::kLoadCell) continue;
    const ExtraMass extra = ExtraMassOf(study, modelled, s);
    if (std::abs(extra.kg) < kLight_kg || extra.explained < kMost) continue;
    warnings.Add(sensor.name, extra.kg > 0
                                  ? "feels the inertia of some " + Shown(extra.kg, "kg") +
                                        " that move with the post: give its load cell that wheelpan in the vehicle "
                                        "file, or take the inertia out of the recording"
                                  : "lacks the inertia of some " + Shown(-extra.kg, "kg") +
                                        " of the wheelpan that its load cell has in the vehicle file: leave the "
                                        "wheelpan out there when it is out of the recording");
  }
}

// Weights.

/// Weight on the tyres that were weighed [N], masses at this end of their bounds.
double WeightAt(const LoadedStudy& study, const CondensedVehicle& condensed, bool at_upper) {
  std::vector<double> values = study.vehicle.ParameterValues();
  for (const std::size_t index : study.free) {
    const Parameter& parameter = study.vehicle.parameters[index];
    if (parameter.dimension == kMass) values[index] = at_upper ? parameter.upper : parameter.lower;
  }
  const Preloads preloads = condensed.PreloadsAt(values);
  double weight = 0;
  for (const MeasuredLoad& load : study.data.static_loads) weight += preloads.tyre[load.tyre];
  return weight;
}

void LintWeights(const LoadedStudy& study, const CondensedVehicle& condensed, Diagnostics& diagnostics) {
  constexpr double kDeviations = 3;
  if (study.data.static_loads.empty()) return;
  double measured = 0;
  double sd = 0;
  for (const MeasuredLoad& load : study.data.static_loads) {
    measured += load.load_N;
    sd = std::hypot(sd, load.sd_N);
  }
  const double lightest = WeightAt(study, condensed, false);
  const double heaviest = WeightAt(study, condensed, true);
  if (measured > lightest - kDeviations * sd && measured < heaviest + kDeviations * sd) return;
  const bool is_heavy = measured > heaviest;
  const double beyond = (is_heavy ? measured - heaviest : lightest - measured) / kGravity;
  diagnostics.Warning(
      study.study.static_loads_file->string(), 0,
      "the static loads add up to " + Shown(measured / 1000, "kN") + ", the vehicle with all masses at their " +
          (is_heavy ? "upper" : "lower") + " bounds to " + Shown((is_heavy ? heaviest : lightest) / 1000, "kN") + ", " +
          Shown(beyond, "kg") + (is_heavy ? " less" : " more") + ": " +
          (is_heavy ? "load cells not tared, wheelpans or a load weighed along" : "corners or axles left out") +
          ", or bounds of masses that leave the answer out");
}

}  // namespace

void LintRecordings(const LoadedStudy& study, Diagnostics& diagnostics) {
  if (study.data.runs.empty() && study.data.static_loads.empty()) return;
  ChannelWarnings warnings(study.study, diagnostics);
  const CondensedVehicle condensed(study.vehicle);
  LintWeights(study, condensed, diagnostics);
  LintBodies(study, warnings);
  const CondensedModel model = condensed.At(study.vehicle.ParameterValues());
  const std::vector<FrequencyResponse> modelled = ModelledResponses(model, study.vehicle.sensors, study.data.runs);
  LintWheelpans(study, modelled, warnings);
  const std::vector<MeasuredRun> runs = InBand(study.data.runs, study.study.band_lower_Hz, study.study.band_upper_Hz);
  LintSigns(study, runs, ModelledResponses(model, study.vehicle.sensors, runs), warnings);
}

}  // namespace fourpost
