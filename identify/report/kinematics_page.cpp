#include "identify/report/kinematics_page.h"

#include <cctype>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "analysis/report/html.h"
#include "analysis/report/shown_number.h"
#include "identify/report/travels_json.h"
#include "identify/report/vehicle_page.h"

namespace fourpost {
namespace {

using html::NumberCell;
using html::TextCell;

constexpr double kDeg = 180 / std::numbers::pi;
constexpr double kMm = 1000;
/// Below what a picture shows.
constexpr double kUnmovedRatio = 1e-4;

using OfStation = std::function<double(const AxleStation&)>;
using OfWheel = std::function<double(const WheelStation&)>;

/// What rounding leaves of zero, in degrees or millimetres, is zero.
double WithoutRounding(double value) { return std::abs(value) < 1e-9 ? 0 : value; }

double OrNan(const std::optional<double>& value) { return value.value_or(NAN); }

/// One axle with what its sections need.
class AxlePart {
 public:
  AxlePart(const Suspension& suspension, const AxleKinematics& kinematics)
      : kinematics_(kinematics), axle_(suspension.axles[kinematics.axle]) {
    for (const std::size_t i : axle_.wheels) wheels_.push_back(&suspension.wheels[i]);
  }

  std::vector<CurveGroup> Groups() const {
    std::vector<CurveGroup> groups;
    for (const AxleTravel& travel : kinematics_.travels) groups.push_back(GroupOf(travel));
    return groups;
  }

  ReportSection Section(const std::vector<CurveGroup>& groups) const {
    std::string html = GradientsHtml();
    for (std::size_t i = 0; i < groups.size(); ++i)
      html += html::Element("h3", "", html::Escaped(TitleOf(kinematics_.travels[i]))) + '\n' +
              CurvesHtml(groups[i], "wheels.csv");
    return {"axle-" + std::to_string(kinematics_.axle + 1), "Axle " + axle_.name, html + ComplianceHtml()};
  }

 private:
  static std::string TitleOf(const AxleTravel& travel) {
    switch (travel.kind) {
      case AxleTravel::Kind::kHeave: return "Heave";
      case AxleTravel::Kind::kRoll: return "Roll: the right wheel rises as the left one falls";
      case AxleTravel::Kind::kWheel: return travel.name + " alone";
    }
    return "";
  }

  static CurveGroup::Line LineOf(const AxleTravel& travel, const std::string& label, const OfStation& value) {
    CurveGroup::Line line{label, {}};
    for (const AxleStation& station : travel.stations) line.values.push_back(value(station));
    return line;
  }

  CurveGroup::Chart OfWheels(const AxleTravel& travel, const std::string& title, const std::string& unit, double least,
                             const OfWheel& value) const {
    CurveGroup::Chart chart{.title = title, .unit = unit, .least = least, .lines = {}};
    for (std::size_t k = 0; k < wheels_.size(); ++k)
      chart.lines.push_back(
          LineOf(travel, wheels_[k]->name, [&](const AxleStation& station) { return value(station.wheels[k]); }));
    return chart;
  }

  CurveGroup::Chart Ratios(const AxleTravel& travel) const {
    CurveGroup::Chart chart{.title = "motion ratio", .unit = "", .least = 0.01, .lines = {}};
    for (std::size_t i = 0; i < kinematics_.struts.size(); ++i)
      if (kinematics_.struts[i].kind != AxleStrut::Kind::kStop && std::abs(travel.Design().ratios[i]) > kUnmovedRatio)
        chart.lines.push_back(
            LineOf(travel, kinematics_.struts[i].name, [i](const AxleStation& station) { return station.ratios[i]; }));
    return chart;
  }

  /// What an axle has in heave besides its wheels' angles.
  void AddAxle(const AxleTravel& heave, std::vector<CurveGroup::Chart>& charts) const {
    const auto add = [&](const char* title, std::optional<double> AxleStation::*member) {
      if (heave.Design().*member)
        charts.push_back(
            {.title = title, .unit = "mm", .least = 2, .lines = {LineOf(heave, "axle", [=](const AxleStation& station) {
                                                         return kMm * OrNan(station.*member);
                                                       })}});
    };
    add("track", &AxleStation::track);
    add("wheelbase", &AxleStation::wheelbase);
    add("roll centre height", &AxleStation::roll_centre);
    CurveGroup::Chart forward{.title = "wheel centre forward", .unit = "mm", .least = 2, .lines = {}};
    for (std::size_t k = 0; k < wheels_.size(); ++k)
      forward.lines.push_back(LineOf(heave, wheels_[k]->name, [&](const AxleStation& station) {
        return kMm * (station.wheels[k].place.centre.x() - heave.Design().wheels[k].place.centre.x());
      }));
    charts.push_back(std::move(forward));
  }

  CurveGroup GroupOf(const AxleTravel& travel) const {
    CurveGroup group{.id = "axle_" + std::to_string(kinematics_.axle + 1) + '_' + travel.name,
                     .title = axle_.name + ' ' + travel.name,
                     .x_name = "travel",
                     .x_unit = "mm",
                     .x = {},
                     .charts = {}};
    for (const AxleStation& station : travel.stations) group.x.push_back(kMm * station.travel);
    group.charts = {
        OfWheels(travel, "camber", "deg", 0.04, [](const WheelStation& wheel) { return kDeg * wheel.place.camber; }),
        OfWheels(travel, "toe-in", "deg", 0.04, [](const WheelStation& wheel) { return kDeg * wheel.place.toe; }),
        OfWheels(travel, "load", "kN", 0.04, [](const WheelStation& wheel) { return wheel.load / 1000; })};
    if (CurveGroup::Chart ratios = Ratios(travel); !ratios.lines.empty()) group.charts.push_back(std::move(ratios));
    if (travel.kind == AxleTravel::Kind::kHeave) AddAxle(travel, group.charts);
    return group;
  }

  /// In the design pose, a column per wheel.
  std::string GradientsHtml() const {
    std::vector<std::string> head = {"in the design pose", "unit"};
    for (const Wheel* wheel : wheels_) head.push_back(wheel->name);
    std::vector<std::vector<html::Cell>> rows;
    const auto add = [&](const char* name, const char* unit, const AxleStation& station, const OfWheel& value) {
      rows.push_back({TextCell(name), TextCell(ShownUnit(unit))});
      for (const WheelStation& wheel : station.wheels)
        rows.back().push_back(NumberCell(ShownNumber(WithoutRounding(value(wheel)), 4)));
    };
    const AxleStation& heave = kinematics_.travels.front().Design();
    add("camber", "deg", heave, [](const WheelStation& wheel) { return kDeg * wheel.place.camber; });
    add("toe-in", "deg", heave, [](const WheelStation& wheel) { return kDeg * wheel.place.toe; });
    add("bump camber", "deg/m", heave, [](const WheelStation& wheel) { return kDeg * wheel.rate.camber; });
    add("bump toe-in", "deg/m", heave, [](const WheelStation& wheel) { return kDeg * wheel.rate.toe; });
    add("wheel centre forward in bump", "mm/m", heave,
        [](const WheelStation& wheel) { return kMm * wheel.rate.centre.x(); });
    rows.push_back({TextCell("foot outward in bump"), TextCell(ShownUnit("mm/m"))});
    for (std::size_t k = 0; k < wheels_.size(); ++k)
      rows.back().push_back(NumberCell(
          ShownNumber(WithoutRounding(kMm * heave.wheels[k].rate.foot.y() * (wheels_[k]->side < 0 ? -1 : 1)), 4)));
    for (const AxleTravel& travel : kinematics_.travels) {
      if (travel.kind != AxleTravel::Kind::kRoll) continue;
      const AxleStation& roll = travel.Design();
      add("roll camber to the body", "deg/deg", roll,
          [&](const WheelStation& wheel) { return wheel.rate.camber / roll.roll_rate; });
      add("roll steer", "deg/deg", roll, [&](const WheelStation& wheel) { return wheel.rate.steer / roll.roll_rate; });
    }
    return html::Table(head, rows) + AxleLineHtml(heave);
  }

  /// What is of the axle, not of a wheel.
  static std::string AxleLineHtml(const AxleStation& heave) {
    std::string text;
    const auto add = [&](const char* name, const std::optional<double>& metres) {
      if (metres)
        text += (text.empty() ? "" : ", ") + std::string(name) + ' ' + ShownDecimals(kMm * *metres, 1) + " mm";
    };
    add("track", heave.track);
    add("wheelbase", heave.wheelbase);
    add("roll centre height", heave.roll_centre);
    if (text.empty()) return "";
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return html::Element("p", "note", html::Escaped(text + ", in the design pose.")) + '\n';
  }

  std::string ComplianceHtml() const {
    if (kinematics_.compliance.empty()) return "<p class=\"note\">Rigid linkage: no compliance.</p>\n";
    std::vector<std::vector<html::Cell>> rows;
    for (const AxleCompliance& answer : kinematics_.compliance) {
      const bool is_torque = answer.load == WheelLoad::kAligning;
      const double size = is_torque ? 100 : 1000;
      for (std::size_t k = 0; k < answer.wheels.size(); ++k) {
        rows.push_back({TextCell(LoadName(answer.load)), TextCell(answer.is_opposed ? "opposed" : "together"),
                        TextCell(ShownUnit(is_torque ? "100 N*m" : "kN")), TextCell(wheels_[k]->name)});
        const WheelPlace& wheel = answer.wheels[k];
        for (const double angle : {wheel.steer, wheel.toe, wheel.camber})
          rows.back().push_back(NumberCell(ShownNumber(size * kDeg * angle, 3)));
        for (const double way : {wheel.centre.x(), wheel.centre.y()})
          rows.back().push_back(NumberCell(ShownNumber(size * kMm * way, 3)));
      }
    }
    return "<h3>Compliance</h3>\n" + html::Table({"load", "wheels", "per", "wheel", "steer, deg", "toe-in, deg",
                                                  "camber, deg", "centre forward, mm", "to the left, mm"},
                                                 rows);
  }

  const AxleKinematics& kinematics_;
  const Axle& axle_;
  std::vector<const Wheel*> wheels_;
};

constexpr const char* kNote =
    "<p class=\"note\">Chassis held in the design pose, other axles' wheels at their height there; travel: rise of the "
    "wheel centres. Camber: top outward positive, so that of roll has the other sign on the right wheel. Steer: to the "
    "left positive. Motion ratio: shortening per travel; of "
    "an anti-roll bar the difference of its lines per travel. Loads: lateral to the left and braking at the foot, "
    "driving at the wheel centre, aligning torque to the left.</p>\n";

}  // namespace

std::string KinematicsPage(SuspensionRig& rig, const std::vector<AxleKinematics>& axles, const Diagnostics& findings) {
  VehicleAnswer page{.facts = {"kinematics and compliance"},
                     .file = "",
                     .findings = findings,
                     .viewer_title = "Travel of the wheels, chassis held",
                     .shows_modes = false};
  for (const AxleKinematics& kinematics : axles) {
    const AxlePart part(rig.suspension(), kinematics);
    std::vector<CurveGroup> groups = part.Groups();
    page.after.push_back(part.Section(groups));
    for (CurveGroup& group : groups) page.curves.push_back(std::move(group));
  }
  page.after.back().html += kNote;
  page.scene = {{"first", "travel"}, {"travels", TravelsJson(rig, axles)}};
  return VehiclePage(rig.vehicle(), page);
}

}  // namespace fourpost
