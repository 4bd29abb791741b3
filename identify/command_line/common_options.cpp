#include "identify/command_line/common_options.h"

#include <algorithm>
#include <optional>

#include "analysis/text/diagnostics.h"
#include "analysis/text/nearest.h"
#include "identify/command_line/findings.h"
#include "identify/command_line/print.h"
#include "vehicles/engine/engine.h"

namespace fourpost {

CLI::Option* AddList(CLI::App& app, const char* name, std::vector<std::string>& values, const char* help) {
  return app.add_option(name, values, help)->expected(1)->take_all();
}

void AddVehicle(CLI::App& app, std::filesystem::path& file) {
  app.add_option("MODEL", file, "Vehicle file (.urdf)")->required();
}

CLI::Option* AddSettings(CLI::App& app, std::vector<std::string>& settings) {
  return AddList(app, "--set", settings,
                 "Another value of a parameter, NAME=VALUE with its unit, e.g. k=20kN/m; may be given several times");
}

CLI::Option* AddChannels(CLI::App& app, std::vector<std::string>& channels) {
  return app.add_option("--channels", channels, "Sensors to report, e.g. a_body_FL,a_body_FR (default: all)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->take_all();
}

std::vector<CLI::Option*> AddLimits(CLI::App& app, LimitText& limits) {
  return {app.add_option("--amplitude", limits.amplitude,
                         "Largest displacement of the reference post, peak, e.g. 12mm. The lowest of the three limits "
                         "applies at each frequency (default: 12 mm, 0.15 m/s and 6 m/s^2)"),
          app.add_option("--velocity", limits.velocity, "Its largest velocity, peak, e.g. 0.15m/s"),
          app.add_option("--acceleration", limits.acceleration, "Its largest acceleration, peak, e.g. 6m/s^2 or 0.5g")};
}

CLI::Option* AddStroke(CLI::App& app, std::string& stroke) {
  return app.add_option("--stroke", stroke,
                        "Stroke, from end to end, of posts for which the vehicle file gives none (default 150mm)");
}

std::string Braced(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "{" : ",") + std::string(word);
  return text + "}";
}

CLI::Validator OneOf(const char* option, std::span<const std::string_view> legal) {
  const auto fault = [option, legal](const std::string& text) -> std::string {
    if (std::find(legal.begin(), legal.end(), text) == legal.end())
      Refuse(kValueUnknown, Place::Option(option), {text, DidYouMeanOrAll(text, legal)});
    return "";
  };
  return {fault, Braced(legal)};
}

CLI::Validator EngineOf(std::span<const std::string_view> legal) {
  const auto replace = [one_of = OneOf("--engine", legal)](std::string& text) {
    const std::optional<Engine> engine = EngineNamed(text);
    const std::string name = engine ? EngineName(*engine) : text;
    if (name != text) Tell(kEngineFormer, Place::Option("--engine"), {text, name});
    text = name;
    return one_of(text);
  };
  CLI::Validator validator;
  validator.operation(replace).description(Braced(legal));
  return validator;
}

}  // namespace fourpost
