#include "identify/experiments/four_post/four_post_residuals.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/process/deadline.h"
#include "analysis/process/thread_time.h"
#include "analysis/signals/decibel.h"
#include "analysis/text/text_table.h"
#include "identify/experiments/four_post/coarse_runs.h"
#include "identify/experiments/four_post/findings.h"
#include "identify/experiments/four_post/modelled_response.h"
#include "identify/residuals/calibrated_sensor.h"
#include "identify/residuals/sensor_group.h"
#include "identify/search/parallel.h"
#include "vehicles/condensed/model_change.h"
#include "vehicles/multibody/simulation_error.h"
#include "vehicles/response/balance_sensitivity.h"
#include "vehicles/response/hysteresis.h"

namespace fourpost {
namespace {

/// Second harmonics of a channel that are compared.
std::size_t SecondHarmonics(const MeasuredChannel& channel, const ModelError& model_error) {
  return model_error.second_harmonic_m > 0 ? channel.second_harmonic.size() : 0;
}

Eigen::Index CountOf(const std::vector<MeasuredRun>& runs, const ModelError& model_error) {
  std::size_t count = 0;
  for (const MeasuredRun& run : runs)
    for (const MeasuredChannel& channel : run.channels)
      count += 2 * channel.response.size() + channel.mean.size() + SecondHarmonics(channel, model_error);
  return static_cast<Eigen::Index>(count);
}

/// Place of each run's first residual.
std::vector<Eigen::Index> FirstsOf(const std::vector<MeasuredRun>& runs, const ModelError& model_error) {
  std::vector<Eigen::Index> firsts;
  Eigen::Index first = 0;
  for (const MeasuredRun& run : runs) {
    firsts.push_back(first);
    first += CountOf({run}, model_error);
  }
  return firsts;
}

/// "1 .. 2 Hz", counted from the lowest frequency of all runs.
std::string OctaveName(double frequency_Hz, double lowest_Hz) {
  // A frequency on the border belongs to the octave above, whatever the last digit.
  const double lower = lowest_Hz * std::exp2(std::floor(std::log2(frequency_Hz / lowest_Hz) + 1e-9));
  return Rounded(lower, 2) + " .. " + Rounded(2 * lower, 2) + " Hz";
}

double LowestFrequency(const std::vector<MeasuredRun>& runs) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const MeasuredRun& run : runs)
    for (const double frequency : run.excitation.frequency_Hz) lowest = std::min(lowest, frequency);
  return lowest;
}

/// In the order of AddRun().
ResidualStructure StructureOf(const Vehicle& vehicle, const std::vector<MeasuredRun>& runs,
                              const ModelError& model_error) {
  ResidualPartition groups = {"sensor groups", {}, {}};
  ResidualPartition octaves = {"octaves", {}, {}};
  ResidualStructure structure;
  const double lowest = LowestFrequency(runs);
  Eigen::Index next = 0;
  // `each`: residuals of a frequency.
  const auto add = [&](const MeasuredRun& run, const MeasuredChannel& channel, std::size_t count, Eigen::Index each) {
    const auto frequencies = static_cast<Eigen::Index>(count);
    groups.Add(SensorGroup(vehicle, channel.sensor), each * frequencies);
    structure.recordings.Add(run.name, each * frequencies);
    for (std::size_t i = 0; i < count; ++i) octaves.Add(OctaveName(run.excitation.frequency_Hz[i], lowest), each);
    for (Eigen::Index part = 0; part < each; ++part)
      structure.series.push_back({.first = next + part, .count = frequencies, .step = each});
    next += each * frequencies;
  };
  for (const MeasuredRun& run : runs)
    for (const MeasuredChannel& channel : run.channels) {
      add(run, channel, channel.response.size(), 2);
      add(run, channel, channel.mean.size(), 1);
      add(run, channel, SecondHarmonics(channel, model_error), 1);
    }
  structure.partitions = {std::move(groups), std::move(octaves)};
  return structure;
}

/// Largest gain of all channels of this unit at a frequency.
double Loudest(const MeasuredRun& run, const std::string& unit, std::size_t frequency) {
  double loudest = 0;
  for (const MeasuredChannel& channel : run.channels)
    if (channel.unit == unit) loudest = std::max(loudest, std::abs(channel.response[frequency]));
  return loudest;
}

/// What each response of a channel is compared by: error times `turn`, over the deviations.
struct Scale {
  std::complex<double> turn;
  double radial_sd = 0;
  double tangential_sd = 0;
};

Scale ScaleOf(const MeasuredRun& run, const MeasuredChannel& channel, const ModelError& model_error, std::size_t i) {
  const double gain = std::abs(channel.response[i]);
  const double gain_error = GainFromDecibel(model_error.gain_dB) - 1;
  const double floor = model_error.floor * Loudest(run, channel.unit, i);
  return {.turn = std::conj(channel.response[i]) / gain,
          .radial_sd = std::hypot(channel.radial_sd[i], gain * gain_error, floor),
          .tangential_sd = std::hypot(channel.tangential_sd[i], gain * model_error.phase_rad, floor)};
}

double MeanDeviation(const MeasuredChannel& channel, const ModelError& model_error, std::size_t i) {
  return channel.mean_sd.empty() ? model_error.mean_m : std::hypot(channel.mean_sd[i], model_error.mean_m);
}

/// Along and across the measured phasor.
Eigen::Vector2d WhitenedError(const MeasuredRun& run, const MeasuredChannel& channel, const FrequencyResponse& modelled,
                              const ModelError& model_error, std::size_t i) {
  const Scale scale = ScaleOf(run, channel, model_error, i);
  const std::complex<double> error = (modelled.channels[channel.sensor].response[i] - channel.response[i]) * scale.turn;
  return {error.real() / scale.radial_sd, error.imag() / scale.tangential_sd};
}

void AddRun(const MeasuredRun& run, const FrequencyResponse& modelled, const ModelError& model_error, double*& out) {
  for (const MeasuredChannel& channel : run.channels) {
    const ChannelResponse& model = modelled.channels[channel.sensor];
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      const Eigen::Vector2d error = WhitenedError(run, channel, modelled, model_error, i);
      *out++ = error.x();
      *out++ = error.y();
    }
    for (std::size_t i = 0; i < channel.mean.size(); ++i)
      *out++ = (model.mean[i] - channel.mean[i]) / MeanDeviation(channel, model_error, i);
    for (std::size_t i = 0; i < SecondHarmonics(channel, model_error); ++i)
      *out++ = (model.second_harmonic[i] - channel.second_harmonic[i]) / model_error.second_harmonic_m;
  }
}

/// One column of the Jacobian.
void AddSlopes(const MeasuredRun& run, const FrequencyResponse& slopes, const ModelError& model_error, double*& out) {
  for (const MeasuredChannel& channel : run.channels) {
    const ChannelResponse& slope = slopes.channels[channel.sensor];
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      const Scale scale = ScaleOf(run, channel, model_error, i);
      const std::complex<double> change = slope.response[i] * scale.turn;
      *out++ = change.real() / scale.radial_sd;
      *out++ = change.imag() / scale.tangential_sd;
    }
    for (std::size_t i = 0; i < channel.mean.size(); ++i)
      *out++ = slope.mean[i] / MeanDeviation(channel, model_error, i);
    for (std::size_t i = 0; i < SecondHarmonics(channel, model_error); ++i)
      *out++ = slope.second_harmonic[i] / model_error.second_harmonic_m;
  }
}

/// Of a run by each change of the model, in columns from `first` on.
void AddChanges(const CondensedVehicle& vehicle, const CondensedModel& model, const std::vector<ModelChange>& changes,
                const MeasuredRun& run, const ModelError& model_error, Eigen::Index first, Eigen::MatrixXd& out) {
  const ResponseSensitivity sensitivity = SolveBalanceSensitivity(vehicle, model, changes, run.excitation, kFitBalance);
  if (!sensitivity.periodic.unconverged_Hz.empty()) throw SimulationError(kSineNotPeriodic, {run.name});
  for (std::size_t p = 0; p < changes.size(); ++p) {
    double* to = out.col(static_cast<Eigen::Index>(p)).data() + first;
    AddSlopes(run, sensitivity.by_change[p], model_error, to);
  }
}

Eigen::MatrixXd ByChanges(const CondensedVehicle& vehicle, const CondensedModel& model,
                          const std::vector<ModelChange>& changes, const std::vector<MeasuredRun>& runs,
                          Eigen::Index count, const ModelError& model_error) {
  Eigen::MatrixXd by_changes(count, std::ssize(changes));
  const std::vector<Eigen::Index> firsts = FirstsOf(runs, model_error);
  ForEachOnIdleThreads(runs.size(), [&](std::size_t r) {
    AddChanges(vehicle, model, changes, runs[r], model_error, firsts[r], by_changes);
  });
  return by_changes;
}

Eigen::MatrixXd Differentiate(const CondensedVehicle& vehicle, const std::vector<MeasuredRun>& runs, Eigen::Index count,
                              const ModelError& model_error, const std::vector<double>& values,
                              const std::vector<std::size_t>& parameters) {
  const ModelChanges of(vehicle, values);
  std::vector<ModelChange> changes;
  for (const std::size_t parameter : parameters) changes.push_back(of.By(parameter));
  return ByChanges(vehicle, of.model(), changes, runs, count, model_error);
}

/// See ResidualBlock::toward.
Eigen::MatrixXd Toward(const CondensedVehicle& vehicle, const std::vector<MeasuredRun>& runs, Eigen::Index count,
                       const ModelError& model_error, const std::vector<double>& values,
                       std::span<const OtherVehicle> others) {
  const ModelChanges of(vehicle, values);
  std::vector<ModelChange> changes;
  std::vector<Eigen::Index> columns;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const CondensedModel other = others[i].vehicle->At(others[i].values);
    std::optional<ModelChange> change = of.To(other);
    if (!change || HasHysteresis(other)) continue;
    changes.push_back(*std::move(change));
    columns.push_back(static_cast<Eigen::Index>(i));
  }
  Eigen::MatrixXd toward =
      Eigen::MatrixXd::Constant(count, std::ssize(others), std::numeric_limits<double>::quiet_NaN());
  toward(Eigen::all, columns) = ByChanges(vehicle, of.model(), changes, runs, count, model_error);
  return toward;
}

Evaluation Evaluate(const CondensedVehicle& vehicle, const std::vector<MeasuredRun>& runs, Eigen::Index count,
                    const ModelError& model_error, const std::vector<double>& values, const Deadline& deadline,
                    bool integrates = true, KnownAnswers* answers = nullptr) {
  const CondensedModel model = vehicle.At(values);
  Evaluation evaluation;
  evaluation.residuals.resize(count);
  const std::vector<Eigen::Index> firsts = FirstsOf(runs, model_error);
  std::vector<double> unconverged_Hz(runs.size());
  // The runs before it are evaluated whatever the threads do, so that it is always the same one.
  std::atomic<std::size_t> failed = runs.size();
  SharedDeadline shared(deadline);
  const auto evaluate = [&](std::size_t r) {
    if (r > failed) return;
    const MeasuredRun& run = runs[r];
    const double began_s = ThreadTime_s();
    const auto solve = [&] {
      return ModelledResponse(model, vehicle.vehicle().sensors, run.excitation, shared.Begin(), integrates);
    };
    const PeriodicResponse modelled = answers ? answers->Of(values, run.excitation, solve) : solve();
    shared.End(began_s);
    if (!modelled.unconverged_Hz.empty()) {
      unconverged_Hz[r] = modelled.unconverged_Hz[0];
      for (std::size_t before = failed; r < before && !failed.compare_exchange_weak(before, r);) {
      }
      return;
    }
    double* out = evaluation.residuals.data() + firsts[r];
    AddRun(run, modelled.response, model_error, out);
  };
  ForEachOnIdleThreads(runs.size(), evaluate);
  if (failed < runs.size())
    return Failed(Failure::kNotConverged, "no periodic response at " + std::to_string(unconverged_Hz[failed]) +
                                              " Hz of '" + runs[failed].name + "'");
  return evaluation;
}

/// By what one standard deviation would change what is read, at frequencies in rad/s.
void CalibrateChannel(const Calibration& calibration, const std::vector<double>& frequency_Hz, double delay_sign,
                      ChannelResponse& channel) {
  const bool is_gain = calibration.kind == Calibration::Kind::kGain;
  for (std::size_t i = 0; i < channel.response.size(); ++i)
    channel.response[i] *=
        is_gain ? calibration.sd
                : std::complex<double>(0, delay_sign * 2 * std::numbers::pi * frequency_Hz[i] * calibration.sd);
  for (double& mean : channel.mean) mean *= is_gain ? calibration.sd : 0;
  for (double& second : channel.second_harmonic) second *= is_gain ? calibration.sd : 0;
}

/// Change of the response where the posts move by one standard deviation more than recorded: ratios to the recorded
/// motion and the response to the larger one both change.
FrequencyResponse ByPostGain(const CondensedVehicle& vehicle, const CondensedModel& model, const MeasuredRun& run,
                             double sd, const FrequencyResponse& here) {
  Excitation larger = run.excitation;
  for (double& amplitude : larger.amplitude_m) amplitude *= 1 + sd;
  FrequencyResponse there = ModelledResponse(model, vehicle.vehicle().sensors, larger, {}).response;
  for (std::size_t c = 0; c < there.channels.size(); ++c) {
    ChannelResponse& channel = there.channels[c];
    for (std::size_t i = 0; i < channel.response.size(); ++i)
      channel.response[i] = (1 + sd) * channel.response[i] - here.channels[c].response[i];
    for (std::size_t i = 0; i < channel.mean.size(); ++i) channel.mean[i] -= here.channels[c].mean[i];
    for (std::size_t i = 0; i < channel.second_harmonic.size(); ++i)
      channel.second_harmonic[i] -= here.channels[c].second_harmonic[i];
  }
  return there;
}

FrequencyResponse ByCalibration(const CondensedVehicle& vehicle, const CondensedModel& model, const MeasuredRun& run,
                                const Calibration& calibration, const FrequencyResponse& here) {
  const bool is_gain = calibration.kind == Calibration::Kind::kGain;
  if (calibration.IsOfPosts() && is_gain) return ByPostGain(vehicle, model, run, calibration.sd, here);
  FrequencyResponse change = here;
  Calibration none = calibration;
  none.sd = 0;
  for (std::size_t sensor = 0; sensor < change.channels.size(); ++sensor) {
    // A late reading of the posts makes all channels early.
    const bool is_of = calibration.IsOfPosts() || IsOf(calibration, vehicle.vehicle(), sensor);
    CalibrateChannel(is_of ? calibration : none, run.excitation.frequency_Hz, calibration.IsOfPosts() ? 1 : -1,
                     change.channels[sensor]);
  }
  return change;
}

/// What one standard deviation of each calibration would change.
Eigen::MatrixXd ByCalibrations(const CondensedVehicle& vehicle, const std::vector<MeasuredRun>& runs,
                               Eigen::Index count, const ModelError& model_error,
                               const std::vector<Calibration>& calibrations, const std::vector<double>& values) {
  const CondensedModel model = vehicle.At(values);
  Eigen::MatrixXd changes(count, std::ssize(calibrations));
  Eigen::Index first = 0;
  for (const MeasuredRun& run : runs) {
    const FrequencyResponse here = ModelledResponse(model, vehicle.vehicle().sensors, run.excitation, {}).response;
    for (std::size_t c = 0; c < calibrations.size(); ++c) {
      double* out = changes.col(static_cast<Eigen::Index>(c)).data() + first;
      AddSlopes(run, ByCalibration(vehicle, model, run, calibrations[c], here), model_error, out);
    }
    first += CountOf({run}, model_error);
  }
  return changes;
}

ResidualBlock BlockOf(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredRun> runs,
                      const ModelError& model_error, bool integrates, std::shared_ptr<KnownAnswers> answers = nullptr) {
  const Eigen::Index count = CountOf(runs, model_error);
  ResidualStructure structure = StructureOf(vehicle->vehicle(), runs, model_error);
  // Integrated in time: to the tolerance of March(), without derivatives of the model's own.
  if (HasHysteresis(vehicle->At(vehicle->vehicle().ParameterValues())))
    return {.name = "four-post responses",
            .count = count,
            .accuracy = 1e-4,
            .evaluate =
                [vehicle, runs, count, model_error](const std::vector<double>& values, const Deadline& deadline) {
                  return Evaluate(*vehicle, runs, count, model_error, values, deadline);
                },
            .structure = std::move(structure)};
  return {
      .name = "four-post responses",
      .count = count,
      // What the balance's iteration leaves: 3e-7 of a response in the mean, some 1e-6 at the most.
      .accuracy = kFitBalance.tolerance,
      .evaluate =
          [vehicle, runs, count, model_error, integrates, answers](const std::vector<double>& values,
                                                                   const Deadline& deadline) {
            return Evaluate(*vehicle, runs, count, model_error, values, deadline, integrates, answers.get());
          },
      .differentiate =
          [vehicle, runs, count, model_error](const std::vector<double>& values,
                                              const std::vector<std::size_t>& parameters) {
            return Differentiate(*vehicle, runs, count, model_error, values, parameters);
          },
      .toward =
          [vehicle, runs, count, model_error](const std::vector<double>& values, std::span<const OtherVehicle> others) {
            return Toward(*vehicle, runs, count, model_error, values, others);
          },
      .structure = std::move(structure)};
}

}  // namespace

ResidualBlock FourPostResiduals(std::shared_ptr<const CondensedVehicle> vehicle, std::vector<MeasuredRun> runs,
                                const ModelError& model_error, const std::vector<Calibration>& calibrations,
                                bool integrates, std::shared_ptr<KnownAnswers> answers) {
  ResidualBlock block = BlockOf(vehicle, runs, model_error, integrates, std::move(answers));
  if (std::optional<std::vector<MeasuredRun>> coarse = CoarseRuns(runs))
    block.coarse = std::make_shared<const ResidualBlock>(BlockOf(vehicle, *std::move(coarse), model_error, integrates));
  if (!calibrations.empty())
    block.by_calibrations = [vehicle, runs, count = block.count, model_error,
                             calibrations](const std::vector<double>& values) {
      return ByCalibrations(*vehicle, runs, count, model_error, calibrations, values);
    };
  return block;
}

double SquaredDeviation(const MeasuredRun& run, const MeasuredChannel& channel, const FrequencyResponse& modelled,
                        const ModelError& model_error, std::size_t i) {
  return WhitenedError(run, channel, modelled, model_error, i).squaredNorm();
}

std::vector<double> ResponseDeviations(const MeasuredRun& run, const FrequencyResponse& modelled,
                                       const ModelError& model_error) {
  std::vector<double> deviations;
  for (const MeasuredChannel& channel : run.channels) {
    double squares = 0;
    double count = 0;
    for (std::size_t i = 0; i < channel.response.size(); ++i) {
      const double square = SquaredDeviation(run, channel, modelled, model_error, i);
      if (!std::isfinite(square)) continue;
      squares += square;
      count += 2;
    }
    deviations.push_back(std::sqrt(squares / count));
  }
  return deviations;
}

}  // namespace fourpost
