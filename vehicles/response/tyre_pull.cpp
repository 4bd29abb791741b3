#include "vehicles/response/tyre_pull.h"

#include <algorithm>

#include "analysis/text/count_check.h"
#include "analysis/text/short_number.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/response/contact_cycle.h"
#include "vehicles/response/findings.h"

namespace fourpost {
namespace {

/// Less is rounding.
constexpr double kLeast_N = 1e-3;

void Note(std::size_t tyre, const Eigen::VectorXd& forces, std::vector<TyrePull>& pulls) {
  const auto count = static_cast<std::size_t>((forces.array() < -kLeast_N).count());
  if (count == 0) return;
  pulls.push_back(
      {.tyre = tyre, .count = count, .of = static_cast<std::size_t>(forces.size()), .pull_N = -forces.minCoeff()});
}

/// Of these tyres, whether they lift off or not.
std::vector<CondensedModel::Liftoff> LawsOf(const Vehicle& vehicle, std::span<const double> values,
                                            const std::vector<std::size_t>& tyres) {
  Vehicle watched = vehicle;
  for (Tyre& tyre : watched.tyres) tyre.lifts_off = false;
  for (const std::size_t i : tyres) watched.tyres[i].lifts_off = true;
  return CondensedVehicle(watched).At(values).liftoffs;
}

}  // namespace

std::vector<std::size_t> LinearTyres(const Vehicle& vehicle) {
  std::vector<std::size_t> tyres;
  for (std::size_t i = 0; i < vehicle.tyres.size(); ++i)
    if (!vehicle.tyres[i].lifts_off) tyres.push_back(i);
  return tyres;
}

std::vector<Sensor> ForceSensors(const Vehicle& vehicle, const std::vector<std::size_t>& tyres) {
  std::vector<Sensor> sensors;
  for (const std::size_t i : tyres)
    sensors.push_back({.name = "force of " + vehicle.tyres[i].name,
                       .type = Sensor::Type::kLoadCell,
                       .line = {},
                       .tyre = static_cast<int>(i)});
  return sensors;
}

std::vector<TyrePull> FindTyrePulls(const Vehicle& vehicle, const std::vector<double>& preloads,
                                    const Eigen::MatrixXd& forces) {
  const std::vector<std::size_t> tyres = LinearTyres(vehicle);
  RequireCount("FindTyrePulls: forces", "tyres that do not lift off", tyres.size(),
               static_cast<std::size_t>(forces.cols()));
  std::vector<TyrePull> pulls;
  for (std::size_t k = 0; k < tyres.size() && forces.rows() > 0; ++k)
    Note(tyres[k], forces.col(static_cast<Eigen::Index>(k)).array() + preloads[tyres[k]], pulls);
  return pulls;
}

std::vector<TyrePull> FindTyrePulls(const Vehicle& vehicle, std::span<const double> values,
                                    const Excitation& excitation, const HarmonicBalanceOptions& options) {
  const std::vector<std::size_t> tyres = LinearTyres(vehicle);
  if (tyres.empty() || excitation.frequency_Hz.empty()) return {};
  const Eigen::MatrixXd forces =
      LeastTyreForces(CondensedVehicle(vehicle).At(values), LawsOf(vehicle, values, tyres), excitation, options);
  std::vector<TyrePull> pulls;
  for (std::size_t k = 0; k < tyres.size(); ++k) Note(tyres[k], forces.col(static_cast<Eigen::Index>(k)), pulls);
  return pulls;
}

Eigen::MatrixXd LeastTyreForces(const CondensedModel& model, const std::vector<CondensedModel::Liftoff>& tyres,
                                const Excitation& excitation, const HarmonicBalanceOptions& options) {
  Eigen::MatrixXd least(excitation.frequency_Hz.size(), tyres.size());
  ContactCycle cycle(model, excitation.shape, options);
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    options.deadline.Check();
    cycle.Solve(excitation.frequency_Hz[i], excitation.amplitude_m[i]);
    const TyreContact contact(tyres, cycle.cycle());
    const std::vector<double> forces = contact.LeastForces(contact.Squeezes());
    for (std::size_t k = 0; k < forces.size(); ++k)
      least(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = forces[k];
  }
  return least;
}

void WarnOfPulls(const Vehicle& vehicle, const std::vector<TyrePull>& pulls, const std::string& samples,
                 const std::string& motion, Diagnostics& findings) {
  for (const TyrePull& pull : pulls) {
    const Tyre& tyre = vehicle.tyres[pull.tyre];
    findings.Report(kTyrePulls, {vehicle.file, tyre.source_line},
                    {tyre.name, std::to_string(pull.count), std::to_string(pull.of), samples, motion,
                     ShortNumber(-pull.pull_N, 4) + " N"});
  }
}

}  // namespace fourpost
