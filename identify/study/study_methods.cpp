#include "identify/study/study_methods.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <stdexcept>
#include <type_traits>

#include "analysis/text/found.h"
#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "identify/refine/method_settings.h"
#include "identify/study/findings.h"

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

// What is wrong with a setting of the method of this name; nothing when it is set.
Found Set(MethodOptions& options, const std::string& method, const StudySetting& setting) {
  bool is_known = false;
  Found fault;
  std::vector<std::string> keys;
  const auto is_meant = [&](const std::string& key) {
    keys.push_back(key);
    is_known = is_known || key == setting.key;
    return key == setting.key;
  };
  const auto number = [&](const std::string& key, auto& field) {
    if (is_meant(key) && !Parse(setting.value, field)) fault = {&kSettingUnreadable, {method, key, setting.value}};
  };
  const auto word = [&](const std::string& key, auto& field, const auto& words) {
    if (!is_meant(key)) return;
    const auto found = std::find(words.begin(), words.end(), setting.value);
    if (found == words.end()) fault = {&kSettingNotOneOf, {method, key, Listed(words)}};
    else field = static_cast<std::remove_reference_t<decltype(field)>>(found - words.begin());
  };
  std::visit([&](auto& o) { VisitSettings(o, number, word); }, options);
  if (!is_known) return {&kSettingUnknown, {method, setting.key, DidYouMeanOrAll(setting.key, keys)}};
  return fault;
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
  for (const StudySetting& setting : method.settings)
    if (const Found fault = Set(options, method.name, setting))
      diagnostics.Report(*fault.kind, {file, setting.line}, fault.words);
  try {
    Validate(options);
  } catch (const std::invalid_argument& error) {
    diagnostics.Report(kSettingOutOfRange, {file, method.line}, {method.name, error.what()});
  }
  return options;
}

// `asked`: where the names are.
std::vector<ComparedMethod> NamedMethods(const Study& study, const std::vector<std::string>& names,
                                         const Problem& problem, const Place& asked, Diagnostics& diagnostics) {
  const std::string file = study.file.string();
  std::vector<std::string> legal(kMethodNames.begin(), kMethodNames.end());
  for (const StudyMethod& method : study.methods) legal.push_back(method.name);
  std::vector<ComparedMethod> methods;
  std::set<std::string> seen;
  for (const std::string& asked_name : names) {
    const std::optional<std::string_view> present = PresentMethodName(asked_name);
    if (present) diagnostics.Report(kMethodFormer, asked, {asked_name, std::string(*present)});
    const std::string name(present.value_or(asked_name));
    const auto own = std::find_if(study.methods.begin(), study.methods.end(),
                                  [&](const StudyMethod& method) { return method.name == name; });
    if (!seen.insert(name).second) diagnostics.Report(kMethodTwice, asked, {name});
    else if (own != study.methods.end()) methods.push_back({name, OptionsOf(*own, file, problem, diagnostics)});
    else if (std::find(kMethodNames.begin(), kMethodNames.end(), name) != kMethodNames.end())
      methods.push_back({name, MethodPreset(name, problem)});
    else diagnostics.Report(kMethodUnknown, asked, {name, DidYouMeanOrAll(name, legal)});
  }
  return methods;
}

}  // namespace

std::vector<ComparedMethod> MethodsOf(const Study& study, const std::vector<std::string>& names, const Problem& problem,
                                      Diagnostics& diagnostics) {
  return NamedMethods(study, names, problem, Place::Option("--methods"), diagnostics);
}

MethodOptions ExplorationOf(const Study& study, const Problem& problem, Diagnostics& diagnostics) {
  const Place asked{.file = study.file.string(), .line = study.search.method_line};
  Diagnostics faults;
  const std::vector<ComparedMethod> methods = NamedMethods(study, {study.search.method}, problem, asked, faults);
  diagnostics.Add(faults);
  if (faults.HasErrors()) return MethodPreset("dvhde", problem);
  MethodOptions options = methods.front().options;
  if (const auto* refining = std::get_if<MultiStartOptions>(&options)) {
    if (refining->explore_evaluations == 0) diagnostics.Report(kMethodOnlyRefines, asked, {study.search.method});
    const DvhdeOptions explore = refining->explore;
    options.emplace<DvhdeOptions>(explore);
  }
  if (study.search.population) SetPopulation(options, *study.search.population);
  return options;
}

}  // namespace fourpost
