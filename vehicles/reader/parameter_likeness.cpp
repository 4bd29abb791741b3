#include "vehicles/reader/parameter_likeness.h"

#include <algorithm>
#include <string>
#include <utility>

#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "vehicles/reader/findings.h"
#include "vehicles/reader/tag_check.h"
#include "vehicles/tags/attribute_check.h"
#include "vehicles/tags/findings.h"

namespace fourpost {
namespace {

std::vector<std::string> OtherNames(const std::vector<Parameter>& parameters, const std::string& own) {
  std::vector<std::string> names;
  for (const Parameter& one : parameters)
    if (one.name != own) names.push_back(one.name);
  return names;
}

/// Why the two cannot be compared, and the words of that.
std::optional<std::pair<const Finding*, std::vector<std::string>>> FaultOf(const Parameter& parameter,
                                                                           const Parameter& other) {
  if (other.like && other.like->parameter == parameter.name) return {{&kLikeEachOther, {other.name}}};
  if (other.dimension != parameter.dimension)
    return {{&kLikeOfOtherDimension, {WithArticle(other.dimension), WithArticle(parameter.dimension)}}};
  for (const Parameter* one : {&parameter, &other})
    if (one->lower <= 0) return {{&kLikeNotPositive, {one->name}}};
  return std::nullopt;
}

}  // namespace

std::optional<Parameter::Likeness> ReadLikeness(const Tag& tag, std::size_t place,
                                                const std::vector<Parameter>& parameters,
                                                const std::vector<bool>& sound, FileFaults& faults) {
  const std::optional<std::string> name = AttributeText(*tag.element, "like");
  const std::optional<std::string> sd = AttributeText(*tag.element, "like_sd");
  if (!name && !sd) return std::nullopt;
  if (!name || !sd) {
    faults.Report(kLikeIncomplete, tag.Line(), {Describe(*tag.element)});
    return std::nullopt;
  }
  const auto refuse = [&](const char* attribute, const Finding& kind, std::vector<std::string> words) {
    words.insert(words.begin(), Quoted(attribute, tag));
    faults.Report(kind, tag.Line(attribute), words);
    return std::nullopt;
  };
  const std::optional<double> number = ParseNumber(Trimmed(*sd));
  // Reported with all other attributes.
  if (!number) return std::nullopt;
  if (*number <= 0) return refuse("like_sd", kNumberNotPositive, {""});
  const Parameter& parameter = parameters[place];
  const auto other = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& one) { return one.name == *name && &one != &parameter; });
  if (other == parameters.end())
    return refuse("like", kLikeUnknown, {DidYouMeanOrAll(*name, OtherNames(parameters, parameter.name))});
  if (!sound[static_cast<std::size_t>(other - parameters.begin())]) return std::nullopt;
  if (const auto fault = FaultOf(parameter, *other)) return refuse("like", *fault->first, fault->second);
  return Parameter::Likeness{*name, *number};
}

}  // namespace fourpost
