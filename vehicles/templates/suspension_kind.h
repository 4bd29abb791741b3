#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace fourpost {

class AxleWriter;

/// A point that a kind of suspension needs, and where it lies in the plausible axle that the template shows.
struct PointSpec {
  enum class Side {
    /// y > 0; its mirror image is the right side's.
    kLeft,
    /// In the plane of symmetry.
    kMiddle,
    /// There is one; on either side.
    kAny,
  };
  enum class Need { kNeeded, kOptional };

  std::string_view name;
  std::string_view meaning;
  Side side = Side::kLeft;
  /// x from the wheel's centre, z from the ground [m].
  double x = 0;
  double y = 0;
  double z = 0;
  /// The other end of what joins both, or the other one of a pair that is optional.
  std::string_view partner = {};
  Need need = Need::kNeeded;
  /// Parts that may carry it, the usual one first; empty: no choice.
  std::vector<std::string_view> carriers = {};
};

/// An arm that turns about the axis through two points.
struct ArmSpec {
  std::string_view first;
  std::string_view second;
  std::string_view end;
};

/// A kind of suspension: its points, and how they become links and joints of a vehicle file.
struct SuspensionKind {
  std::string_view name;
  std::string_view summary;
  /// Both wheels are carried by one body.
  bool is_beam = false;
  /// What its spring is called.
  std::string_view spring = "coil";
  std::vector<PointSpec> points;
  std::vector<ArmSpec> arms;
  void (*write)(AxleWriter& axle) = nullptr;

  const PointSpec* Find(std::string_view point) const;
};

/// In the order of docs/suspensions.md.
std::span<const SuspensionKind> SuspensionKinds();

/// By its name in any usual spelling: "Leafspring", "MacPherson strut", "mcpherson"; nullptr for an unknown one.
const SuspensionKind* FindSuspensionKind(std::string_view name);

// Links and joints of each kind: what suspension_kind.cpp puts into the table.
void WriteDoubleWishbone(AxleWriter& axle);
void WriteMacPherson(AxleWriter& axle);
void WriteTrailingArm(AxleWriter& axle);
void WriteMultilink(AxleWriter& axle);
void WriteTwistBeam(AxleWriter& axle);
void WriteFourLink(AxleWriter& axle);
void WriteFourLinkPanhard(AxleWriter& axle);
void WriteThreeLinkPanhard(AxleWriter& axle);
void WriteAFrame(AxleWriter& axle);
void WriteLeafSpring(AxleWriter& axle);

}  // namespace fourpost
