#include "identify/plan/run_readings.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "analysis/signals/decibel.h"
#include "analysis/text/text_table.h"
#include "identify/experiments/fit_balance.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Rows of a PossibleRun one after the other.
class Readings {
 public:
  /// `slopes`: of the parameters, by which rows per SI unit become rows per variable.
  explicit Readings(const Eigen::VectorXd& slopes) : slopes_(slopes) {}

  void Add(const Eigen::RowVectorXd& row, double noise, double floor) {
    rows_.push_back(row.cwiseProduct(slopes_.transpose()));
    noise_.push_back(noise * noise);
    floor_.push_back(floor * floor);
  }

  PossibleRun Run(double cost_s, int most_repeats) const {
    PossibleRun run{.cost_s = cost_s, .most_repeats = most_repeats};
    run.slopes.resize(std::ssize(rows_), slopes_.size());
    for (std::size_t i = 0; i < rows_.size(); ++i) run.slopes.row(static_cast<Index>(i)) = rows_[i];
    run.noise = Eigen::Map<const Eigen::VectorXd>(noise_.data(), std::ssize(noise_));
    run.floor = Eigen::Map<const Eigen::VectorXd>(floor_.data(), std::ssize(floor_));
    return run;
  }

 private:
  const Eigen::VectorXd& slopes_;
  std::vector<Eigen::RowVectorXd> rows_;
  std::vector<double> noise_;
  std::vector<double> floor_;
};

/// Largest gain of what is read in this unit.
double Loudest(const std::vector<ChannelResponse>& channels, const std::vector<bool>& is_read, const std::string& unit,
               std::size_t frequency) {
  double loudest = 0;
  for (std::size_t s = 0; s < channels.size(); ++s)
    if (is_read[s] && channels[s].unit == unit) loudest = std::max(loudest, std::abs(channels[s].response[frequency]));
  return loudest;
}

}  // namespace

AnsweredRun AnswerTo(const RigRun& run, const CondensedVehicle& car, const KnownParameters& parameters) {
  AnsweredRun answer;
  for (const double frequency : run.frequency_Hz) answer.amplitude_m.push_back(run.amplitude.At(frequency));
  try {
    answer.sensitivity = SolveBalanceSensitivity(car, car.vehicle().ParameterValues(), parameters.places,
                                                 {run.frequency_Hz, answer.amplitude_m, run.shape}, kFitBalance);
    if (!answer.sensitivity.periodic.unconverged_Hz.empty())
      answer.failure =
          "the car has no steady motion at " + Rounded(answer.sensitivity.periodic.unconverged_Hz.front(), 3) + " Hz";
  } catch (const std::runtime_error& error) {
    answer.failure = error.what();
  } catch (const std::invalid_argument& error) {
    answer.failure = error.what();
  }
  return answer;
}

Eigen::VectorXd LargestAmplitudes(const Vehicle& vehicle, const RigFile& rig, const std::vector<AnsweredRun>& answers) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(static_cast<Index>(vehicle.sensors.size()));
  for (std::size_t r = 0; r < answers.size(); ++r) {
    if (!answers[r].failure.empty()) continue;
    const FrequencyResponse& response = answers[r].sensitivity.periodic.response;
    for (std::size_t s = 0; s < vehicle.sensors.size(); ++s)
      for (std::size_t f = 0; f < response.frequency_Hz.size(); ++f) {
        const double reference = answers[r].amplitude_m[f] *
                                 std::abs(ReferencePerMetre(vehicle.sensors[s].type, rig.runs[r].frequency_Hz[f]));
        double& most = largest[static_cast<Index>(s)];
        most = std::max(most, std::abs(response.channels[s].response[f]) * reference);
      }
  }
  return largest;
}

PossibleRun ReadingsOf(const RigRun& run, const AnsweredRun& answer, const Vehicle& vehicle, const RigFile& rig,
                       const KnownParameters& parameters) {
  const ResponseSensitivity& sensitivity = answer.sensitivity;
  const std::vector<ChannelResponse>& channels = sensitivity.periodic.response.channels;
  const auto p = static_cast<Index>(parameters.places.size());
  const double gain_error = GainFromDecibel(rig.model_error.gain_dB) - 1;
  Readings readings(parameters.slopes);
  for (std::size_t s = 0; s < vehicle.sensors.size(); ++s) {
    if (!rig.is_read[s]) continue;
    for (std::size_t f = 0; f < run.frequency_Hz.size(); ++f) {
      const std::complex<double> phasor = channels[s].response[f];
      const double gain = std::abs(phasor);
      if (!(gain > 0)) continue;
      const double noise = rig.noise[s] / (answer.amplitude_m[f] *
                                           std::abs(ReferencePerMetre(vehicle.sensors[s].type, run.frequency_Hz[f])));
      const double floor = rig.model_error.floor * Loudest(channels, rig.is_read, channels[s].unit, f);
      Eigen::RowVectorXd along(p);
      Eigen::RowVectorXd across(p);
      Eigen::RowVectorXd mean(p);
      for (Index j = 0; j < p; ++j) {
        const ChannelResponse& slope = sensitivity.by_change[static_cast<std::size_t>(j)].channels[s];
        const std::complex<double> turned = slope.response[f] * std::conj(phasor) / gain;
        along[j] = turned.real();
        across[j] = turned.imag();
        mean[j] = slope.mean[f];
      }
      readings.Add(along, noise, std::hypot(gain * gain_error, floor));
      readings.Add(across, noise, std::hypot(gain * rig.model_error.phase_rad, floor));
      if (vehicle.sensors[s].type == Sensor::Type::kStrut) readings.Add(mean, rig.noise[s], rig.model_error.mean_m);
    }
  }
  return readings.Run(rig.TimeOf(run), rig.most_repeats);
}

PossibleRun ReadingsOf(const DirectMeasurement& measurement, const Vehicle& vehicle,
                       const KnownParameters& parameters) {
  const auto p = static_cast<Index>(parameters.places.size());
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(p);
  for (Index j = 0; j < p; ++j)
    if (vehicle.parameters[parameters.places[static_cast<std::size_t>(j)]].name == measurement.parameter) row[j] = 1;
  Readings readings(parameters.slopes);
  readings.Add(row, measurement.sd, 0);
  return readings.Run(measurement.time_s, 1);
}

}  // namespace fourpost
