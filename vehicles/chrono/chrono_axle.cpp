#include "vehicles/chrono/chrono_axle.h"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "analysis/text/number.h"
#include "vehicles/chrono/chrono_body.h"
#include "vehicles/chrono/chrono_kinds.h"
#include "vehicles/chrono/chrono_laws.h"
#include "vehicles/chrono/findings.h"

namespace fourpost {
namespace {

using Eigen::Vector3d;

/// Reads one suspension file; points of Chrono are those of the left side in the suspension's frame.
class AxleReader {
 public:
  AxleReader(const ChronoNode& file, const ChronoNode& entry, std::string axle, const ChronoTyre& tyre,
             const ChronoMotion& motion)
      : file_(file),
        entry_(entry),
        axle_(std::move(axle)),
        tyre_(tyre),
        motion_(motion),
        offset_(entry.Vector("Suspension Location")) {
    result_.known.source = "Chrono, " + file.path().filename().string();
  }

  ChronoAxle Read(void (AxleReader::*read)(), const SuspensionKind* kind) {
    result_.kind = kind;
    ReadWheel();
    (this->*read)();
    return std::move(result_);
  }

  void DoubleWishbone() {
    const ChronoNode lower = file_.Child("Lower Control Arm");
    const ChronoNode upper = file_.Child("Upper Control Arm");
    ArmPoints(lower, "lower");
    ArmPoints(upper, "upper");
    TieRod("Location Upright");
    Keep("lower_arm", ChronoBody(lower, offset_));
    Keep("upper_arm", ChronoBody(upper, offset_));
    Knuckle(ChronoBody(file_.Child("Upright"), offset_));
    Struts("Location Arm", "lower_arm");
    AntiRollBar("lower_arm");
  }

  void MacPherson() {
    const ChronoNode arm = file_.Child("Control Arm");
    ArmPoints(arm, "lower");
    TieRod("Location Upright");
    Keep("lower_arm", ChronoBody(arm, offset_));
    const Vector3d top = Place("Shock", "Location Chassis");
    const Vector3d bottom = Place("Shock", "Location Upright");
    Add("strut_top", top);
    Add("strut_bottom", Moved("knuckle", bottom));
    const KnownBody strut = MaybeChronoBody(file_, "Strut", offset_, 0.5 * (top + bottom));
    Knuckle(ChronoBody(file_.Child("Upright"), offset_) + HalfAt(strut, bottom));
    OnBody(HalfAt(strut, top));
    const Vector3d seat = Place("Spring", "Location Chassis");
    const Vector3d plate = Place("Spring", "Location Upright");
    const double apart = std::max((seat - top).norm(), (plate - bottom).norm());
    if (apart > 1e-3)
      file_.ReportAt("Spring", kChronoStrutApart, {file_.Called(), FormatNumber(std::round(1e3 * apart)) + " mm"});
    // Free lengths and stops are those of the coil, which is shorter than its strut.
    Laws((seat - Moved("knuckle", plate)).norm(), (top - Moved("knuckle", bottom)).norm());
    AntiRollBar("lower_arm");
  }

  void SemiTrailingArm() {
    const ChronoNode arm = file_.Child("Trailing Arm");
    Add("pivot_inner", offset_ + arm.Vector("Location Chassis Inner"));
    Add("pivot_outer", offset_ + arm.Vector("Location Chassis Outer"));
    Keep("arm", ChronoBody(arm, offset_));
    Struts("Location Arm", "arm");
    AntiRollBar("arm");
  }

  void SolidAxle() {
    KnownBody axle = Beam();
    const auto link = [&](const char* name, const std::string& point) {
      const Vector3d on_body = Place(name, "Location Chassis");
      const Vector3d on_axle = Place(name, "Location Axle");
      Add(point + "_body", on_body);
      Add(point + "_axle", Moved("axle", on_axle));
      const KnownBody rod = ChronoBody(file_.Child(name), offset_);
      axle = axle + HalfAt(rod, on_axle) + HalfAt(rod, on_axle).Mirrored();
      // The upper links are bodies, on bushes.
      if (point == "upper") Keep("upper_link", HalfAt(rod, on_body));
      else OnBody(HalfAt(rod, on_body));
    };
    link("Lower Link", "lower");
    link("Upper Link", "upper");
    Keep("axle", axle + Single("Trackbar", "panhard"));
    Struts("Location Axle", "axle");
  }

  void GuidedPanhard() {
    Keep("axle", Beam() + Single("Panhard Rod", "panhard"));
    Struts("Location Axle", "axle");
    const ChronoNode bar = file_.Child("Anti Roll Bar");
    const Vector3d end = Place("Anti Roll Bar", "Location Axle");
    const double arm = end.x() - Place("Anti Roll Bar", "Location Chassis").x();
    // Its drop link is a point on a plane, and stands for a short one.
    Bar(Moved("axle", end) + Vector3d(0, 0, 0.1), Moved("axle", end), bar.Number("Rotational Stiffness"), arm, "");
    OnBody(ChronoBody(bar, offset_, end));
  }

  void GuidedLeaf() {
    Keep("axle", Beam());
    Struts("Location Axle", "axle");
  }

 private:
  void Add(const std::string& name, const Vector3d& place, const std::string& on = "") {
    result_.points.push_back({.axle = axle_, .name = name, .xyz = place, .on = on});
  }

  Vector3d Moved(std::string_view part, const Vector3d& place) const {
    const auto found = motion_.find(part);
    return found == motion_.end() ? place : found->second * place;
  }

  /// A body of the left side, or of both.
  void Keep(const std::string& part, KnownBody body) {
    if (const auto found = motion_.find(part == "wheel" ? WheelCarrier() : part); found != motion_.end()) {
      body.com = found->second * body.com;
      // A wheel's link is turned with it.
      if (part != "wheel")
        body.inertia = (found->second.linear() * body.inertia * found->second.linear().transpose()).eval();
    }
    // Chrono takes inertias that no body has.
    result_.known.bodies[part] = body.Possible();
  }

  /// The part that carries the wheel.
  std::string WheelCarrier() const {
    if (result_.kind->is_beam) return "axle";
    return result_.kind->name == "semi_trailing_arm" ? "arm" : "knuckle";
  }

  Vector3d Place(const char* part, const char* point) const { return offset_ + file_.Child(part).Vector(point); }

  /// Counts on both sides of the chassis.
  void OnBody(const KnownBody& half) {
    if (half.mass > 0) result_.on_body = result_.on_body + half + half.Mirrored();
  }

  /// A single rod, on either side: its half on the axle.
  KnownBody Single(const char* name, const std::string& point) {
    const Vector3d on_body = Place(name, "Location Chassis");
    const Vector3d on_axle = Place(name, "Location Axle");
    Add(point + "_body", on_body);
    Add(point + "_axle", Moved("axle", on_axle));
    const KnownBody rod = MaybeChronoBody(file_, name, offset_, on_axle);
    if (rod.mass > 0) result_.on_body = result_.on_body + HalfAt(rod, on_body);
    return HalfAt(rod, on_axle);
  }

  void ReadWheel() {
    const ChronoNode spindle = file_.Child("Spindle");
    centre_ = offset_ + spindle.Vector("COM");
    Add("wheel_centre", Moved(WheelCarrier(), centre_));
    const double degree = std::numbers::pi / 180;
    const double camber = file_.MaybeNumber("Camber Angle (deg)").value_or(0) * degree;
    const double toe = file_.MaybeNumber("Toe Angle (deg)").value_or(0) * degree;
    wheel_ = ChronoBody(spindle, offset_);
    wheel_.mass += tyre_.mass;
    wheel_.inertia.diagonal() += tyre_.inertia;
    if (result_.kind->is_beam) return;
    Keep("wheel", wheel_);
    // The left spindle is turned by -toe about z, then by -camber about x.
    const Vector3d axis =
        Eigen::AngleAxisd(-toe, Vector3d::UnitZ()) * Eigen::AngleAxisd(-camber, Vector3d::UnitX()) * Vector3d::UnitY();
    // At rest a straight wheel leans, too.
    if (camber != 0 || toe != 0 || !motion_.empty()) Add("wheel_axis", Moved(WheelCarrier(), centre_ + 0.1 * axis));
  }

  void ArmPoints(const ChronoNode& arm, const std::string& name) {
    Add(name + "_front", offset_ + arm.Vector("Location Chassis Front"));
    Add(name + "_rear", offset_ + arm.Vector("Location Chassis Back"));
    Add(name + "_ball", Moved(name + "_arm", offset_ + arm.Vector("Location Upright")));
  }

  void TieRod(const char* outer) {
    tie_outer_ = Place("Tierod", outer);
    const Vector3d inner = Place("Tierod", "Location Chassis");
    Add("tie_inner", inner);
    Add("tie_outer", Moved("knuckle", tie_outer_));
    tie_rod_ = MaybeChronoBody(file_, "Tierod", offset_, tie_outer_);
    OnBody(HalfAt(tie_rod_, inner));
  }

  void Knuckle(const KnownBody& upright) { Keep("knuckle", upright + HalfAt(tie_rod_, tie_outer_)); }

  /// Tube, both wheels, and whatever steering is on it.
  KnownBody Beam() {
    KnownBody axle = ChronoBody(file_.Child("Axle Tube"), offset_) + wheel_ + wheel_.Mirrored();
    if (file_.Has("Knuckle")) {
      const KnownBody knuckle = ChronoBody(file_.Child("Knuckle"), offset_);
      axle = axle + knuckle + knuckle.Mirrored();
    }
    const Vector3d middle(centre_.x(), 0, centre_.z());
    for (const char* part : {"Tierod", "Draglink", "Bell Crank"})
      axle = axle + MaybeChronoBody(file_, part, offset_, middle);
    return axle;
  }

  void Struts(const char* lower, const char* part) {
    const Vector3d spring_top = Place("Spring", "Location Chassis");
    const Vector3d spring_bottom = Moved(part, Place("Spring", lower));
    const Vector3d damper_top = Place("Shock", "Location Chassis");
    const Vector3d damper_bottom = Moved(part, Place("Shock", lower));
    Add("spring_top", spring_top);
    Add("spring_bottom", spring_bottom);
    Add("damper_top", damper_top);
    Add("damper_bottom", damper_bottom);
    Laws((spring_top - spring_bottom).norm(), (damper_top - damper_bottom).norm());
  }

  void Laws(double spring_length, double shock_length) {
    const ChronoNode spring = file_.Child("Spring");
    const std::string& source = result_.known.source;
    result_.known.spring = ChronoSpring(spring, axle_, spring_length, source);
    result_.known.stops = ChronoStops(spring, spring_length);
    result_.known.damper = ChronoShock(file_.Child("Shock"), axle_, shock_length, source);
  }

  /// Torsional rate over the square of the arm.
  void Bar(const Vector3d& end, const Vector3d& link, double rate, double arm, const std::string& on) {
    if (!(std::abs(arm) > 1e-3) || !(rate > 0)) return;
    Add("bar_end", end);
    Add("drop_link", link, on);
    const double stiffness = std::round(rate / (arm * arm)) * 1e-3;
    result_.known.bar_rate = {.name = "k_" + axle_ + "_bar",
                              .value = stiffness,
                              .lower = 0,
                              .upper = 3 * stiffness,
                              .precision = 0.01,
                              .unit = "N/mm",
                              .source = result_.known.source + ": its torsional rate over the square of its arm"};
  }

  void AntiRollBar(const std::string& on) {
    if (!entry_.Has("Antirollbar Input File")) return;
    const Vector3d at = entry_.Vector("Antirollbar Location");
    const std::optional<ChronoNode> bar = entry_.File("Antirollbar Input File");
    if (!bar) return;
    const double length = bar->Child("Arm").Number("Length");
    const double width = bar->Child("Arm").Number("Width");
    const double height = bar->Child("Droplink").Number("Height");
    const Vector3d link = Moved(on, at + Vector3d(width, length, height));
    // The bar turns along with both wheels.
    Bar(link - Vector3d(0, 0, height), link, bar->Child("RSD").Number("Spring Coefficient"), width,
        on == "arm" ? "" : on);
    const double mass = bar->Child("Arm").Number("Mass");
    OnBody({.mass = mass, .com = at + Vector3d(0, 0.5 * length, 0), .inertia = Eigen::Matrix3d::Zero()});
  }

  const ChronoNode& file_;
  const ChronoNode& entry_;
  std::string axle_;
  const ChronoTyre& tyre_;
  const ChronoMotion& motion_;
  Vector3d offset_;
  Vector3d centre_ = Vector3d::Zero();
  /// Spindle, wheel and tyre of the left side.
  KnownBody wheel_;
  KnownBody tie_rod_;
  Vector3d tie_outer_ = Vector3d::Zero();
  ChronoAxle result_;
};

struct Template {
  std::string_view name;
  std::string_view kind;
  void (AxleReader::*read)();
};

constexpr std::array kTemplates = {Template{"DoubleWishbone", "double_wishbone", &AxleReader::DoubleWishbone},
                                   Template{"MacPhersonStrut", "macpherson", &AxleReader::MacPherson},
                                   Template{"SemiTrailingArm", "semi_trailing_arm", &AxleReader::SemiTrailingArm},
                                   Template{"SolidAxle", "four_link_panhard", &AxleReader::SolidAxle},
                                   Template{"RigidPanhardAxle", "guided_panhard", &AxleReader::GuidedPanhard},
                                   Template{"ToeBarRigidPanhardAxle", "guided_panhard", &AxleReader::GuidedPanhard},
                                   Template{"LeafspringAxle", "guided_axle", &AxleReader::GuidedLeaf},
                                   Template{"ToeBarLeafspringAxle", "guided_axle", &AxleReader::GuidedLeaf}};

/// One axle's own: parts of one side twice.
KnownBody UnsprungOf(const KnownAxle& known) {
  KnownBody sum;
  for (const auto& [name, body] : known.bodies) {
    sum = sum + body;
    if (name != "axle") sum = sum + body.Mirrored();
  }
  return sum;
}

}  // namespace

std::string ChronoTemplates() {
  std::string names;
  for (const Template& one : kTemplates) names += (names.empty() ? "" : ", ") + std::string(one.name);
  return names;
}

ChronoAxle ReadChronoAxle(const ChronoNode& entry, const std::string& axle, const ChronoTyre& tyre,
                          const ChronoMotion& motion) {
  const std::optional<ChronoNode> file = entry.File("Suspension Input File");
  if (!file) return {};
  const std::string name = file->Text("Template");
  if (name.empty()) return {};
  for (const Template& one : kTemplates) {
    if (one.name != name) continue;
    const SuspensionKind* kind = FindChronoKind(one.kind);
    if (kind->name.starts_with("guided")) file->ReportAt("Template", kChronoGuide, {'"' + name + '"'});
    ChronoAxle result = AxleReader(*file, entry, axle, tyre, motion).Read(one.read, kind);
    result.unsprung = UnsprungOf(result.known);
    return result;
  }
  file->ReportAt("Template", kChronoTemplate, {name, ChronoTemplates()});
  return {};
}

}  // namespace fourpost
