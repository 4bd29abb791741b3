#include "identify/command_line/motion_options.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

#include "identify/command_line/common_options.h"
#include "identify/command_line/findings.h"
#include "vehicles/posts/road_tracks.h"
#include "vehicles/requests/option_quantity.h"

namespace fourpost {
namespace {

constexpr const char* kSpeedHelp = "Speed of the vehicle on a road, e.g. 60km/h";

void Couple(CLI::Option* road, CLI::Option* speed) {
  road->needs(speed);
  speed->needs(road);
}

}  // namespace

CLI::Option* QuantityOptions::Add(const char* name, const Dimension& dimension, const char* help,
                                  std::function<void(double)> take) {
  return app_.add_option_function<std::string>(
      name,
      [=, take = std::move(take), &faults = faults_](const std::string& text) {
        if (const std::optional<double> si = ReadQuantity(text, dimension, name, faults)) take(*si);
      },
      help);
}

CLI::Option* QuantityOptions::AddShare(const char* name, const char* help, double& share) {
  return app_.add_option_function<std::string>(
      name,
      [name, &share, &faults = faults_](const std::string& text) {
        share = ReadShare(text, name, faults).value_or(share);
      },
      help);
}

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
  MotionOptions options{};
  options.group = group;
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
  options.recording = add("--recording", Motion::kRecording,
                          "Recorded post heights, a CSV with names, units, a column of times and one for each post",
                          [&command](const std::string& text) { command.recording = text; });
  group->require_option(1);
  return options;
}

void AddRoad(const MotionOptions& motions, CLI::App& app, SimulateCommand& command) {
  CLI::Option* road = motions.group->add_option_function<std::string>(
      "--road",
      [&command](const std::string& text) {
        command.motion = SimulateCommand::Motion::kRoad;
        command.road_class = text;
      },
      "Random road of an ISO 8608 class, A to H, at --speed; the rear follows the front");
  road->check(OneOf("--road", kRoadClasses));
  Couple(road, QuantityOptions(app, command.faults).Add("--speed", kVelocity, kSpeedHelp, [&command](double value) {
    command.speed = value;
  }));
}

void AddRoads(const MotionOptions& motions, CLI::App& app, RideCommand& command) {
  CLI::Option* road =
      motions.group
          ->add_option("--road", command.roads,
                       "Random roads of ISO 8608 classes, A to H, separated by commas, each at each --speed; the rear "
                       "follows the front")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->take_all()
          ->check(OneOf("--road", kRoadClasses))
          ->type_name(Braced(kRoadClasses));
  CLI::Option* speed = app.add_option("--speed", command.speeds, "Speeds on the roads, e.g. 60km/h or 30km/h,60km/h")
                           ->delimiter(',')
                           ->allow_extra_args(false)
                           ->take_all();
  Couple(road, speed);
}

void AddMotionDetails(CLI::App& app, SimulateCommand& command, const MotionOptions& motions) {
  QuantityOptions options(app, command.faults);
  CLI::Option* const road = motions.group->get_option("--road");
  const auto forbid = [](CLI::Option* option, std::initializer_list<CLI::Option*> others) {
    for (CLI::Option* other : others) option->excludes(other);
  };
  for (CLI::Option* limit : AddLimits(app, command.limits))
    forbid(limit, {motions.step, motions.random, road, motions.recording});
  app.add_flag("--linear", command.linear_sweep, "Sweep linearly in hertz (default: in octaves)")->needs(motions.sweep);
  options
      .Add("--rise", kTime, "Rise time of a step (default 50ms)", [&command](double value) { command.rise_s = value; })
      ->needs(motions.step);
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
  forbid(app.add_option("--mode", command.mode, kModeHelp)->capture_default_str(), {road, motions.recording});
  options.Add("--duration", kTime, "Length of the history (default: 60 s; step 5 s, sine 10 s, recording its own)",
              [&command](double value) { command.duration_s = value; });
  AddStroke(app, command.stroke);
}

}  // namespace fourpost
