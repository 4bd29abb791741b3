#include "identify/command_line/modes_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "analysis/text/text_table.h"
#include "vehicles/condensed/mode_times.h"

namespace fourpost {
namespace {

using Complex = std::complex<double>;

std::string PoleText(const Mode& mode) {
  std::string text;
  for (const Complex& pole : PolesOf(mode))
    text += (text.empty() ? "" : ", ") + Rounded(pole.real(), 4) +
            (pole.imag() == 0 ? "" : " +- " + Rounded(pole.imag(), 4) + "i");
  return mode.kind == Mode::Kind::kFree ? "0" : text;
}

std::string ModeTable(const std::vector<ShapedMode>& modes) {
  TextTable table({"mode", "Hz", "damped Hz", "damping ratio", "rise, s", "settling, s", "pole, 1/s"});
  for (const auto& [mode, shape] : modes) {
    const bool oscillates = mode.kind == Mode::Kind::kOscillating;
    const bool moves = mode.frequency_Hz > 0;
    table.Add({mode.name + (oscillates ? "" : std::string(", ") + KindName(mode.kind)),
               moves ? Rounded(mode.frequency_Hz, 4) : "-",
               oscillates ? Rounded(mode.pole.imag() / (2 * std::numbers::pi), 4) : "-",
               moves ? Rounded(mode.damping_ratio, 3) : "-", moves ? Rounded(RiseTime_s(mode), 3) : "-",
               moves ? Rounded(SettlingTime_s(mode), 3) : "-", PoleText(mode)});
  }
  return table.Format();
}

/// One component of a shape: "body z 1", "wheel about x -0.31 rad", "wheel z 0.2 at 74 deg".
struct Component {
  std::string name;
  Complex value;
  bool is_turn = false;
  double root_energy = 0;
  bool is_light = false;

  std::string Text() const {
    // Nearly in phase or against it.
    constexpr double kStraight = 0.17;
    const double phase = std::arg(value);
    const bool ahead = std::abs(phase) < kStraight;
    const bool against = std::numbers::pi - std::abs(phase) < kStraight;
    std::string text = name + " " + Rounded(against ? -std::abs(value) : std::abs(value), 2);
    if (is_turn) text += " rad";
    if (!ahead && !against) text += " at " + Rounded(phase * 180 / std::numbers::pi, 2) + " deg";
    return text;
  }
};

/// The components that have most of the kinetic energy. Links, which are light and follow the bodies they join, are
/// shown where a mode is theirs.
std::string ShapeText(const std::vector<BodyShape>& shapes) {
  constexpr std::size_t kWidth = 88;
  constexpr double kLight = 0.02;
  double mass = 0;
  for (const BodyShape& shape : shapes) mass += shape.mass;
  std::vector<Component> components;
  double most = 0;
  for (const BodyShape& shape : shapes)
    for (Eigen::Index i = 0; i < 3; ++i) {
      const std::string axis(1, "xyz"[i]);
      const double root_mass = std::sqrt(shape.mass);
      const bool is_light = shape.mass < kLight * mass;
      components.push_back(
          {shape.body + " " + axis, shape.translation[i], false, root_mass * std::abs(shape.translation[i]), is_light});
      components.push_back({shape.body + " about " + axis, shape.rotation[i], true,
                            root_mass * shape.gyration[i] * std::abs(shape.rotation[i]), is_light});
      for (std::size_t k = components.size() - 2; k < components.size(); ++k)
        most = std::max(most, components[k].root_energy);
    }
  std::stable_sort(components.begin(), components.end(),
                   [](const Component& a, const Component& b) { return a.root_energy > b.root_energy; });
  std::string text;
  for (const Component& component : components) {
    // A thousandth of the energy, of a link a tenth.
    if (component.root_energy < (component.is_light ? 0.3 : 0.03) * most) continue;
    const std::string more = (text.empty() ? "" : ", ") + component.Text();
    if (text.size() + more.size() > kWidth) break;
    text += more;
  }
  return text;
}

std::string ShapeTable(const std::vector<ShapedMode>& modes) {
  TextTable table({"mode", "moves (m, rad)"});
  for (const auto& [mode, shape] : modes) table.Add({mode.name, ShapeText(shape)});
  return table.Format();
}

std::string Hertz(const Complex& pole) {
  return std::isfinite(pole.real()) ? Rounded(std::abs(pole) / (2 * std::numbers::pi), 4) : "-";
}
std::string Ratio(const Complex& pole) {
  if (!std::isfinite(pole.real())) return "-";
  return pole.imag() == 0 ? "real" : Rounded(-pole.real() / std::abs(pole), 3);
}

/// From the first value to the last, of the poles that move by a hundredth.
std::string PathTable(const Vehicle& vehicle, const PolePaths& traced) {
  constexpr double kMoves = 0.01;
  const Parameter& parameter = vehicle.parameters[traced.parameter];
  const auto shown = [&](double si) {
    return InUnit(si, parameter.unit, 4) + (parameter.unit.empty() ? "" : " " + parameter.unit);
  };
  const std::string first = shown(traced.values.front());
  const std::string last = shown(traced.values.back());
  TextTable table({parameter.name, "Hz at " + first, "at " + last, "damping at " + first, "at " + last});
  std::size_t still = 0;
  for (const PolePath& path : traced.paths) {
    const Complex& a = path.pole.front();
    const Complex& b = path.pole.back();
    // Real in between only.
    if (!std::isfinite(a.real()) && !std::isfinite(b.real())) continue;
    if (std::abs(b - a) < kMoves * std::abs(a)) ++still;
    else table.Add({path.mode, Hertz(a), Hertz(b), Ratio(a), Ratio(b)});
  }
  const std::string rest = still == 0 ? "" : std::to_string(still) + " more move by less than a hundredth\n";
  return table.Format() + rest;
}

}  // namespace

std::string ModesText(const Vehicle& vehicle, const std::vector<ShapedMode>& modes,
                      const std::vector<PolePaths>& paths) {
  std::string text = ModeTable(modes) + '\n' + ShapeTable(modes);
  for (const PolePaths& traced : paths) text += '\n' + PathTable(vehicle, traced);
  return text;
}

}  // namespace fourpost
