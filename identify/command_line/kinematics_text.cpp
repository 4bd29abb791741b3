#include "identify/command_line/kinematics_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "analysis/text/text_table.h"

namespace fourpost {
namespace {

constexpr double kPerDeg = 180 / std::numbers::pi;
constexpr double kPerMm = 1000;

/// Zero has no sign.
std::string WithDecimals(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value) < 0.5 * std::pow(10, -decimals) ? 0 : value);
  return text;
}

class AxleText {
 public:
  AxleText(const Suspension& suspension, const AxleKinematics& kinematics)
      : kinematics_(kinematics), axle_(suspension.axles[kinematics.axle]) {
    for (const std::size_t i : axle_.wheels) wheels_.push_back(&suspension.wheels[i]);
    is_symmetric_ = IsSymmetric();
    has_even_loads_ = is_symmetric_ && HasEvenLoads();
  }

  std::string Format() {
    std::string text = "axle '" + axle_.name + "'\n" + Gradients();
    for (const AxleTravel& travel : kinematics_.travels)
      // The other side of a symmetric axle says the same.
      if (travel.kind != AxleTravel::Kind::kWheel || !has_even_loads_ || wheels_[travel.wheel]->side > 0)
        text += '\n' + Positions(travel);
    return text + '\n' + Compliance();
  }

 private:
  /// One column per wheel; one for both where they are alike.
  using OfWheel = std::function<double(const AxleStation&, std::size_t)>;

  /// Less than shows in any column.
  static bool AreAlike(double a, double b) { return std::abs(a - b) < 1e-6; }

  bool IsSymmetric() const {
    if (wheels_.size() != 2) return false;
    return std::all_of(Heave().stations.begin(), Heave().stations.end(), [](const AxleStation& station) {
      const WheelPlace& left = station.wheels[0].place;
      const WheelPlace& right = station.wheels[1].place;
      return AreAlike(left.camber, right.camber) && AreAlike(left.toe, right.toe) &&
             AreAlike(left.centre.x(), right.centre.x());
    });
  }

  /// A car whose weight is not in the middle has uneven ones on symmetric axles.
  bool HasEvenLoads() const {
    constexpr double kShown_N = 0.5;
    return std::all_of(Heave().stations.begin(), Heave().stations.end(), [](const AxleStation& station) {
      return std::abs(station.wheels[0].load - station.wheels[1].load) < kShown_N;
    });
  }

  const AxleTravel& Heave() const { return kinematics_.travels.front(); }
  const AxleTravel* Roll() const {
    for (const AxleTravel& travel : kinematics_.travels)
      if (travel.kind == AxleTravel::Kind::kRoll) return &travel;
    return nullptr;
  }

  /// Wheels that have columns of their own.
  std::vector<std::size_t> Shown(bool is_alike) const {
    std::vector<std::size_t> shown;
    for (std::size_t k = 0; k < wheels_.size(); ++k)
      if (!is_alike || !is_symmetric_ || k == 0) shown.push_back(k);
    return shown;
  }

  std::string Gradients() const {
    const AxleStation& heave = Heave().Design();
    const std::vector<std::size_t> shown = Shown(true);
    std::vector<std::string> head = {"in the design pose", "unit"};
    for (const std::size_t k : shown) head.push_back(is_symmetric_ ? "each wheel" : wheels_[k]->name);
    TextTable table(head);
    const auto add = [&](const char* name, const char* unit, int decimals, const OfWheel& value,
                         const AxleStation& station) {
      std::vector<std::string> row = {name, unit};
      for (const std::size_t k : shown) row.push_back(WithDecimals(value(station, k), decimals));
      table.Add(row);
    };
    const auto place = [](auto member) {
      return [member](const AxleStation& station, std::size_t k) { return kPerDeg * station.wheels[k].place.*member; };
    };
    add("camber", "deg", 3, place(&WheelPlace::camber), heave);
    add("toe-in", "deg", 3, place(&WheelPlace::toe), heave);
    const auto rate = [](auto member) {
      return [member](const AxleStation& station, std::size_t k) { return kPerDeg * station.wheels[k].rate.*member; };
    };
    add("bump camber", "deg/m", 2, rate(&WheelPlace::camber), heave);
    add("bump toe-in", "deg/m", 2, rate(&WheelPlace::toe), heave);
    add(
        "wheel centre forward in bump", "mm/m", 1,
        [](const AxleStation& station, std::size_t k) { return 1000 * station.wheels[k].rate.centre.x(); }, heave);
    add(
        "foot outward in bump", "mm/m", 1,
        [this](const AxleStation& station, std::size_t k) {
          return 1000 * station.wheels[k].rate.foot.y() * (wheels_[k]->side < 0 ? -1 : 1);
        },
        heave);
    if (const AxleTravel* const roll = Roll()) {
      const AxleStation& station = roll->Design();
      // Opposite on the right; both wheels steer alike.
      add(
          is_symmetric_ ? "roll camber to the body, left wheel" : "roll camber to the body", "deg/deg", 3,
          [](const AxleStation& s, std::size_t k) { return s.wheels[k].rate.camber / s.roll_rate; }, station);
      add(
          "roll steer", "deg/deg", 4,
          [](const AxleStation& s, std::size_t k) { return s.wheels[k].rate.steer / s.roll_rate; }, station);
    }
    return table.Format() + AxleLine(heave);
  }

  std::string AxleLine(const AxleStation& heave) const {
    std::string text;
    const auto add = [&](const char* name, const std::optional<double>& metres) {
      if (metres)
        text += (text.empty() ? "" : ", ") + std::string(name) + " " + WithDecimals(kPerMm * *metres, 1) + " mm";
    };
    add("track", heave.track);
    add("wheelbase", heave.wheelbase);
    add("roll centre height", heave.roll_centre);
    return text.empty() ? "" : text + '\n';
  }

  /// Seven at most, both ends and the design pose among them.
  static std::vector<const AxleStation*> Some(const AxleTravel& travel) {
    constexpr std::size_t kSide = 3;
    const std::vector<AxleStation>& all = travel.stations;
    const auto design = static_cast<std::size_t>(&travel.Design() - all.data());
    std::vector<const AxleStation*> some;
    const auto add = [&](std::size_t index) {
      if (some.empty() || some.back() != &all[index]) some.push_back(&all[index]);
    };
    for (std::size_t i = 0; i < kSide; ++i) add(design * i / kSide);
    for (std::size_t i = 0; i <= kSide; ++i) add(design + (all.size() - 1 - design) * i / kSide);
    return some;
  }

  struct Column {
    std::string head;
    std::function<std::string(const AxleStation&)> cell;
  };

  std::string Positions(const AxleTravel& travel) const {
    using Kind = AxleTravel::Kind;
    std::vector<Column> columns = {{travel.kind == Kind::kHeave  ? "heave, mm"
                                    : travel.kind == Kind::kRoll ? "roll, mm"
                                                                 : travel.name + " alone, mm",
                                    [this](const AxleStation& s) {
                                      return WithDecimals(kPerMm * s.travel, 1) +
                                             (kinematics_.IsBeyondStops(s) ? " *" : "");
                                    }}};
    if (travel.kind == Kind::kRoll)
      columns.push_back({"deg", [](const AxleStation& s) { return WithDecimals(kPerDeg * s.roll, 2); }});
    const bool is_heave = travel.kind == Kind::kHeave;
    const auto add = [&](const std::string& name, int decimals, bool is_alike, const OfWheel& value) {
      const std::vector<std::size_t> shown = Shown(is_alike);
      for (const std::size_t k : shown) {
        if (travel.kind == Kind::kWheel && k != travel.wheel) continue;
        const bool is_named = travel.kind != Kind::kWheel && shown.size() > 1;
        columns.push_back({(is_named ? wheels_[k]->name + " " : "") + name,
                           [=](const AxleStation& s) { return WithDecimals(value(s, k), decimals); }});
      }
    };
    add("camber, deg", 3, is_heave,
        [](const AxleStation& s, std::size_t k) { return kPerDeg * s.wheels[k].place.camber; });
    add("toe-in, deg", 3, is_heave,
        [](const AxleStation& s, std::size_t k) { return kPerDeg * s.wheels[k].place.toe; });
    add("load, N", 0, is_heave && has_even_loads_,
        [](const AxleStation& s, std::size_t k) { return s.wheels[k].load; });
    if (is_heave) AddAxle(columns);
    AddRatios(travel, columns);
    std::vector<std::string> head;
    for (const Column& column : columns) head.push_back(column.head);
    TextTable table(head);
    for (const AxleStation* const station : Some(travel)) {
      std::vector<std::string> row;
      for (const Column& column : columns) row.push_back(column.cell(*station));
      table.Add(row);
    }
    const bool is_beyond = std::any_of(travel.stations.begin(), travel.stations.end(),
                                       [this](const AxleStation& s) { return kinematics_.IsBeyondStops(s); });
    return table.Format() +
           (is_beyond ? "* a wheel is beyond its last stop, which begins at " + StopsText() + '\n' : "");
  }

  /// "-60.0 and 73.2 mm of heave"
  std::string StopsText() const {
    std::string text;
    for (const std::optional<double>& stop : {kinematics_.stop_lower, kinematics_.stop_upper})
      if (stop) text += (text.empty() ? "" : " and ") + WithDecimals(kPerMm * *stop, 1);
    return text + " mm of heave";
  }

  void AddAxle(std::vector<Column>& columns) const {
    const auto add = [&](const char* head, std::optional<double> AxleStation::*member) {
      if (Heave().Design().*member)
        columns.push_back({head, [=](const AxleStation& s) { return WithDecimals(kPerMm * (s.*member).value(), 1); }});
    };
    add("track, mm", &AxleStation::track);
    add("wheelbase, mm", &AxleStation::wheelbase);
    add("roll centre, mm", &AxleStation::roll_centre);
  }

  /// Each different one once: coaxial struts and those of the other side say the same; in roll and one-wheel travel
  /// those that heave does not show already.
  void AddRatios(const AxleTravel& travel, std::vector<Column>& columns) const {
    const auto differs = [&](std::size_t i, const AxleTravel& other, std::size_t j) {
      return !AreAlike(std::abs(travel.Design().ratios[i]), std::abs(other.Design().ratios[j]));
    };
    for (std::size_t i = 0; i < kinematics_.struts.size(); ++i) {
      bool is_new = !AreAlike(travel.Design().ratios[i], 0);
      for (std::size_t j = 0; j < i; ++j) is_new = is_new && differs(i, travel, j);
      if (&travel != &Heave()) is_new = is_new && differs(i, Heave(), i);
      if (is_new)
        columns.push_back({KindName(kinematics_.struts[i].kind) + (" " + kinematics_.struts[i].name),
                           [i](const AxleStation& s) { return WithDecimals(s.ratios[i], 4); }});
    }
  }

  std::string Compliance() const {
    if (kinematics_.compliance.empty()) return "rigid linkage: no compliance\n";
    TextTable table({"both wheels loaded", "per", "wheel", "steer, deg", "toe-in, deg", "camber, deg",
                     "centre forward, mm", "to the left, mm"});
    for (const AxleCompliance& answer : kinematics_.compliance) {
      if (answer.is_opposed) continue;
      const bool is_torque = answer.load == WheelLoad::kAligning;
      const double size = is_torque ? 100 : 1000;
      for (std::size_t k = 0; k < answer.wheels.size(); ++k) {
        const WheelPlace& wheel = answer.wheels[k];
        table.Add({k == 0 ? LoadName(answer.load) : "", k == 0 ? (is_torque ? "100 N*m" : "kN") : "", wheels_[k]->name,
                   WithDecimals(size * kPerDeg * wheel.steer, 4), WithDecimals(size * kPerDeg * wheel.toe, 4),
                   WithDecimals(size * kPerDeg * wheel.camber, 4), WithDecimals(size * kPerMm * wheel.centre.x(), 3),
                   WithDecimals(size * kPerMm * wheel.centre.y(), 3)});
      }
    }
    return table.Format();
  }

  const AxleKinematics& kinematics_;
  const Axle& axle_;
  std::vector<const Wheel*> wheels_;
  bool is_symmetric_ = false;
  bool has_even_loads_ = false;
};

constexpr const char* kNote =
    "Chassis held in the design pose, other axles' wheels at their height there; travel: rise of the wheel\n"
    "centres. The wheel's axis is the y axis of its tyre's link. Camber: top outward positive. Roll: the right\n"
    "wheel rises as the left one falls, body to the right; roll camber has the other sign on the right wheel of\n"
    "a symmetric axle. Steer: to the left positive. Motion ratio: shortening per travel; of an anti-roll bar\n"
    "difference of its lines per travel. Roll centre: above the feet. ";
constexpr const char* kLoadNote =
    "Loads: lateral to the left and braking at the\nfoot, driving at the wheel centre, aligning torque to the left; "
    "pads "
    "keep their heights and float in the plane.\n";

}  // namespace

std::string KinematicsText(const Suspension& suspension, const std::vector<AxleKinematics>& axles) {
  std::string text;
  bool yields = false;
  for (const AxleKinematics& kinematics : axles) {
    text += AxleText(suspension, kinematics).Format() + '\n';
    yields = yields || !kinematics.compliance.empty();
  }
  return text + kNote + (yields ? kLoadNote : "\n");
}

}  // namespace fourpost
