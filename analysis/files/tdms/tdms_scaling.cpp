#include "analysis/files/tdms/tdms_scaling.h"

#include <algorithm>

namespace fourpost {
namespace {

/// More follow each other nowhere.
constexpr double kMostScales = 64;
constexpr double kMostCoefficients = 64;
/// In place of the number of an earlier scale: the raw values.
constexpr double kRaw = 0xFFFFFFFF;

}  // namespace

double NumberOf(const TdmsProperties& properties, const std::string& name) {
  const auto found = properties.find(name);
  const double* number = found == properties.end() ? nullptr : std::get_if<double>(&found->second);
  return number == nullptr ? 0 : *number;
}

std::string TextOf(const TdmsProperties& properties, const std::string& name) {
  const auto found = properties.find(name);
  const std::string* text = found == properties.end() ? nullptr : std::get_if<std::string>(&found->second);
  return text == nullptr ? "" : *text;
}

std::optional<TdmsScaling> TdmsScaling::Of(const TdmsProperties& properties) {
  TdmsScaling scaling;
  const double scales = NumberOf(properties, "NI_Number_Of_Scales");
  if (TextOf(properties, "NI_Scaling_Status") == "scaled") return scaling;
  if (!(scales >= 0 && scales <= kMostScales)) return std::nullopt;
  // The last one gives the values; each names the one before it.
  double next = scales - 1;
  while (next >= 0 && next != kRaw && static_cast<double>(scaling.polynomials_.size()) <= scales) {
    const std::string scale = "NI_Scale[" + std::to_string(static_cast<int>(next)) + "]_";
    const std::string type = TextOf(properties, scale + "Scale_Type");
    if (type != "Linear" && type != "Polynomial") return std::nullopt;
    const std::string prefix = scale + type + "_";
    std::vector<double>& polynomial = scaling.polynomials_.emplace_back();
    if (type == "Linear")
      polynomial = {NumberOf(properties, prefix + "Y_Intercept"), NumberOf(properties, prefix + "Slope")};
    const double size =
        properties.contains(prefix + "Coefficients_Size") ? NumberOf(properties, prefix + "Coefficients_Size") : 4;
    if (!(size >= 0 && size <= kMostCoefficients)) return std::nullopt;
    for (int i = 0; type == "Polynomial" && i < static_cast<int>(size); ++i)
      polynomial.push_back(NumberOf(properties, prefix + "Coefficients[" + std::to_string(i) + "]"));
    const double before =
        properties.contains(prefix + "Input_Source") ? NumberOf(properties, prefix + "Input_Source") : kRaw;
    // One that follows itself would never end.
    if (before != kRaw && !(before >= 0 && before < next)) return std::nullopt;
    next = before;
  }
  std::reverse(scaling.polynomials_.begin(), scaling.polynomials_.end());
  return scaling;
}

void TdmsScaling::Apply(std::vector<double>& values) const {
  for (const std::vector<double>& polynomial : polynomials_)
    for (double& value : values) {
      double sum = 0;
      for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) sum = sum * value + *c;
      value = sum;
    }
}

}  // namespace fourpost
