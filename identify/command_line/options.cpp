#include "identify/command_line/options.h"

#include <map>

namespace fourpost {
namespace {

/// An option that may be given several times, with one value each: a file that follows is none of them.
CLI::Option* AddList(CLI::App& subcommand, const char* name, std::vector<std::string>& values, const char* help) {
  return subcommand.add_option(name, values, help)->expected(1)->take_all();
}

/// Options that tell how the posts of a vehicle move, and what of it changes.
std::vector<CLI::Option*> AddSweep(CLI::App& subcommand, ResponseCommand& command) {
  SweepText& sweep = command.sweep;
  return {
      AddList(subcommand, "--mode", sweep.modes,
              "heave, pitch, roll, warp, or shares of posts such as FL=1,FR=-1; may be given several times")
          ->default_str("heave"),
      subcommand
          .add_option("--frequencies", sweep.frequencies,
                      "first:last:how many (0.5Hz:30Hz:40), first:last:step (1Hz:5Hz:0.5Hz) or a list (1Hz,2Hz)")
          ->capture_default_str(),
      subcommand.add_option("--amplitude", sweep.amplitude,
                            "Most the reference post moves, peak (12mm). The least of the three limits counts at each "
                            "frequency; without any: 12 mm, 0.15 m/s and 6 m/s^2"),
      subcommand.add_option("--velocity", sweep.velocity, "Most it may move at, peak (0.15m/s)"),
      subcommand.add_option("--acceleration", sweep.acceleration, "Most it may be accelerated, peak (6m/s^2)"),
      AddList(subcommand, "--channel", sweep.channels, "Sensor to tell of; may be given several times; without: all"),
      subcommand
          .add_option_function<std::string>(
              "--sweep", [&sweep](const std::string& way) { sweep.falling = way == "down"; },
              "Order of the frequencies: where several motions are possible, each follows the one before")
          ->check(CLI::IsMember({"up", "down"}))
          ->default_str("up"),
      AddList(subcommand, "--set", command.set, "name=value: another value of a parameter; may be given several times"),
  };
}

}  // namespace

void AddOptions(CLI::App& subcommand, ResponseCommand& command) {
  subcommand.add_option("MODEL", command.input, "Vehicle file (.urdf) or study (.yaml)")->required();
  const std::vector<CLI::Option*> of_vehicle = AddSweep(subcommand, command);
  subcommand
      .add_option_function<std::string>(
          "--engine",
          [&command](const std::string& name) {
            const std::map<std::string, Engine> engines = {{"auto", Engine::kAuto},
                                                           {"linearised", Engine::kLinearised},
                                                           {"full", Engine::kFull},
                                                           {"march", Engine::kMarch}};
            command.engine = engines.at(name);
          },
          "linearised: harmonic balance as in a fit (default of a study); full: on the full multibody system; march: "
          "integrate that to steady state (slow, the reference); auto: linearised, checked by full, which answers "
          "where "
          "they visibly differ (default of a vehicle)")
      ->check(CLI::IsMember({"auto", "linearised", "full", "march"}));
  subcommand.add_option("-o,--output", command.output, "Folder for response.csv, response.svg and result.json");
  subcommand.add_flag("--json", command.json, "Print JSON");
  subcommand.parse_complete_callback([&command, of_vehicle] {
    for (const CLI::Option* option : of_vehicle)
      if (option->count() > 0) command.vehicle_options.push_back(option->get_name());
  });
}

void AddOptions(CLI::App& subcommand, ModesCommand& command) {
  subcommand.add_option("MODEL", command.model, "Vehicle file (.urdf)")->required();
  AddList(subcommand, "--set", command.set, "name=value: another value of a parameter; may be given several times");
  AddList(subcommand, "--vary", command.vary,
          "name, from bound to bound, or name=first:last:how many (k=20kN/m:80kN/m:13): follow the poles while this "
          "parameter changes; may be given several times");
  subcommand.add_option("-o,--output", command.output, "Folder for poles.csv, a picture per parameter and result.json");
  subcommand.add_flag("--json", command.json, "Print JSON");
}

}  // namespace fourpost
