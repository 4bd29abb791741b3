#include "identify/command_line/simulate_options.h"

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>

#include "analysis/text/units.h"
#include "identify/command_line/common_options.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/whole_number.h"
#include "vehicles/posts/road.h"
#include "vehicles/requests/option_quantity.h"

namespace fourpost {
namespace {

/// Adds options whose values carry units; what cannot be read joins the command's faults.
class QuantityOptions {
 public:
  QuantityOptions(CLI::App& app, SimulateCommand& command) : app_(app), faults_(command.faults) {}

  CLI::Option* Add(const char* name, const Dimension& dimension, const char* help, std::function<void(double)> take) {
    return app_.add_option_function<std::string>(
        name,
        [=, &faults = faults_](const std::string& text) {
          if (const std::optional<double> si = ReadQuantity(text, dimension, name, faults)) take(*si);
        },
        help);
  }

  CLI::Option* AddShare(const char* name, const char* help, double& share) {
    return app_.add_option_function<std::string>(
        name,
        [name, &share, &faults = faults_](const std::string& text) {
          share = ReadShare(text, name, faults).value_or(share);
        },
        help);
  }

 private:
  CLI::App& app_;
  Diagnostics& faults_;
};

/// The options of which one says what the posts do.
struct MotionOptions {
  CLI::Option* sweep;
  CLI::Option* sine;
  CLI::Option* step;
  CLI::Option* random;
  CLI::Option* road;
  CLI::Option* recording;
};

MotionOptions AddMotions(CLI::App& app, SimulateCommand& command) {
  using Motion = SimulateCommand::Motion;
  CLI::Option_group* group = app.add_option_group("Motion of the posts");
  const auto add = [&](const char* name, Motion motion, const char* help,
                       std::function<void(const std::string&)> take) {
    const auto set = [&command, motion, take](const std::string& text) {
      command.motion = motion;
      take(text);
    };
    return group->add_option_function<std::string>(name, set, help);
  };
  const auto band = [&command](const FrequencyRange& range) {
    command.first_Hz = range.first_Hz;
    command.last_Hz = range.last_Hz;
  };
  MotionOptions options;
  options.sweep = add("--sweep", Motion::kSweep, "Swept sine from one frequency to another, e.g. 0.5Hz:30Hz",
                      [&command, band](const std::string& text) {
                        if (const auto range = ReadFrequencyRange(text, "--sweep", command.faults)) band(*range);
                      });
  options.sine =
      add("--sine", Motion::kSine, "Sine of one frequency, e.g. 2Hz", [&command, band](const std::string& text) {
        if (const auto frequency = ReadQuantity(text, kFrequency, "--sine", command.faults))
          band({*frequency, *frequency});
      });
  options.step = add("--step", Motion::kStep, "Step of this height after 0.5 s, e.g. 20mm or -20mm",
                     [&command](const std::string& text) {
                       command.height_m =
                           ReadQuantity(text, kLength, "--step", command.faults, OptionSign::kAny).value_or(0);
                     });
  options.random =
      add("--random", Motion::kRandom, "Random heights of this rms with white velocity within --band, e.g. 4mm",
          [&command](const std::string& text) {
            command.height_m = ReadQuantity(text, kLength, "--random", command.faults).value_or(0);
          });
  options.road =
      add("--road", Motion::kRoad, "Random road of an ISO 8608 class, A to H, at --speed; the rear follows the front",
          [&command](const std::string& text) { command.road_class = text; });
  options.road->check(OneOf("--road", kRoadClasses));
  options.recording = add("--recording", Motion::kRecording,
                          "Recorded post heights, a CSV with names, units, a column of times and one for each post",
                          [&command](const std::string& text) { command.recording = text; });
  group->require_option(1);
  return options;
}

/// What belongs to some of the motions only.
void AddDetails(CLI::App& app, SimulateCommand& command, const MotionOptions& motions) {
  QuantityOptions options(app, command);
  const auto forbid = [](CLI::Option* option, std::initializer_list<CLI::Option*> others) {
    for (CLI::Option* other : others) option->excludes(other);
  };
  for (CLI::Option* limit : AddLimits(app, command.limits))
    forbid(limit, {motions.step, motions.random, motions.road, motions.recording});
  app.add_flag("--linear", command.linear_sweep, "Sweep linearly in hertz (default: in octaves)")->needs(motions.sweep);
  options
      .Add("--rise", kTime, "Rise time of a step (default 50ms)", [&command](double value) { command.rise_s = value; })
      ->needs(motions.step);
  CLI::Option* speed = options.Add("--speed", kVelocity, "Speed of the vehicle on a road, e.g. 60km/h",
                                   [&command](double value) { command.speed = value; });
  motions.road->needs(speed);
  speed->needs(motions.road);
  CLI::Option* band = app.add_option_function<std::string>(
      "--band",
      [&command](const std::string& text) {
        const auto range = ReadFrequencyRange(text, "--band", command.faults);
        if (!range) return;
        command.first_Hz = range->first_Hz;
        command.last_Hz = range->last_Hz;
        if (!(command.first_Hz < command.last_Hz))
          command.faults.Report(kBandNotRising, Place::Option("--band"), {text});
      },
      "Band of a random motion or road (default 0.5Hz:30Hz)");
  forbid(band, {motions.sweep, motions.sine, motions.step, motions.recording});
  forbid(app.add_option("--mode", command.mode, kModeHelp)->capture_default_str(), {motions.road, motions.recording});
  options.Add("--duration", kTime, "Length of the history (default: 60 s; step 5 s, sine 10 s, recording its own)",
              [&command](double value) { command.duration_s = value; });
  AddStroke(app, command.stroke);
}

void AddAcquisition(CLI::App& app, SimulateCommand& command) {
  QuantityOptions options(app, command);
  AddChannels(app, command.channels);
  options.Add("--rate", kFrequency, "Sampling rate (default 500Hz)",
              [&command](double value) { command.rate_Hz = value; });
  CLI::Option* filter =
      options.Add("--filter", kFrequency, "Cut-off frequency of a Butterworth low-pass on every channel",
                  [&command](double value) { command.filter_Hz = value; });
  app.add_option("--order", command.filter_order, "Order of the filter")
      ->check(CLI::Range(1, 16))
      ->capture_default_str()
      ->needs(filter);
  options.AddShare("--noise", "White noise on every channel, as a share of its standard deviation, e.g. 1%",
                   command.noise);
  app.add_option("--seed", command.seed, "Seed of random motions and noise")
      ->check(WholeNumber("--seed"))
      ->capture_default_str();
}

}  // namespace

void AddOptions(CLI::App& subcommand, SimulateCommand& command) {
  AddVehicle(subcommand, command.model);
  AddSettings(subcommand, command.set);
  AddDetails(subcommand, command, AddMotions(subcommand, command));
  AddAcquisition(subcommand, command);
  subcommand
      .add_option_function<std::string>(
          "--engine", [&command](const std::string& text) { command.engine = EngineNamed(text).value(); },
          "reduced: kinematics linearised about equilibrium with nonlinear force laws; full: the multibody system; "
          "auto: "
          "reduced, checked by full, which replaces it where they visibly differ")
      ->transform(EngineOf(kHistoryEngines))
      ->default_str("auto");
  QuantityOptions(subcommand, command)
      .AddShare("--error",
                "Largest change of a channel when the time step is halved, as a share of its rms (default 0.1%)",
                command.error);
  subcommand.add_option(
      "-o,--output", command.output,
      "Write the history here, as CSV, or by the ending as a universal file (.uff), RPC III (.rsp), or "
      "the posts alone as a drive file (.drv), and print a summary (default: CSV on stdout)");
  subcommand.add_option("--chart", command.chart, "Write a chart of the history here (.svg)");
  subcommand.add_flag("--json", command.json, "Print the summary as JSON instead of CSV or a table");
}

}  // namespace fourpost
