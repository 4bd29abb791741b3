#include "vehicles/response/motion_from_rest.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "vehicles/condensed/port.h"
#include "vehicles/response/march.h"
#include "vehicles/response/tyre_pull.h"
#include "vehicles/simulation/condensed_system.h"

namespace fourpost {
namespace {

constexpr double kOther = 0.05;
constexpr double kNode = 0.03;
/// Of the loudest of its unit.
constexpr double kSilent = 0.01;
/// Of a tyre's static load.
constexpr double kNear = 0.25;

std::optional<FrequencyResponse> FromRest(CondensedSystem& system, const Excitation& excitation) {
  try {
    // A window is as good an answer as any where the motion wanders.
    return March(system, excitation, {.tolerance = 1e-3, .longest_s = 20, .samples_per_cycle = 64}).response;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

double LargestGain(const ChannelResponse& channel) {
  double largest = 0;
  for (const std::complex<double>& value : channel.response)
    if (std::isfinite(std::abs(value))) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Of each unit the largest gain, and one at least: a unit may be silent as a whole.
std::map<std::string, double> LoudestOf(const FrequencyResponse& response) {
  std::map<std::string, double> loudest;
  for (const ChannelResponse& channel : response.channels)
    loudest[channel.unit] = std::max({1.0, loudest[channel.unit], LargestGain(channel)});
  return loudest;
}

/// That lift off, with the larger one of the rate at rest and the mean rate from there to lift-off, so that forces come
/// out too low whether a curve is progressive or not.
std::vector<CondensedModel::Liftoff> TyresAtRest(const CondensedModel& model) {
  std::vector<CondensedModel::Liftoff> tyres = model.liftoffs;
  for (const CondensedModel::CurvedTyre& tyre : model.curved_tyres)
    tyres.push_back({.direction = tyre.direction,
                     .post = tyre.post,
                     .preload = tyre.law.load,
                     .stiffness = std::max(tyre.law.Rate(0), -tyre.law.load / tyre.law.Liftoff()),
                     .damping = tyre.damping,
                     .load_cells = {}});
  return tyres;
}

}  // namespace

std::vector<bool> MayHaveSeveralMotions(const CondensedModel& model, const Excitation& excitation,
                                        const HarmonicBalanceOptions& options) {
  const std::vector<Port> ports = HeldPortsOf(model);
  const std::size_t count = excitation.frequency_Hz.size();
  // The motion under friction that sticks forgets how it began.
  if (std::any_of(ports.begin(), ports.end(), [](const Port& port) {
        return UsesExtension(port.law) && !std::holds_alternative<FrictionRemainder>(port.law) &&
               !std::holds_alternative<TyreRemainder>(port.law);
      }))
    return std::vector<bool>(count, true);
  std::vector<bool> several(count, false);
  const std::vector<CondensedModel::Liftoff> tyres = TyresAtRest(model);
  if (tyres.empty()) return several;
  const Eigen::MatrixXd least = LeastTyreForces(model, tyres, excitation, options);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < tyres.size(); ++k)
      if (least(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) < kNear * tyres[k].preload)
        several[i] = true;
  return several;
}

std::vector<OtherMotion> OtherMotionsFromRest(const CondensedModel& model, const Vehicle& vehicle,
                                              const Excitation& excitation, const std::vector<bool>& looked_at,
                                              const FrequencyResponse& found,
                                              const std::function<void(std::size_t done)>& progress) {
  CondensedSystem system(model, RigViewOf(vehicle));
  const std::map<std::string, double> loudest = LoudestOf(found);
  std::vector<OtherMotion> others;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    if (progress) progress(i);
    if (!looked_at[i]) continue;
    const Excitation one{{excitation.frequency_Hz[i]}, {excitation.amplitude_m[i]}, excitation.shape};
    const std::optional<FrequencyResponse> run = FromRest(system, one);
    if (!run) continue;
    OtherMotion other{.frequency_Hz = one.frequency_Hz[0]};
    for (std::size_t c = 0; c < found.channels.size(); ++c) {
      const std::complex<double> value = found.channels[c].response[i];
      const double largest = LargestGain(found.channels[c]);
      // Silent by symmetry.
      if (!(largest > kSilent * loudest.at(found.channels[c].unit))) continue;
      const double size = std::max(std::abs(value), kNode * largest);
      const double difference = std::abs(run->channels[c].response[0] - value) / size;
      if (difference > other.difference) other = {other.frequency_Hz, found.channels[c].name, difference};
    }
    if (other.difference > kOther) others.push_back(other);
  }
  return others;
}

}  // namespace fourpost
