// Random dampers in a quarter car through every engine: damper_engines COUNT [SEED] > damper_engines.csv. Of friction,
// transition speed, series stiffness, gas and all dashpot laws; what the engines disagree by, and what they say of it.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <string>

#include "analysis/random_stream.h"
#include "vehicles/engine/steady_response.h"
#include "vehicles/reader/vehicle_file.h"
#include "vehicles/response/full_balance.h"
#include "vehicles/response/march.h"
#include "vehicles/simulation/multibody_system.h"
#include "vehicles/simulation/time_history.h"

namespace {

using namespace fourpost;

/// What a multibody run may take [s]: on a stiff mount Simbody's explicit integrator takes steps of microseconds.
constexpr double kPatience_s = 60;

class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t number) : stream_(seed, "damper engines", number) {}
  double Log(double lower, double upper) { return lower * std::pow(upper / lower, stream_.Uniform()); }
  bool Often(double share) { return stream_.Uniform() < share; }

 private:
  RandomStream stream_;
};

std::string Text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

struct Drawn {
  std::string row;
  std::string elements;
};

std::string LawElement(int law, double compression, double rebound) {
  const std::string rates = " compression=\"" + Text(compression) + " N*s/m\" rebound=\"" + Text(rebound) + " N*s/m\"";
  switch (law) {
    case 0: return "<linear rate=\"" + Text(compression) + " N*s/m\"/>";
    case 1: return "<bilinear" + rates + "/>";
    case 2: return "<smooth" + rates + " speed=\"30 mm/s\"/>";
    case 3:
      return "<digressive" + rates + " compression_knee=\"0.08 m/s\" compression_beyond=\"" + Text(0.4 * compression) +
             " N*s/m\" rebound_knee=\"0.1 m/s\" rebound_beyond=\"" + Text(0.4 * rebound) + " N*s/m\"/>";
  }
  std::string points;
  for (const auto& [speed, share] : {std::pair{-0.4, -0.3}, {-0.1, -0.1}, {0.1, 0.1}, {0.4, 0.3}})
    points += "<point speed=\"" + Text(speed) + " m/s\" force=\"" + Text(share * (speed < 0 ? compression : rebound)) +
              " N\"/>";
  return "<table>" + points + "</table>";
}

Drawn DrawDamper(int number, Draw& draw) {
  const int law = number % 5;
  const double compression = draw.Log(100, 3000);
  const double rebound = compression * draw.Log(0.3, 6);
  const double friction = draw.Often(0.2) ? 0 : draw.Log(5, 400);
  const double speed = draw.Log(5e-4, 2e-2);
  const double stiffness = draw.Often(0.2) ? 0 : draw.Log(1e5, 1e8);
  const double cubic = draw.Often(0.3) ? stiffness * draw.Log(1e3, 1e6) : 0;
  const double gas = draw.Often(0.3) ? 2000 : 0;
  std::string elements = LawElement(law, compression, rebound);
  if (friction > 0) elements += "<friction force=\"" + Text(friction) + " N\" speed=\"" + Text(speed) + " m/s\"/>";
  if (stiffness > 0)
    elements += "<series stiffness=\"" + Text(stiffness) + " N/m\" cubic=\"" + Text(cubic) + " N/m^3\"/>";
  if (gas > 0) elements += "<gas force=\"100 N\" stiffness=\"" + Text(gas) + " N/m\"/>";
  constexpr const char* kLaws[] = {"linear", "bilinear", "smooth", "digressive", "table"};
  std::string row = kLaws[law];
  for (const double value : {compression, rebound, friction, speed, stiffness, cubic, gas}) row += "," + Text(value);
  return {std::move(row), std::move(elements)};
}

Vehicle QuarterCar(const std::string& damper) {
  const auto body = [](const std::string& name, const std::string& mass, const std::string& height) {
    return "<link name=\"" + name + "\"><inertial><mass value=\"" + mass +
           "\"/><inertia ixx=\"0\" iyy=\"0\" izz=\"0\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link><joint "
           "name=\"" +
           name + "_travel\" type=\"prismatic\"><parent link=\"ground\"/><child link=\"" + name +
           "\"/><origin xyz=\"0 0 " + height +
           "\"/><axis xyz=\"0 0 1\"/><limit lower=\"-0.2\" upper=\"0.2\" effort=\"0\" velocity=\"0\"/></joint>";
  };
  const std::string text =
      R"(<robot name="quarter" xmlns:fp="urn:fourpost:vehicle:1"><link name="ground"/>)" + body("wheel", "38", "0.3") +
      body("body", "285", "0.7") +
      R"(<fp:spring name="spring" parent="body" child="wheel"><linear stiffness="15 N/mm"/></fp:spring>
<fp:damper name="damper" parent="body" child="wheel">)" +
      damper + R"(</fp:damper>
<fp:tyre name="tyre" link="wheel" xyz="0 0 -0.3" stiffness="250 N/mm" damping="200 N*s/m"/><fp:post name="post" under="tyre"/>
<fp:sensor name="a_body" type="accelerometer" link="body" xyz="0 0 0"/>
<fp:sensor name="a_wheel" type="accelerometer" link="wheel" xyz="0 0 0"/>
<fp:sensor name="s_strut" type="strut" parent="body" child="wheel"/>
<fp:sensor name="F_tyre" type="load_cell" tyre="tyre"/></robot>)";
  Diagnostics diagnostics;
  std::optional<Vehicle> vehicle = ReadVehicleText(text, "quarter.urdf", diagnostics);
  if (!vehicle) throw FaultyInput(diagnostics);
  return std::move(*vehicle);
}

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
    return row + Text(Off(balance.response, marched.response)) + "," + Text(Off(full.response, marched.response));
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
  const std::string row = Text(reduced.change) + ",";
  if (full.size() < reduced.history.size()) return row;
  return row + Text(Differences(reduced.history, full, engines.vehicle.sensors).maxCoeff());
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
    Draw draw(seed, static_cast<std::uint64_t>(i));
    const Drawn drawn = DrawDamper(i, draw);
    const Vehicle vehicle = QuarterCar(drawn.elements);
    const Engines engines(vehicle);
    std::printf("%s,", drawn.row.c_str());
    std::printf("%s,", Responses(engines).c_str());
    std::printf("%s\n", History(engines).c_str());
    std::fflush(stdout);
  }
}
