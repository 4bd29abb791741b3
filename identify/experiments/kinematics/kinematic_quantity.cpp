#include "identify/experiments/kinematics/kinematic_quantity.h"

#include <algorithm>
#include <array>
#include <limits>

namespace fourpost {
namespace {

using Of = KinematicQuantity::Of;

double OrNan(const std::optional<double>& value) { return value.value_or(std::numeric_limits<double>::quiet_NaN()); }

constexpr StationWants kRates{.rates = true, .roll_centre = false};
constexpr StationWants kRollCentre{.rates = false, .roll_centre = true};
constexpr StationWants kPlace{.rates = false, .roll_centre = false};

const std::array<KinematicQuantity, 13> kQuantities{{
    {"camber", Of::kWheel, kDimensionless, "deg", true,
     [](const AxleStation& at, std::size_t k) { return at.wheels[k].place.camber; },
     [](const WheelPlace& change) { return change.camber; }, kPlace},
    {"toe", Of::kWheel, kDimensionless, "deg", true,
     [](const AxleStation& at, std::size_t k) { return at.wheels[k].place.toe; },
     [](const WheelPlace& change) { return change.toe; }, kPlace},
    {"steer", Of::kWheel, kDimensionless, "deg", true,
     [](const AxleStation& at, std::size_t k) { return at.wheels[k].place.steer; },
     [](const WheelPlace& change) { return change.steer; }, kPlace},
    {"centre_x", Of::kWheel, kLength, "mm", true,
     [](const AxleStation& at, std::size_t k) { return at.wheels[k].place.centre.x(); },
     [](const WheelPlace& change) { return change.centre.x(); }, kPlace},
    {"centre_y", Of::kWheel, kLength, "mm", true,
     [](const AxleStation& at, std::size_t k) { return at.wheels[k].place.centre.y(); },
     [](const WheelPlace& change) { return change.centre.y(); }, kPlace},
    {"foot_x", Of::kWheel, kLength, "mm", true,
     [](const AxleStation& at, std::size_t k) { return at.wheels[k].place.foot.x(); },
     [](const WheelPlace& change) { return change.foot.x(); }, kPlace},
    {"foot_y", Of::kWheel, kLength, "mm", true,
     [](const AxleStation& at, std::size_t k) { return at.wheels[k].place.foot.y(); },
     [](const WheelPlace& change) { return change.foot.y(); }, kPlace},
    {"load", Of::kWheel, kForce, "N", false, [](const AxleStation& at, std::size_t k) { return at.wheels[k].load; },
     nullptr, kPlace},
    {"track", Of::kAxle, kLength, "mm", false, [](const AxleStation& at, std::size_t) { return OrNan(at.track); },
     nullptr, kPlace},
    {"wheelbase", Of::kAxle, kLength, "mm", false,
     [](const AxleStation& at, std::size_t) { return OrNan(at.wheelbase); }, nullptr, kPlace},
    {"roll_centre", Of::kAxle, kLength, "mm", false,
     [](const AxleStation& at, std::size_t) { return OrNan(at.roll_centre); }, nullptr, kRollCentre},
    {"length", Of::kStrut, kLength, "mm", false, [](const AxleStation& at, std::size_t i) { return at.lengths[i]; },
     nullptr, kRates},
    {"motion_ratio", Of::kStrut, kDimensionless, "", false,
     [](const AxleStation& at, std::size_t i) { return at.ratios[i]; }, nullptr, kRates},
}};

}  // namespace

std::span<const KinematicQuantity> KinematicQuantities() { return kQuantities; }

const KinematicQuantity* FindKinematicQuantity(std::string_view name) {
  const auto* found = std::find_if(kQuantities.begin(), kQuantities.end(),
                                   [&](const KinematicQuantity& one) { return one.name == name; });
  return found == kQuantities.end() ? nullptr : found;
}

}  // namespace fourpost
