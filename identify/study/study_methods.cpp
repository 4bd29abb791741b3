#include "identify/study/study_methods.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <stdexcept>
#include <type_traits>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "identify/refine/method_settings.h"

namespace fourpost {
namespace {

// False when the text is no such value; the field then stays.
bool Parse(const std::string& text, bool& field) {
  if (text != "true" && text != "false") return false;
  field = text == "true";
  return true;
}

bool Parse(const std::string& text, double& field) {
  const std::optional<double> number = ParseNumber(text);
  field = number.value_or(field);
  return number.has_value();
}

template <typename Integer>
requires std::is_integral_v<Integer>
bool Parse(const std::string& text, Integer& field) {
  Integer number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return false;
  field = number;
  return true;
}

template <typename Words>
std::string Listed(const Words& words) {
  std::string list;
  for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + std::string(word);
  return list;
}

// What is wrong with a setting; empty when it is set.
std::string Set(MethodOptions& options, const StudySetting& setting) {
  std::string fault = "unknown setting '" + setting.key + "'";
  std::vector<std::string> keys;
  const auto number = [&](const std::string& key, auto& field) {
    keys.push_back(key);
    if (key != setting.key) return;
    fault = Parse(setting.value, field) ? "" : "'" + key + "' cannot be '" + setting.value + "'";
  };
  const auto word = [&](const std::string& key, auto& field, const auto& words) {
    keys.push_back(key);
    if (key != setting.key) return;
    const auto found = std::find(words.begin(), words.end(), setting.value);
    if (found != words.end()) field = static_cast<std::remove_reference_t<decltype(field)>>(found - words.begin());
    fault = found != words.end() ? "" : "'" + key + "' must be one of " + Listed(words);
  };
  std::visit([&](auto& o) { VisitSettings(o, number, word); }, options);
  const bool known = std::find(keys.begin(), keys.end(), setting.key) != keys.end();
  return known ? fault : fault + DidYouMean(setting.key, keys);
}

void SetPopulation(MethodOptions& options, int population) {
  std::visit(
      [&](auto& o) {
        if constexpr (requires { o.population; }) o.population = population;
      },
      options);
}

MethodOptions OptionsOf(const StudyMethod& method, const std::string& file, const Problem& problem,
                        Diagnostics& diagnostics) {
  MethodOptions options = MethodPreset(method.preset, problem);
  const std::string where = "method '" + method.name + "': ";
  for (const StudySetting& setting : method.settings)
    if (const std::string fault = Set(options, setting); !fault.empty())
      diagnostics.Error(file, setting.line, where + fault);
  try {
    Validate(options);
  } catch (const std::invalid_argument& error) {
    diagnostics.Error(file, method.line, where + error.what());
  }
  return options;
}

}  // namespace

std::vector<ComparedMethod> MethodsOf(const Study& study, const std::vector<std::string>& names, const Problem& problem,
                                      Diagnostics& diagnostics) {
  const std::string file = study.file.string();
  std::vector<std::string> legal(kMethodNames.begin(), kMethodNames.end());
  for (const StudyMethod& method : study.methods) legal.push_back(method.name);
  std::vector<ComparedMethod> methods;
  std::set<std::string> seen;
  for (const std::string& name : names) {
    const auto own = std::find_if(study.methods.begin(), study.methods.end(),
                                  [&](const StudyMethod& method) { return method.name == name; });
    if (!seen.insert(name).second) diagnostics.Error("--methods", 0, "method '" + name + "' is asked for twice");
    else if (own != study.methods.end()) methods.push_back({name, OptionsOf(*own, file, problem, diagnostics)});
    else if (std::find(kMethodNames.begin(), kMethodNames.end(), name) != kMethodNames.end())
      methods.push_back({name, MethodPreset(name, problem)});
    else diagnostics.Error("--methods", 0, "there is no method '" + name + "'" + DidYouMeanOrAll(name, legal));
  }
  return methods;
}

MethodOptions ExplorationOf(const Study& study, const Problem& problem, Diagnostics& diagnostics) {
  const std::string file = study.file.string();
  Diagnostics faults;
  const std::vector<ComparedMethod> methods = MethodsOf(study, {study.search.method}, problem, faults);
  for (const Diagnostic& fault : faults.items())
    diagnostics.Error(file, fault.place.line > 0 ? fault.place.line : study.search.method_line, fault.message);
  if (faults.HasErrors()) return MethodPreset("dvhde", problem);
  MethodOptions options = methods.front().options;
  if (const auto* refining = std::get_if<MultiStartOptions>(&options)) {
    if (refining->explore_evaluations == 0)
      diagnostics.Error(file, study.search.method_line,
                        "'" + study.search.method +
                            "' refines random points, and a fit refines by itself: choose how it explores before, such "
                            "as dvhde, thesis, de or direct");
    const DvhdeOptions explore = refining->explore;
    options.emplace<DvhdeOptions>(explore);
  }
  if (study.search.population) SetPopulation(options, *study.search.population);
  return options;
}

}  // namespace fourpost
