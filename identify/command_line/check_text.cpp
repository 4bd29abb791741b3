#include "identify/command_line/check_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

#include "analysis/text/text_table.h"
#include "analysis/text/units.h"
#include "vehicles/description/gravity.h"

namespace fourpost {
namespace {

constexpr double kHighestMode_Hz = 30;

std::string Fixed(double value, int decimals) {
  char text[64];
  // Zero has no sign.
  const double unit = std::pow(10, -decimals);
  std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value) < 0.5 * unit ? 0 : value);
  return text;
}

/// Without zeros behind the point that say nothing: what a file states.
std::string Short(double value, int digits) {
  std::string text = Rounded(value, digits);
  if (text.find('.') == std::string::npos || text.find('e') != std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string InPerMm(double rate_Npm) { return Rounded(rate_Npm / 1000, 4); }

std::string Ratio(const std::optional<double>& ratio) { return ratio ? Fixed(*ratio, 3) : "-"; }

const char* KindName(Spring::Kind kind) {
  switch (kind) {
    case Spring::Kind::kCoil: return "spring";
    case Spring::Kind::kStop: return "stop";
    case Spring::Kind::kGas: return "gas";
  }
  return "";
}

std::string AxisText(const Eigen::Vector3d& axis) {
  constexpr double kAligned = 1e-6;
  for (Eigen::Index i = 0; i < 3; ++i)
    if (std::abs(axis[i]) > 1 - kAligned) return std::string(axis[i] < 0 ? "-" : "") + "xyz"[i];
  return Fixed(axis.x(), 3) + " " + Fixed(axis.y(), 3) + " " + Fixed(axis.z(), 3);
}

class Tree {
 public:
  explicit Tree(const Vehicle& vehicle) : vehicle_(vehicle), values_(vehicle.ParameterValues()) {}

  std::string Format() {
    table_.Add({vehicle_.links.front().name, "", "", "-"});
    AddChildren(0, 1);
    return table_.Format();
  }

 private:
  void AddChildren(int parent, std::size_t depth) {
    for (const Joint& joint : vehicle_.joints) {
      if (joint.parent != parent) continue;
      const Link& link = vehicle_.links[static_cast<std::size_t>(joint.child)];
      const double mass = link.mass.At(values_);
      table_.Add({std::string(2 * depth, ' ') + link.name, joint.name, DescribeJoint(joint),
                  mass == 0 ? "-" : Short(mass, 5)});
      AddChildren(joint.child, depth + 1);
    }
  }

  const Vehicle& vehicle_;
  std::vector<double> values_;
  TextTable table_{{"link", "joint", "motion", "mass, kg"}};
};

template <typename Element>
void AddJoined(const Vehicle& vehicle, const char* kind, const std::vector<Element>& elements, TextTable& table) {
  const auto link = [&](const Point& point) { return vehicle.links[static_cast<std::size_t>(point.link)].name; };
  for (const Element& element : elements) table.Add({element.name, kind, link(element.parent), link(element.child)});
}

std::string Closures(const Vehicle& vehicle) {
  if (!vehicle.HasLoops() && vehicle.bushings.empty()) return "";
  TextTable table({"between links", "kind", "parent", "child"});
  AddJoined(vehicle, "rod", vehicle.rods, table);
  AddJoined(vehicle, "ball", vehicle.balls, table);
  AddJoined(vehicle, "hinge", vehicle.hinges, table);
  AddJoined(vehicle, "weld", vehicle.welds, table);
  AddJoined(vehicle, "bushing", vehicle.bushings, table);
  return table.Format() + '\n';
}

std::string Masses(const VehicleSummary& summary) {
  const auto mass = [](double kg) { return Fixed(kg, 1) + " kg"; };
  const Eigen::Vector3d& com = summary.com;
  const Eigen::Matrix3d& inertia = summary.inertia;
  // Rounding of a sum of symmetric parts.
  const double nothing = 1e-9 * inertia.trace();
  const auto moment = [&](const char* name, double value) {
    return std::string(name) + " " + Rounded(std::abs(value) < nothing ? 0 : value, 4);
  };
  std::string text = "mass            " + mass(summary.mass_kg);
  if (const std::optional<double> sprung = summary.SprungMass_kg())
    text += ": sprung " + mass(*sprung) + ", unsprung " + mass(*summary.ride.unsprung_mass_kg);
  text += "\ncentre of mass  x " + Fixed(com.x(), 3) + " m, y " + Fixed(com.y(), 3) + " m, z " + Fixed(com.z(), 3) +
          " m\ninertia, kg*m^2 " + moment("Ixx", inertia(0, 0)) + ", " + moment("Iyy", inertia(1, 1)) + ", " +
          moment("Izz", inertia(2, 2)) + ", " + moment("Ixy", inertia(0, 1)) + ", " + moment("Ixz", inertia(0, 2)) +
          ", " + moment("Iyz", inertia(1, 2)) + ", about the centre of mass\nweight          " +
          Rounded(summary.Weight_N(), 5) + " N";
  if (!summary.suspension.wheels.empty()) text += ", on the tyres " + Rounded(summary.TyreLoad_N(), 5) + " N";
  return text + "\n\n";
}

/// Whether wheels can move alone or together, which makes two rates of one.
bool HasPairs(const VehicleSummary& summary) {
  const std::vector<Axle>& axles = summary.suspension.axles;
  return std::any_of(axles.begin(), axles.end(), [](const Axle& axle) { return axle.wheels.size() > 1; });
}

std::vector<std::string> Head(std::vector<std::string> head, const std::vector<std::string>& more, bool with_more) {
  if (with_more) head.insert(head.end(), more.begin(), more.end());
  return head;
}

std::string Wheels(const VehicleSummary& summary) {
  if (summary.suspension.wheels.empty()) return "";
  const bool pairs = HasPairs(summary);
  TextTable table(Head({"tyre", "load, N", "tyre, N/mm", "wheel rate, N/mm", "ride rate, N/mm"},
                       {"wheel, together", "ride, together"}, pairs));
  for (std::size_t i = 0; i < summary.suspension.wheels.size(); ++i) {
    const WheelRates& rates = summary.ride.wheels[i];
    table.Add(Head({summary.suspension.wheels[i].name, Rounded(summary.corner_loads[i].load_N, 5),
                    InPerMm(rates.tyre_Npm), InPerMm(rates.alone.wheel_Npm), InPerMm(rates.alone.ride_Npm)},
                   {InPerMm(rates.together.wheel_Npm), InPerMm(rates.together.ride_Npm)}, pairs));
  }
  const char* note =
      "Chassis fixed. Wheel rate: at the contact point of a wheel that moves alone; together: with the other wheel of\n"
      "its axle. Ride rate: wheel rate in series with the tyre. Rates and roll stiffness are those of the loaded\n"
      "suspension: springs, bushings and geometric stiffness.\n";
  const char* short_note =
      "Chassis fixed. Wheel rate: at the contact point of a wheel, of the loaded suspension. Ride rate: wheel rate in\n"
      "series with the tyre.\n";
  return table.Format() + (pairs ? note : short_note) + '\n';
}

std::string OrDash(const std::optional<double>& value, double factor, int decimals) {
  return value ? Fixed(factor * *value, decimals) : "-";
}

std::string PerDegree(const std::optional<double>& stiffness_Nm) {
  return stiffness_Nm ? Rounded(*stiffness_Nm * std::numbers::pi / 180, 4) : "-";
}

std::string Axles(const VehicleSummary& summary) {
  if (summary.suspension.wheels.empty()) return "";
  const bool pairs = HasPairs(summary);
  TextTable table(Head({"axle", "load, N", "share, %", "unsprung, kg", "ride, Hz", "hop, Hz"},
                       {"roll, N*m/deg", "without loads", "on tyres", "centre, mm"}, pairs));
  for (std::size_t a = 0; a < summary.suspension.axles.size(); ++a) {
    const AxleNumbers& axle = summary.chassis.axles[a];
    table.Add(Head(
        {summary.suspension.axles[a].name, Rounded(axle.load_N, 5), Fixed(100 * axle.load_N / summary.TyreLoad_N(), 1),
         OrDash(axle.unsprung_kg, 1, 1), OrDash(axle.ride_Hz, 1, 3), OrDash(axle.hop_Hz, 1, 2)},
        {PerDegree(summary.ride.axles[a].roll_Nm), PerDegree(axle.elastic_roll_Nm), PerDegree(axle.roll_on_tyres_Nm),
         OrDash(axle.roll_centre_m, 1000, 1)},
        pairs));
  }
  return table.Format() +
         "Undamped, each axle alone: ride, sprung mass on ride rates; hop, unsprung mass on wheel and tyre rates.\n" +
         (pairs ? "Roll stiffness; without loads: of springs, bars and bushes alone; on tyres: with the tyres in "
                  "series.\n"
                  "Roll centre: above the feet.\n\n"
                : "\n");
}

std::string CornerRows(const VehicleSummary& summary) {
  TextTable table({"tyre", "sprung, kg", "bump, N*s/m", "rebound, N*s/m", "damping ratio, bump", "rebound"});
  bool is_damped = false;
  for (std::size_t i = 0; i < summary.suspension.wheels.size(); ++i) {
    const CornerNumbers& corner = summary.chassis.corners[i];
    is_damped = is_damped || corner.bump_Nspm > 0 || corner.rebound_Nspm > 0;
    table.Add({summary.suspension.wheels[i].name, OrDash(corner.sprung_kg, 1, 1), Rounded(corner.bump_Nspm, 4),
               Rounded(corner.rebound_Nspm, 4), OrDash(corner.bump_ratio, 1, 3), OrDash(corner.rebound_ratio, 1, 3)});
  }
  if (!is_damped) return "";
  return table.Format() +
         "At the wheel, at 0.1 m/s of each damper, without friction and mounts; ratio: of sprung mass on wheel "
         "rate.\n\n";
}

/// Of a car on two axles.
std::string HandlingRows(const VehicleSummary& summary) {
  const ChassisNumbers& chassis = summary.chassis;
  if (!chassis.wheelbase_m) return "";
  std::string text = "wheelbase       " + Fixed(1000 * *chassis.wheelbase_m, 1) + " mm, centre of mass " +
                     Fixed(1000 * chassis.com_height_m.value_or(0), 1) + " mm high\n";
  if (chassis.cross_weight)
    text += "weights         left " + Fixed(100 * *chassis.left_share, 2) + " %, front right and rear left " +
            Fixed(100 * *chassis.cross_weight, 2) + " %\n";
  if (chassis.roll_gradient) {
    text += "roll            " + Fixed(*chassis.roll_gradient * kGravity * 180 / std::numbers::pi, 2) +
            " deg/g, sprung centre of mass " + Fixed(1000 * *chassis.roll_arm_m, 1) +
            " mm above the roll axis\nload transfer  ";
    for (std::size_t a = 0; a < chassis.axles.size(); ++a)
      text += std::string(a == 0 ? " " : ", ") + summary.suspension.axles[a].name + " " +
              Rounded(chassis.axles[a].load_transfer.value_or(0) * kGravity, 4) + " N/g (" +
              OrDash(chassis.axles[a].load_transfer_share, 100, 1) + " %)";
    text += '\n';
  }
  const AxleNumbers& front = chassis.axles.front();
  const AxleNumbers& rear = chassis.axles.back();
  if (!front.anti_braking || !rear.anti_braking) return text + '\n';
  return text + "braking         anti-dive " + OrDash(front.anti_braking, 100, 1) + " %, rear anti-lift " +
         OrDash(rear.anti_braking, 100, 1) + " %, brakes at the wheels, forces shared as the loads" +
         (chassis.pitch_centre ? "\npitch centre    x " + Fixed(chassis.pitch_centre->x, 3) + " m, z " +
                                     Fixed(chassis.pitch_centre->z, 3) + " m"
                               : "") +
         "\ndriving         front anti-lift " + OrDash(front.anti_driving, 100, 1) + " %, anti-squat " +
         OrDash(rear.anti_driving, 100, 1) + " %, each axle alone, torque taken by " +
         (front.is_beam == rear.is_beam ? front.is_beam ? "the axles" : "the body"
          : front.is_beam               ? "the front axle and, of the rear one, by the body"
                                        : "the rear axle and, of the front one, by the body") +
         "\n\n";
}

std::string WheelName(const VehicleSummary& summary, const StrutGeometry& strut) {
  return strut.wheel < 0 ? "none" : summary.suspension.wheels[static_cast<std::size_t>(strut.wheel)].name;
}

std::string Springs(const Vehicle& vehicle, const VehicleSummary& summary) {
  if (vehicle.springs.empty()) return "";
  const bool pairs = HasPairs(summary);
  TextTable table(Head({"spring", "kind", "length, mm", "tension, N", "rate, N/mm", "moved by", "motion ratio"},
                       {"together"}, pairs));
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) {
    const StrutGeometry& strut = summary.ride.springs[i];
    const Spring& spring = vehicle.springs[i];
    table.Add(Head(
        {spring.name, KindName(spring.kind), Fixed(1000 * strut.length_m, 1), Rounded(summary.spring_tension[i], 5),
         InPerMm(strut.rate), WheelName(summary, strut), Ratio(strut.alone)},
        {Ratio(strut.together)}, pairs));
  }
  return table.Format() + '\n';
}

std::string Dampers(const Vehicle& vehicle, const VehicleSummary& summary) {
  if (vehicle.dampers.empty()) return "";
  const bool pairs = HasPairs(summary);
  TextTable table(Head({"damper", "length, mm", "mean rate, N*s/m", "moved by", "motion ratio"}, {"together"}, pairs));
  for (std::size_t i = 0; i < vehicle.dampers.size(); ++i) {
    const StrutGeometry& strut = summary.ride.dampers[i];
    table.Add(Head({vehicle.dampers[i].name, Fixed(1000 * strut.length_m, 1), Rounded(strut.rate, 4),
                    WheelName(summary, strut), Ratio(strut.alone)},
                   {Ratio(strut.together)}, pairs));
  }
  return table.Format() + '\n';
}

std::string AntiRollBars(const Vehicle& vehicle, const VehicleSummary& summary) {
  if (vehicle.antiroll_bars.empty()) return "";
  TextTable table({"anti-roll bar", "rate, N/mm", "moved by", "motion ratio"});
  for (std::size_t i = 0; i < vehicle.antiroll_bars.size(); ++i) {
    const StrutGeometry& strut = summary.ride.antiroll_bars[i];
    table.Add({vehicle.antiroll_bars[i].name, InPerMm(strut.rate), WheelName(summary, strut), Ratio(strut.alone)});
  }
  return table.Format() + '\n';
}

/// The greatest shares, of a tenth or more.
std::string Energy(const Mode& mode) {
  constexpr double kLeast = 0.1;
  constexpr std::size_t kMost = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(mode.energy.size(), kMost); ++i)
    if (mode.energy[i].share >= kLeast)
      text += (text.empty() ? "" : ", ") + mode.energy[i].motion + " " + Fixed(100 * mode.energy[i].share, 0);
  return text;
}

/// Of friction with a stiffness.
std::string StuckModes(const VehicleSummary& summary) {
  std::string modes;
  for (const Mode& mode : summary.stuck_modes)
    if (mode.frequency_Hz > 0 && mode.frequency_Hz <= kHighestMode_Hz)
      modes += (modes.empty() ? "" : ", ") + mode.name + " " + Fixed(mode.frequency_Hz, 3) + " Hz";
  if (summary.stuck_modes.empty()) return "";
  return "These are the modes while friction slides. While it sticks: " + (modes.empty() ? "none" : modes) + ".\n";
}

std::string ModeRows(const VehicleSummary& summary) {
  TextTable table({"mode", "Hz", "damped", "damping ratio", "kinetic energy, %"});
  std::size_t above = 0;
  for (const Mode& mode : summary.modes) {
    if (mode.frequency_Hz > kHighestMode_Hz) {
      ++above;
      continue;
    }
    std::string hertz = Fixed(mode.frequency_Hz, 3);
    std::string damping = Fixed(mode.damping_ratio, 3);
    if (mode.frequency_Hz == 0) hertz = damping = "-";
    const bool oscillates = mode.kind == Mode::Kind::kOscillating;
    table.Add({mode.name + (oscillates ? "" : std::string(", ") + KindName(mode.kind)), hertz,
               oscillates ? Fixed(mode.pole.imag() / (2 * std::numbers::pi), 3) : "-", damping, Energy(mode)});
  }
  const std::string more =
      above == 0 ? "" : std::to_string(above) + " more above " + Rounded(kHighestMode_Hz, 2) + " Hz\n";
  return table.Format() + more + StuckModes(summary) + '\n';
}

std::string Posts(const Vehicle& vehicle) {
  if (vehicle.posts.empty()) return "";
  TextTable table({"post", "under tyre"});
  for (const Post& post : vehicle.posts)
    table.Add({post.name, vehicle.tyres[static_cast<std::size_t>(post.tyre)].name});
  return table.Format() + '\n';
}

/// What a sensor is on, its axis and its place in the link's axes.
std::vector<std::string> Mounting(const Vehicle& vehicle, const Sensor& sensor) {
  const auto link = [&](const Point& point) { return vehicle.links[static_cast<std::size_t>(point.link)].name; };
  const Eigen::Vector3d& xyz = sensor.point.xyz;
  switch (sensor.type) {
    case Sensor::Type::kAccelerometer:
    case Sensor::Type::kDisplacement:
      return {link(sensor.point), AxisText(sensor.axis), Fixed(xyz.x(), 3), Fixed(xyz.y(), 3), Fixed(xyz.z(), 3)};
    case Sensor::Type::kGyro: return {link(sensor.point), AxisText(sensor.axis), "-", "-", "-"};
    case Sensor::Type::kStrut: return {link(sensor.line.parent) + " to " + link(sensor.line.child), "-", "-", "-", "-"};
    case Sensor::Type::kLoadCell:
      return {vehicle.tyres[static_cast<std::size_t>(sensor.tyre)].name, "-", "-", "-", "-"};
  }
  return {};
}

std::string Sensors(const Vehicle& vehicle) {
  if (vehicle.sensors.empty()) return "";
  TextTable table({"sensor", "kind", "on", "axis", "x, m", "y, m", "z, m"});
  for (const Sensor& sensor : vehicle.sensors)
    table.Add(Head({sensor.name, KindName(sensor.type)}, Mounting(vehicle, sensor), true));
  return table.Format() + '\n';
}

/// Words in lines no longer than this.
std::vector<std::string> WrappedLines(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::string rest = text;
  while (rest.size() > width) {
    const std::size_t blank = rest.rfind(' ', width);
    if (blank == std::string::npos || blank == 0) break;
    lines.push_back(rest.substr(0, blank));
    rest.erase(0, blank + 1);
  }
  lines.push_back(rest);
  return lines;
}

bool IsFree(const Parameter& parameter) { return parameter.upper > parameter.lower; }

std::string ShortInUnit(double si, const Parameter& parameter) {
  return Short(si / ParseUnit(parameter.unit.empty() ? "1" : parameter.unit)->si, 5);
}

std::string Range(const Parameter& parameter) {
  if (!IsFree(parameter)) return "fixed";
  return ShortInUnit(parameter.lower, parameter) + " .. " + ShortInUnit(parameter.upper, parameter);
}

/// The source comes last and takes as many lines as it needs.
std::string Parameters(const Vehicle& vehicle) {
  if (vehicle.parameters.empty()) return "";
  constexpr std::size_t kWidth = 108;
  const auto has = [&](auto known) {
    return std::any_of(vehicle.parameters.begin(), vehicle.parameters.end(),
                       [known](const Parameter& parameter) { return (parameter.*known).has_value(); });
  };
  const bool priors = has(&Parameter::prior_sd);
  const bool likes = has(&Parameter::like);
  const std::vector<std::string> head =
      Head(Head({"parameter", "value", "unit", "range"}, {"prior sd"}, priors), {"like", "like sd"}, likes);
  std::vector<std::vector<std::string>> rows;
  std::vector<std::size_t> widths;
  for (const std::string& cell : head) widths.push_back(cell.size());
  for (const Parameter& parameter : vehicle.parameters) {
    rows.push_back(
        Head(Head({parameter.name, ShortInUnit(parameter.value, parameter), parameter.unit, Range(parameter)},
                  {parameter.prior_sd ? ShortInUnit(*parameter.prior_sd, parameter) : "-"}, priors),
             {parameter.like ? parameter.like->parameter : "-", parameter.like ? Short(parameter.like->sd, 3) : "-"},
             likes));
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], rows.back()[i].size());
  }
  const std::size_t used = std::accumulate(widths.begin(), widths.end(), 2 * widths.size());
  TextTable table(Head(head, {"source"}, true));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const std::string& line : WrappedLines(vehicle.parameters[i].source, kWidth - std::min(used, kWidth / 2))) {
      table.Add(Head(rows[i], {line}, true));
      rows[i].assign(rows[i].size(), "");
    }
  }
  return table.Format() + '\n';
}

std::string Views(const VehicleSummary& summary) {
  if (summary.views.empty()) return "";
  TextTable table({"parameter", "most sensitive", "second", "third"});
  for (const ParameterView& view : summary.views) {
    std::array<std::string, 3> cells;
    for (std::size_t i = 0; i < std::min(view.channels.size(), cells.size()); ++i)
      cells[i] =
          view.channels[i].sensor + " " + Fixed(view.channels[i].sensitivity, 2) + " " + view.channels[i].excitation;
    if (view.channels.empty()) cells[0] = view.in_curved_law ? "not in the linear model" : "none";
    table.Add({view.parameter, cells[0], cells[1], cells[2]});
  }
  return table.Format() +
         "Sensitivity of the sensor's FRF, 0.5 to 30 Hz, in % per % of the parameter (at least per % of half its\n"
         "range), for the motion of the posts with the largest; small motion, mean damper rates.\n";
}

std::string MobilityText(const Mobility& mobility) {
  std::string text = std::to_string(mobility.dof) + " degrees of freedom";
  if (mobility.loop_equations == 0) return text + '\n';
  text += ": " + std::to_string(mobility.joint_coordinates) + " of the joints less " +
          std::to_string(mobility.independent_equations) + " of loops, closed within " +
          FormatQuantity(std::ceil(mobility.loop_residual * 1e12) * 1e-12, "mm") + '\n';
  if (mobility.redundant.empty()) return text;
  text += "redundant:";
  for (std::size_t i = 0; i < mobility.redundant.size(); ++i) text += (i > 0 ? ", " : " ") + mobility.redundant[i];
  return text + '\n';
}

}  // namespace

std::string DescribeJoint(const Joint& joint) {
  switch (joint.type) {
    case Joint::Type::kFixed: return "fixed";
    case Joint::Type::kRevolute: return "revolute " + AxisText(joint.axis);
    case Joint::Type::kPrismatic: return "prismatic " + AxisText(joint.axis);
    case Joint::Type::kPlanar: return "planar " + AxisText(joint.axis);
    case Joint::Type::kFloating: return "floating";
  }
  return "";
}

const char* KindName(Sensor::Type type) {
  switch (type) {
    case Sensor::Type::kAccelerometer: return "accelerometer";
    case Sensor::Type::kDisplacement: return "displacement";
    case Sensor::Type::kStrut: return "strut";
    case Sensor::Type::kLoadCell: return "load cell";
    case Sensor::Type::kGyro: return "gyro";
  }
  return "";
}

std::string CheckText(const CheckedVehicle& checked) {
  const auto& [vehicle, mobility, summary] = checked;
  return vehicle.name + ": " + MobilityText(mobility) + '\n' + Tree(vehicle).Format() + '\n' + Closures(vehicle) +
         Masses(summary) + Wheels(summary) + Axles(summary) + CornerRows(summary) + HandlingRows(summary) +
         Springs(vehicle, summary) + Dampers(vehicle, summary) + AntiRollBars(vehicle, summary) + ModeRows(summary) +
         Posts(vehicle) + Sensors(vehicle) + Parameters(vehicle) + Views(summary);
}

}  // namespace fourpost
