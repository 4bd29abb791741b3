#include "analysis/text/units.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

#include "analysis/text/number.h"

namespace fourpost {
namespace {

/// A unit as factor times a power of ten, so that decimal units convert without a rounding of their own.
struct Scale {
  Dimension dimension;
  int power_of_ten = 0;
  double factor = 1;

  double si() const { return ParseNumber("1", power_of_ten).value() * factor; }
};

struct NamedScale {
  std::string_view name;
  Scale scale;
};

// Exact by the international yard and pound of 1959 and the standard gravity.
constexpr double kPound = 0.45359237;
constexpr double kPoundForce = kPound * 9.80665;
constexpr double kPsi = kPoundForce / (0.0254 * 0.0254);

constexpr std::array<NamedScale, 37> kScales = {{
    {"1", {kDimensionless}},
    {"%", {kDimensionless, -2}},
    {"rad", {kDimensionless}},
    {"deg", {kDimensionless, 0, std::numbers::pi / 180}},
    {"km", {kLength, 3}},
    {"m", {kLength}},
    {"cm", {kLength, -2}},
    {"mm", {kLength, -3}},
    {"kg", {kMass}},
    {"g", {kMass, -3}},
    {"t", {kMass, 3}},
    {"s", {kTime}},
    {"ms", {kTime, -3}},
    {"min", {kTime, 0, 60}},
    {"h", {kTime, 0, 3600}},
    {"Hz", {kFrequency}},
    {"N", {kForce}},
    {"kN", {kForce, 3}},
    {"MN", {kForce, 6}},
    {"Pa", {kPressure}},
    {"kPa", {kPressure, 3}},
    {"MPa", {kPressure, 6}},
    {"bar", {kPressure, 5}},
    {"mbar", {kPressure, 2}},
    {"hPa", {kPressure, 2}},
    {"um", {kLength, -6}},
    {"daN", {kForce, 1}},
    {"kgf", {kForce, 0, 9.80665}},
    {"in", {kLength, -4, 254}},
    {"ft", {kLength, -4, 3048}},
    {"mil", {kLength, -7, 254}},
    {"lbm", {kMass, 0, kPound}},
    {"slug", {kMass, 0, kPoundForce / 0.3048}},
    {"lbf", {kForce, 0, kPoundForce}},
    {"kip", {kForce, 3, kPoundForce}},
    {"psi", {kPressure, 0, kPsi}},
    {"ksi", {kPressure, 3, kPsi}},
}};

struct NamedDimension {
  Dimension dimension;
  std::string_view name;
  std::string_view unit;
};

constexpr std::array<NamedDimension, 20> kDimensions = {{
    {kDimensionless, "pure number", "1"},
    {kMass, "mass", "kg"},
    {kLength, "length", "m"},
    {kTime, "time", "s"},
    {kVelocity, "velocity", "m/s"},
    {kAcceleration, "acceleration", "m/s^2"},
    {kForce, "force", "N"},
    {kStiffness, "stiffness", "N/m"},
    {kDamping, "damping", "N*s/m"},
    {kInertia, "inertia", "kg*m^2"},
    {kFrequency, "frequency", "Hz"},
    {kPressure, "pressure", "Pa"},
    {kFlowResistance, "flow resistance", "Pa*s/kg"},
    {kArea, "area", "m^2"},
    {kVolume, "volume", "m^3"},
    {kDensity, "density", "kg/m^3"},
    {kCubicStiffness, "cubic stiffness", "N/m^3"},
    {kTorque, "torque", "N*m"},
    {kAngularDamping, "rotational damping", "N*m*s"},
    {kPerLength, "reciprocal length", "1/m"},
}};

/// The units in which parts of vehicles are given: one for numbers up to a limit, another for those from it on.
struct UsualUnits {
  Dimension dimension;
  std::string_view small;
  double limit = 0;
  std::string_view large;
};

constexpr std::array<UsualUnits, 9> kUsualUnits = {{
    {kLength, "m", 5, "mm"},
    {kVelocity, "m/s", 5, "mm/s"},
    {kStiffness, "N/mm", 1000, "N/m"},
    {kDamping, "kN*s/m", 20, "N*s/m"},
    {kCubicStiffness, "N/mm^3", 1000, "N/m^3"},
    {kPressure, "bar", 1000, "Pa"},
    {kArea, "m^2", 0.1, "mm^2"},
    {kVolume, "m^3", 0.1, "cm^3"},
    {kDensity, "g/cm^3", 20, "kg/m^3"},
}};

const NamedDimension* FindDimension(const Dimension& dimension) {
  for (const NamedDimension& named : kDimensions)
    if (named.dimension == dimension) return &named;
  return nullptr;
}

/// "-2" of "s^-2".
std::optional<int> ParsePower(std::string_view text) {
  int power = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), power);
  if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  if (power == 0 || std::abs(power) > 9) return std::nullopt;
  return power;
}

/// result times scale to a power.
void Multiply(Scale& result, const Scale& scale, int power) {
  result.dimension.kilogram += power * scale.dimension.kilogram;
  result.dimension.metre += power * scale.dimension.metre;
  result.dimension.second += power * scale.dimension.second;
  result.power_of_ten += power * scale.power_of_ten;
  result.factor *= std::pow(scale.factor, power);
}

/// Multiplies by "m^2", or divides by it; false for an unknown name.
bool MultiplyTerm(Scale& result, std::string_view term, bool divide) {
  const std::size_t caret = term.find('^');
  const std::optional<int> power =
      caret == std::string_view::npos ? std::optional<int>(1) : ParsePower(term.substr(caret + 1));
  if (!power) return false;
  for (const NamedScale& named : kScales) {
    if (named.name != term.substr(0, caret)) continue;
    Multiply(result, named.scale, divide ? -*power : *power);
    return true;
  }
  return false;
}

std::optional<Scale> ParseScale(std::string_view text) {
  Scale result;
  bool divide = false;
  for (;;) {
    const std::size_t sign = text.find_first_of("*/");
    if (!MultiplyTerm(result, text.substr(0, sign), divide)) return std::nullopt;
    if (sign == std::string_view::npos) break;
    divide = text[sign] == '/';
    text.remove_prefix(sign + 1);
  }
  // Beyond a double, and so beyond any use.
  if (std::abs(result.power_of_ten) > 300) return std::nullopt;
  return result;
}

std::string_view Trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The number `si` in a unit that is no power of ten of SI, at the fewest digits that read back.
std::string FormatScaled(double si, double factor, int power_of_ten) {
  const auto reads_back = [&](const std::string& text) {
    const std::optional<double> number = ParseNumber(text, power_of_ten);
    return number && *number * factor == si;
  };
  const double value = si / factor;
  std::array<char, 32> buffer;
  for (int digits = 1; digits <= 17; ++digits) {
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific, digits - 1)
            .ptr;
    const std::optional<double> rounded = ParseNumber({buffer.data(), static_cast<std::size_t>(end - buffer.data())});
    if (!rounded) break;
    std::string text = FormatNumber(*rounded, -power_of_ten);
    if (reads_back(text)) return text;
  }
  for (const double end : {-HUGE_VAL, HUGE_VAL}) {
    std::string text = FormatNumber(std::nextafter(value, end), -power_of_ten);
    if (reads_back(text)) return text;
  }
  return FormatNumber(value, -power_of_ten);
}

std::string ComposeUnit(const Dimension& dimension) {
  std::string above;
  std::string below;
  const auto add = [&](int power, const std::string& name) {
    if (power == 0) return;
    const std::string term = std::abs(power) == 1 ? name : name + "^" + std::to_string(std::abs(power));
    if (power < 0) below += "/" + term;
    if (power > 0) above += (above.empty() ? "" : "*") + term;
  };
  add(dimension.kilogram, "kg");
  add(dimension.metre, "m");
  add(dimension.second, "s");
  return (above.empty() ? "1" : above) + below;
}

}  // namespace

std::optional<Unit> ParseUnit(std::string_view text) {
  const std::optional<Scale> scale = ParseScale(text);
  if (!scale) return std::nullopt;
  return Unit{scale->si(), scale->dimension};
}

std::optional<Quantity> ParseQuantity(std::string_view text) {
  text = Trim(text);
  const std::size_t end_of_number = text.find_first_not_of("+-.0123456789eE");
  std::string unit_text(end_of_number == std::string_view::npos ? std::string_view()
                                                                : Trim(text.substr(end_of_number)));
  // "3/m" is "3 1/m".
  if (unit_text.starts_with('/')) unit_text.insert(0, 1, '1');
  const std::optional<Scale> scale = unit_text.empty() ? Scale{} : ParseScale(unit_text);
  if (!scale) return std::nullopt;
  const std::optional<double> number = ParseNumber(text.substr(0, end_of_number), scale->power_of_ten);
  if (!number || !std::isfinite(*number * scale->factor)) return std::nullopt;
  return Quantity{*number * scale->factor, {scale->si(), scale->dimension}, unit_text};
}

std::string SiUnit(const Dimension& dimension) {
  const NamedDimension* named = FindDimension(dimension);
  return named ? std::string(named->unit) : ComposeUnit(dimension);
}

std::string LikelyUnit(const Dimension& dimension, double number) {
  for (const UsualUnits& usual : kUsualUnits)
    if (usual.dimension == dimension) return std::string(std::abs(number) < usual.limit ? usual.small : usual.large);
  return SiUnit(dimension);
}

std::string DimensionName(const Dimension& dimension) {
  const NamedDimension* named = FindDimension(dimension);
  return named ? std::string(named->name) : ComposeUnit(dimension);
}

std::string FormatQuantity(double si, const std::string& unit_text) {
  if (unit_text.empty() || unit_text == "1") return FormatNumber(si);
  const std::optional<Scale> scale = ParseScale(unit_text);
  if (!scale) throw std::invalid_argument("unknown unit '" + unit_text + "'");
  const std::string number = scale->factor == 1 ? FormatNumber(si, -scale->power_of_ten)
                                                : FormatScaled(si, scale->factor, scale->power_of_ten);
  return number + " " + unit_text;
}

}  // namespace fourpost
