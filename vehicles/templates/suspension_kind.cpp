#include "vehicles/templates/suspension_kind.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>

namespace fourpost {
namespace {

using Side = PointSpec::Side;
using Need = PointSpec::Need;
using Specs = std::vector<PointSpec>;

/// A point of the left side that needs nothing else.
PointSpec Left(std::string_view name, std::string_view meaning, double x, double y, double z,
               std::string_view partner = {}) {
  return {.name = name, .meaning = meaning, .side = Side::kLeft, .x = x, .y = y, .z = z, .partner = partner};
}

PointSpec Single(Side side, std::string_view name, std::string_view meaning, double x, double y, double z,
                 std::string_view partner = {}) {
  return {.name = name, .meaning = meaning, .side = side, .x = x, .y = y, .z = z, .partner = partner};
}

PointSpec Carried(PointSpec spec, std::vector<std::string_view> carriers) {
  spec.carriers = std::move(carriers);
  return spec;
}

PointSpec Optionally(PointSpec spec) {
  spec.need = Need::kOptional;
  return spec;
}

Specs Joined(std::initializer_list<Specs> parts) {
  Specs all;
  for (const Specs& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

Specs WheelPoints() {
  return {Left("wheel_centre", "centre of the wheel", 0, 0.75, 0.31),
          Left("contact", "where the loaded tyre stands on the ground", 0, 0.75, 0)};
}

/// Not of a beam axle, which carries both wheels straight.
Specs WheelAxis() {
  return {Optionally(Left("wheel_axis", "another point of the wheel's axis, outboard: static camber and toe", 0, 0.85,
                          0.31, "wheel_centre"))};
}

Specs CoilPoints(PointSpec top, PointSpec bottom, const std::vector<std::string_view>& carriers) {
  top.name = "spring_top";
  top.meaning = "coil, at the body";
  top.partner = "spring_bottom";
  bottom.name = "spring_bottom";
  bottom.meaning = "coil, at the suspension";
  return {top, Carried(bottom, carriers)};
}

Specs DamperPoints(PointSpec top, PointSpec bottom, const std::vector<std::string_view>& carriers, Need need) {
  top.name = "damper_top";
  top.meaning = need == Need::kNeeded ? "damper, at the body" : "damper, at the body; without it in the coil's middle";
  top.partner = "damper_bottom";
  top.need = need;
  bottom.name = "damper_bottom";
  bottom.meaning = "damper, at the suspension";
  bottom.partner = "damper_top";
  bottom.need = need;
  return {top, Carried(bottom, carriers)};
}

Specs BarPoints(PointSpec end, PointSpec link, const std::vector<std::string_view>& carriers) {
  end.name = "bar_end";
  end.meaning = "anti-roll bar: end of its arm, which holds the drop link";
  end.partner = "drop_link";
  link.name = "drop_link";
  link.meaning = "anti-roll bar: the drop link's other end";
  link.partner = "bar_end";
  return {Optionally(end), Optionally(Carried(link, carriers))};
}

PointSpec At(double x, double y, double z) { return Left({}, {}, x, y, z); }

SuspensionKind DoubleWishboneKind() {
  const std::vector<std::string_view> carriers = {"lower_arm", "upper_arm", "knuckle"};
  return {.name = "double_wishbone",
          .summary = "two wishbones and a tie rod",
          .points = Joined({WheelPoints(),
                            WheelAxis(),
                            {Left("lower_front", "lower arm, front bush", 0.15, 0.36, 0.22, "lower_rear"),
                             Left("lower_rear", "lower arm, rear bush", -0.20, 0.34, 0.21),
                             Left("lower_ball", "lower ball joint", 0.005, 0.70, 0.19, "upper_ball"),
                             Left("upper_front", "upper arm, front bush", 0.10, 0.45, 0.47, "upper_rear"),
                             Left("upper_rear", "upper arm, rear bush", -0.12, 0.45, 0.455),
                             Left("upper_ball", "upper ball joint", -0.02, 0.66, 0.48),
                             Left("tie_inner", "tie rod, at the rack or body", 0.12, 0.38, 0.26, "tie_outer"),
                             Left("tie_outer", "tie rod, at the knuckle", 0.13, 0.69, 0.25)},
                            CoilPoints(At(0, 0.48, 0.68), At(0, 0.57, 0.21), carriers),
                            DamperPoints(At(0, 0.48, 0.68), At(0, 0.57, 0.21), carriers, Need::kOptional),
                            BarPoints(At(0.05, 0.56, 0.40), At(0.05, 0.58, 0.21), carriers)}),
          .arms = {{"lower_front", "lower_rear", "lower_ball"}, {"upper_front", "upper_rear", "upper_ball"}},
          .write = WriteDoubleWishbone};
}

SuspensionKind MacPhersonKind() {
  return {
      .name = "macpherson",
      .summary = "a strut that guides the wheel, a lower arm and a tie rod",
      .points = Joined({WheelPoints(),
                        WheelAxis(),
                        {Left("lower_front", "lower arm, front bush", 0.03, 0.38, 0.20, "lower_rear"),
                         Left("lower_rear", "lower arm, rear bush", -0.28, 0.37, 0.205),
                         Left("lower_ball", "lower ball joint", 0, 0.71, 0.18, "strut_top"),
                         Left("strut_top", "top mount of the strut", -0.03, 0.57, 0.86, "strut_bottom"),
                         Left("strut_bottom", "lower end of coil and damper, on the strut's axis", -0.008, 0.63, 0.42),
                         Left("tie_inner", "tie rod, at the rack or body", -0.13, 0.36, 0.255, "tie_outer"),
                         Left("tie_outer", "tie rod, at the knuckle", -0.14, 0.69, 0.245)},
                        BarPoints(At(0.06, 0.60, 0.21), At(0.01, 0.60, 0.50), {"knuckle", "lower_arm"})}),
      .arms = {{"lower_front", "lower_rear", "lower_ball"}},
      .write = WriteMacPherson};
}

SuspensionKind ArmKind(std::string_view name, std::string_view summary, const PointSpec& inner,
                       const PointSpec& outer) {
  return {.name = name,
          .summary = summary,
          .points = Joined({WheelPoints(),
                            WheelAxis(),
                            {Left("pivot_inner", "arm, inner bush", inner.x, inner.y, inner.z, "pivot_outer"),
                             Left("pivot_outer", "arm, outer bush", outer.x, outer.y, outer.z)},
                            CoilPoints(At(0.14, 0.54, 0.55), At(0.14, 0.54, 0.27), {"arm"}),
                            DamperPoints(At(-0.03, 0.58, 0.74), At(-0.06, 0.61, 0.25), {"arm"}, Need::kOptional),
                            BarPoints(At(0.12, 0.48, 0.42), At(0.12, 0.48, 0.28), {"arm"})}),
          .arms = {{"pivot_inner", "pivot_outer", "wheel_centre"}},
          .write = WriteTrailingArm};
}

SuspensionKind MultilinkKind() {
  return {.name = "multilink",
          .summary = "five links",
          .points = Joined(
              {WheelPoints(),
               WheelAxis(),
               {Left("lower_front_inner", "lower front link, at the body", 0.05, 0.36, 0.20, "lower_front_outer"),
                Left("lower_front_outer", "lower front link, at the knuckle", 0.02, 0.68, 0.18),
                Left("lower_rear_inner", "lower rear link, at the body", -0.22, 0.38, 0.22, "lower_rear_outer"),
                Left("lower_rear_outer", "lower rear link, at the knuckle", -0.04, 0.68, 0.19),
                Left("upper_front_inner", "upper front link, at the body", 0.12, 0.43, 0.46, "upper_front_outer"),
                Left("upper_front_outer", "upper front link, at the knuckle", 0.03, 0.65, 0.47),
                Left("upper_rear_inner", "upper rear link, at the body", -0.15, 0.45, 0.45, "upper_rear_outer"),
                Left("upper_rear_outer", "upper rear link, at the knuckle", -0.03, 0.64, 0.48),
                Left("tie_inner", "track link, at the body", -0.14, 0.37, 0.27, "tie_outer"),
                Left("tie_outer", "track link, at the knuckle", -0.15, 0.67, 0.26)},
               CoilPoints(At(0.02, 0.52, 0.68), At(0.02, 0.62, 0.21), {"knuckle"}),
               DamperPoints(At(0.02, 0.52, 0.68), At(0.02, 0.62, 0.21), {"knuckle"}, Need::kOptional),
               BarPoints(At(0.08, 0.56, 0.42), At(0.06, 0.62, 0.22), {"knuckle"})}),
          .write = WriteMultilink};
}

SuspensionKind TwistBeamKind() {
  return {.name = "twist_beam",
          .summary = "two trailing arms on bushes, joined by a beam that twists",
          .points = Joined({WheelPoints(),
                            WheelAxis(),
                            {Left("pivot", "arm's bush", 0.42, 0.55, 0.33, "wheel_centre"),
                             Single(Side::kMiddle, "shear_centre", "the beam's shear centre, in the middle", 0.22, 0,
                                    0.34, "pivot")},
                            CoilPoints(At(0.10, 0.50, 0.52), At(0.10, 0.50, 0.27), {"arm"}),
                            DamperPoints(At(-0.04, 0.57, 0.70), At(-0.08, 0.60, 0.24), {"arm"}, Need::kOptional)}),
          .write = WriteTwistBeam};
}

Specs BeamStruts() {
  return Joined({CoilPoints(At(0, 0.48, 0.62), At(0, 0.48, 0.37), {"axle"}),
                 DamperPoints(At(-0.14, 0.44, 0.76), At(-0.09, 0.52, 0.25), {"axle"}, Need::kOptional),
                 BarPoints(At(-0.06, 0.44, 0.44), At(-0.06, 0.44, 0.26), {"axle"})});
}

Specs LowerLinks() {
  return {Left("lower_body", "lower link, at the body", 0.62, 0.45, 0.29, "lower_axle"),
          Left("lower_axle", "lower link, at the axle", 0.02, 0.50, 0.25)};
}

Specs PanhardRod() {
  return {Single(Side::kAny, "panhard_body", "Panhard rod, at the body", -0.13, -0.47, 0.36, "panhard_axle"),
          Single(Side::kAny, "panhard_axle", "Panhard rod, at the axle", -0.13, 0.48, 0.33)};
}

SuspensionKind BeamKind(std::string_view name, std::string_view summary, const Specs& links,
                        void (*write)(AxleWriter&)) {
  return {.name = name,
          .summary = summary,
          .is_beam = true,
          .points = Joined({WheelPoints(), links, BeamStruts()}),
          .write = write};
}

std::vector<SuspensionKind> AllKinds() {
  const Specs upper_straight = {Left("upper_body", "upper link, at the body", 0.48, 0.42, 0.44, "upper_axle"),
                                Left("upper_axle", "upper link, at the axle", 0.02, 0.42, 0.46)};
  const Specs upper_converging = {Left("upper_body", "upper link, at the body", 0.48, 0.42, 0.44, "upper_axle"),
                                  Left("upper_axle", "upper link, at the axle", 0.02, 0.12, 0.46)};
  const Specs upper_single = {
      Single(Side::kAny, "upper_body", "upper link, at the body", 0.50, 0.10, 0.44, "upper_axle"),
      Single(Side::kAny, "upper_axle", "upper link, at the axle", 0, 0.10, 0.46)};
  const Specs frame = {Left("frame_body", "A-frame, at the body", 0.55, 0.34, 0.46, "frame_ball"),
                       Single(Side::kMiddle, "frame_ball", "A-frame, its ball joint on the axle", 0.03, 0, 0.48)};
  const Specs leaf = {Left("front_eye", "leaf spring, front eye", 0.60, 0.48, 0.40, "seat"),
                      Left("seat", "leaf spring, where the axle is clamped", 0, 0.48, 0.36),
                      Left("rear_eye", "leaf spring, rear eye at the shackle", -0.64, 0.48, 0.43, "seat")};
  std::vector<SuspensionKind> kinds = {
      DoubleWishboneKind(),
      MacPhersonKind(),
      BeamKind("four_link_panhard", "beam axle on two lower and two upper trailing links with a Panhard rod",
               Joined({LowerLinks(), upper_straight, PanhardRod()}), WriteFourLinkPanhard),
      BeamKind("three_link_panhard", "beam axle on two lower and one upper trailing link with a Panhard rod",
               Joined({LowerLinks(), upper_single, PanhardRod()}), WriteThreeLinkPanhard),
      BeamKind("four_link", "beam axle on two lower and two upper links, one pair of which converges in plan",
               Joined({LowerLinks(), upper_converging}), WriteFourLink),
      ArmKind("trailing_arm", "an arm that turns about an axis straight across", At(0.42, 0.42, 0.33),
              At(0.42, 0.64, 0.33)),
      ArmKind("semi_trailing_arm", "an arm that turns about an oblique axis", At(0.32, 0.20, 0.30),
              At(0.44, 0.60, 0.31)),
      MultilinkKind(),
      BeamKind("a_frame", "beam axle on two lower trailing links and an A-frame above", Joined({LowerLinks(), frame}),
               WriteAFrame),
      {.name = "leaf_spring",
       .summary = "beam axle on leaf springs",
       .is_beam = true,
       .spring = "leaf",
       .points = Joined(
           {WheelPoints(), leaf, DamperPoints(At(-0.05, 0.40, 0.74), At(-0.03, 0.52, 0.25), {"axle"}, Need::kNeeded)}),
       .write = WriteLeafSpring},
      TwistBeamKind()};
  return kinds;
}

/// Small letters without what joins words; "mcphersonstrut" is "macpherson".
std::string Plain(std::string_view name) {
  std::string plain;
  for (const char c : name)
    if (std::isalpha(static_cast<unsigned char>(c)) != 0)
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (plain.starts_with("mcpherson")) plain.insert(1, "a");
  for (const char* end : {"struts", "strut"})
    if (plain == std::string("macpherson") + end) return "macpherson";
  return plain;
}

}  // namespace

const PointSpec* SuspensionKind::Find(std::string_view point) const {
  const auto found =
      std::find_if(points.begin(), points.end(), [&](const PointSpec& spec) { return spec.name == point; });
  return found == points.end() ? nullptr : &*found;
}

std::span<const SuspensionKind> SuspensionKinds() {
  static const std::vector<SuspensionKind> kinds = AllKinds();
  return kinds;
}

const SuspensionKind* FindSuspensionKind(std::string_view name) {
  const std::string plain = Plain(name);
  for (const SuspensionKind& kind : SuspensionKinds())
    if (Plain(kind.name) == plain) return &kind;
  return nullptr;
}

}  // namespace fourpost
