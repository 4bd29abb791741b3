// Random dampers in a quarter car through every engine: damper_engines COUNT [SEED] > damper_engines.csv. Of friction,
// transition speed, series stiffness, gas and all dashpot laws; what the engines disagree by, and what they say of it.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <string>

#include "tests/vehicles/random_dampers.h"
#include "vehicles/engine/steady_response.h"
#include "vehicles/response/full_balance.h"
#include "vehicles/response/march.h"
#include "vehicles/simulation/multibody_system.h"
#include "vehicles/simulation/time_history.h"

namespace {

using namespace fourpost;

/// What a multibody run may take [s]: on a stiff mount Simbody's explicit integrator takes steps of microseconds.
constexpr double kPatience_s = 60;

double Seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Largest relative difference of a first harmonic.
double Off(const FrequencyResponse& response, const FrequencyResponse& reference) {
  double worst = 0;
  for (std::size_t c = 0; c < reference.channels.size(); ++c)
    for (std::size_t i = 0; i < reference.channels[c].response.size(); ++i) {
      const std::complex<double> expected = reference.channels[c].response[i];
      worst = std::max(worst, std::abs(response.channels[c].response[i] - expected) / std::abs(expected));
    }
  return worst;
}

struct Engines {
  explicit Engines(const Vehicle& v) : vehicle(v), model(CondensedVehicle(v).At(v.ParameterValues())) {}

  Multibody Full() const {
    Multibody multibody(vehicle);
    multibody.SetParameters(vehicle.ParameterValues(), model.preloads);
    return multibody;
  }

  const Vehicle& vehicle;
  CondensedModel model;
};

/// "frequencies unconverged by harmonic balance, by the full one, their largest differences from time integration"; the
/// last two empty where that takes too long.
std::string Responses(const Engines& engines) {
  const Excitation excitation{
      .frequency_Hz = {1.2, 3, 9, 16}, .amplitude_m = {0.012, 0.008, 0.0018, 0.0006}, .shape = {1}};
  const PeriodicResponse balance = SolveHarmonicBalance(engines.model, engines.vehicle.sensors, excitation, {});
  Multibody multibody = engines.Full();
  const PeriodicResponse full = SolveFullBalance(multibody, engines.model, excitation);
  std::string row =
      std::to_string(balance.unconverged_Hz.size()) + "," + std::to_string(full.unconverged_Hz.size()) + ",";
  const double began = Seconds();
  try {
    const MarchedResponse marched =
        March(multibody, excitation, {.stop = [began] { return Seconds() - began > kPatience_s; }});
    return row + NumberText(Off(balance.response, marched.response)) + "," +
           NumberText(Off(full.response, marched.response));
  } catch (const MarchStopped&) {
    return row + ",";
  }
}

/// Two sines that grow within half a second.
void Move(double t, std::span<PostState> posts) {
  PostState state;
  const bool grows = t < 0.5;
  const double angle = 2 * std::numbers::pi * t;
  const double share = grows ? 0.5 - 0.5 * std::cos(angle) : 1;
  const double share_rate = grows ? std::numbers::pi * std::sin(angle) : 0;
  const double share_bend = grows ? 2 * std::numbers::pi * std::numbers::pi * std::cos(angle) : 0;
  for (const auto& [amplitude, frequency] : {std::pair{0.01, 1.3}, {0.001, 7.0}}) {
    const double w = 2 * std::numbers::pi * frequency;
    const double z = amplitude * std::sin(w * t);
    const double v = amplitude * w * std::cos(w * t);
    state.height += share * z;
    state.velocity += share_rate * z + share * v;
    state.acceleration += share_bend * z + 2 * share_rate * v - share * w * w * z;
  }
  for (PostState& post : posts) post = state;
}

/// "change of the last halving of the step, largest difference from the multibody system's history".
std::string History(const Engines& engines) {
  const TimeGrid grid{.end_s = 3, .rate_Hz = 500};
  const CondensedHistory reduced = SimulateCondensed(engines.model, RigViewOf(engines.vehicle), Move, grid);
  Multibody multibody = engines.Full();
  MultibodySystem system(multibody, 1e-8);
  const double began = Seconds();
  const TimeHistory full = Simulate(system, Move, grid, [began](double) { return Seconds() - began < kPatience_s; });
  const std::string row = NumberText(reduced.change) + ",";
  if (full.size() < reduced.history.size()) return row;
  return row + NumberText(RelativeDifferences(reduced.history, full, engines.vehicle.sensors).maxCoeff());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("damper_engines COUNT [SEED] > damper_engines.csv\n", stderr);
    return 2;
  }
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  std::printf("# build/release/damper_engines %s %s\n", argv[1], std::to_string(seed).c_str());
  std::puts(
      "law,compression [N*s/m],rebound [N*s/m],friction [N],transition speed [m/s],series [N/m],cubic [N/m^3],"
      "gas [N/m],balance unconverged,full balance unconverged,balance off,full balance off,history stated,"
      "history off");
  for (int i = 0; i < std::atoi(argv[1]); ++i) {
    DamperDraw draw(seed, static_cast<std::uint64_t>(i));
    const Drawn drawn = DrawDamper(i, draw);
    const Vehicle vehicle = QuarterCarWith(drawn.elements);
    const Engines engines(vehicle);
    std::printf("%s,", drawn.row.c_str());
    std::printf("%s,", Responses(engines).c_str());
    std::printf("%s\n", History(engines).c_str());
    std::fflush(stdout);
  }
}
