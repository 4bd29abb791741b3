#include "identify/command_line/simulate_options.h"

#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "analysis/nearest.h"
#include "analysis/units.h"
#include "identify/command_line/whole_number.h"
#include "vehicles/description/post_pattern.h"
#include "vehicles/posts/road.h"

namespace fourpost {
namespace {

/// SI value of "5 mm" or "5mm", for an option.
double Parse(const std::string& option, const std::string& text, const Dimension& dimension,
             bool may_be_negative = false) {
  const std::optional<Quantity> quantity = ParseQuantity(text);
  const std::string example = dimension == kLength ? "mm" : dimension == kDimensionless ? "%" : SiUnit(dimension);
  // Also rad/s has the dimension of a frequency, and 2 pi of them make 1 Hz.
  const bool is_wrong = quantity && dimension == kFrequency && !quantity->unit_text.ends_with("Hz");
  if (!quantity || is_wrong || quantity->unit.dimension != dimension ||
      (quantity->unit_text.empty() && dimension != kDimensionless))
    throw CLI::ValidationError(
        option, "'" + text + "' is no " + DimensionName(dimension) + " with a unit such as '" + example + "'");
  if (!may_be_negative && !(quantity->si > 0)) throw CLI::ValidationError(option, "'" + text + "' must be above zero");
  return quantity->si;
}

/// "0.5Hz:30Hz".
void ParseRange(const std::string& option, const std::string& text, double& first, double& last) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
    throw CLI::ValidationError(option, "'" + text + "' is no range of frequencies such as '0.5Hz:30Hz'");
  first = Parse(option, text.substr(0, colon), kFrequency);
  last = Parse(option, text.substr(colon + 1), kFrequency);
}

CLI::Validator OneOf(const char* what, std::span<const std::string_view> legal) {
  const auto fault = [what, legal](const std::string& text) -> std::string {
    std::string all;
    for (const std::string_view name : legal) {
      if (name == text) return "";
      all += (all.empty() ? "" : ", ") + std::string(name);
    }
    return "no " + std::string(what) + " is called '" + text + "'" + DidYouMean(text, legal) + "; there are " + all;
  };
  return {fault, ""};
}

/// Adds options whose values carry units.
class QuantityOptions {
 public:
  explicit QuantityOptions(CLI::App& app) : app_(app) {}

  CLI::Option* Add(const char* name, const Dimension& dimension, const char* help, std::function<void(double)> take) {
    return app_.add_option_function<std::string>(
        name, [=](const std::string& text) { take(Parse(name, text, dimension)); }, help);
  }

 private:
  CLI::App& app_;
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
  CLI::Option_group* group = app.add_option_group("What the posts do");
  const auto add = [&](const char* name, Motion motion, const char* help,
                       std::function<void(const std::string&)> take) {
    const auto set = [&command, motion, take](const std::string& text) {
      command.motion = motion;
      take(text);
    };
    return group->add_option_function<std::string>(name, set, help);
  };
  MotionOptions options;
  options.sweep =
      add("--sweep", Motion::kSweep, "Swept sine, from one frequency to another: 0.5Hz:30Hz",
          [&command](const std::string& text) { ParseRange("--sweep", text, command.first_Hz, command.last_Hz); });
  options.sine = add("--sine", Motion::kSweep, "Sine of one frequency: 2Hz", [&command](const std::string& text) {
    command.first_Hz = command.last_Hz = Parse("--sine", text, kFrequency);
  });
  options.step =
      add("--step", Motion::kStep, "Step of this height after 0.5 s: 20mm, or -20mm",
          [&command](const std::string& text) { command.amplitude_m = Parse("--step", text, kLength, true); });
  options.random =
      add("--random", Motion::kRandom, "Random heights of this rms, their velocity white within --band: 4mm",
          [&command](const std::string& text) { command.amplitude_m = Parse("--random", text, kLength); });
  options.road =
      add("--road", Motion::kRoad, "Random road of ISO 8608 class A to H, at --speed, the rear after the front",
          [&command](const std::string& text) { command.road_class = text; });
  options.road->check(OneOf("road class", kRoadClasses));
  options.recording =
      add("--recording", Motion::kRecording, "CSV of recorded post heights: names, units, time and a column a post",
          [&command](const std::string& text) { command.recording = text; });
  group->require_option(1);
  return options;
}

/// What belongs to some of the motions only.
void AddDetails(CLI::App& app, SimulateCommand& command, const MotionOptions& motions) {
  QuantityOptions options(app);
  const auto forbid = [](CLI::Option* option, std::initializer_list<CLI::Option*> others) {
    for (CLI::Option* other : others) option->excludes(other);
  };
  CLI::Option* amplitude = options.Add("--amplitude", kLength, "Of a sweep or sine, each post's: 5mm",
                                       [&command](double value) { command.amplitude_m = value; });
  motions.sweep->needs(amplitude);
  motions.sine->needs(amplitude);
  forbid(amplitude, {motions.step, motions.random, motions.road, motions.recording});
  options
      .Add("--top-speed", kVelocity, "Amplitude of a sweep falls where its peak velocity would exceed this: 0.1m/s",
           [&command](double value) { command.top_speed = value; })
      ->needs(motions.sweep);
  app.add_flag("--linear", command.linear_sweep, "Sweep evenly in hertz rather than in octaves")->needs(motions.sweep);
  options.Add("--rise", kTime, "Of a step (default 50ms)", [&command](double value) { command.rise_s = value; })
      ->needs(motions.step);
  CLI::Option* speed = options.Add("--speed", kVelocity, "Of the vehicle on a road: 60km/h",
                                   [&command](double value) { command.speed = value; });
  motions.road->needs(speed);
  speed->needs(motions.road);
  CLI::Option* band = app.add_option_function<std::string>(
      "--band",
      [&command](const std::string& text) {
        ParseRange("--band", text, command.first_Hz, command.last_Hz);
        if (!(command.first_Hz < command.last_Hz))
          throw CLI::ValidationError("--band", "'" + text + "' must go from a lower frequency to a higher one");
      },
      "Of a random motion or road (default 0.5Hz:30Hz)");
  forbid(band, {motions.sweep, motions.sine, motions.step, motions.recording});
  CLI::Option* mode = app.add_option("--mode", command.mode, "heave, pitch, roll or warp")
                          ->check(OneOf("mode", kPostPatterns))
                          ->capture_default_str();
  forbid(mode, {motions.road, motions.recording});
  options.Add("--duration", kTime, "Default: 60 s, of a step 5 s, of a sine 10 s, of a recording its own",
              [&command](double value) { command.duration_s = value; });
  options.Add("--stroke", kLength,
              "Of posts whose stroke the vehicle file does not tell, from end to end (default 150mm)",
              [&command](double value) { command.stroke_m = value; });
}

void AddAcquisition(CLI::App& app, SimulateCommand& command) {
  QuantityOptions options(app);
  app.add_option("--channels", command.channels, "Sensors to tell, all by default: a_body_FL,a_body_FR")
      ->delimiter(',')
      ->allow_extra_args(false);
  options.Add("--rate", kFrequency, "Of the samples (default 500Hz)",
              [&command](double value) { command.rate_Hz = value; });
  CLI::Option* filter = options.Add("--filter", kFrequency, "Cut-off of a Butterworth low-pass on every channel",
                                    [&command](double value) { command.filter_Hz = value; });
  app.add_option("--order", command.filter_order, "Of the filter")
      ->check(CLI::Range(1, 16))
      ->capture_default_str()
      ->needs(filter);
  options.Add("--noise", kDimensionless, "White noise on every channel, as a share of its deviation: 1%",
              [&command](double value) { command.noise = value; });
  app.add_option("--seed", command.seed, "Of random motions and noise")->check(WholeNumber())->capture_default_str();
}

}  // namespace

CLI::App* AddSimulate(CLI::App& app, SimulateCommand& command) {
  CLI::App* sub = app.add_subcommand("simulate", "Time history of a vehicle on its posts, as CSV");
  sub->add_option("MODEL", command.model, "Vehicle file (.urdf)")->required();
  AddDetails(*sub, command, AddMotions(*sub, command));
  AddAcquisition(*sub, command);
  sub->add_option_function<std::string>(
         "--engine", [&command](const std::string& text) { command.full = text == "full"; },
         "condensed: kinematics linearised about equilibrium, laws as they are; full: the multibody system (slow)")
      ->check(CLI::IsMember({"condensed", "full"}))
      ->default_str("condensed");
  QuantityOptions(*sub).Add("--error", kDimensionless,
                            "Of each channel's rms, allowed to the integration (default 0.1%)",
                            [&command](double value) { command.error = value; });
  sub->add_option("-o,--output", command.output, "File for the CSV, in place of stdout; tells a summary then");
  sub->add_option("--chart", command.chart, "File for a picture of the history (.svg)");
  sub->add_flag("--json", command.json, "Print the summary as JSON in place of CSV or table");
  return sub;
}

}  // namespace fourpost
