#include "vehicles/poses/axle_kinematics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fourpost {
namespace {

using Eigen::Index;

/// A micrometre of an element per metre of travel: rounding is far below.
constexpr double kUnmoved = 1e-6;

/// A wheel in the middle counts as a left one.
int SideOf(const Wheel& wheel) {
  constexpr double kAside_m = 0.1;
  if (wheel.side != 0) return wheel.side;
  return wheel.foot.y() < -kAside_m ? -1 : 1;
}

Coordinate LengthOf(const Vehicle& vehicle, const AxleStrut& strut, const Kinematics& pose) {
  switch (strut.kind) {
    case AxleStrut::Kind::kDamper: return pose.LineLength(vehicle.dampers[strut.index].line);
    case AxleStrut::Kind::kAntiRollBar: return pose.Twist(vehicle.antiroll_bars[strut.index]);
    default: return pose.LineLength(vehicle.springs[strut.index].line);
  }
}

class AxleOnRig {
 public:
  AxleOnRig(SuspensionRig& rig, std::size_t axle, std::span<const double> parameters)
      : rig_(rig),
        vehicle_(rig.vehicle()),
        suspension_(rig.suspension()),
        index_(axle),
        axle_(rig.suspension().axles[axle]),
        parameters_(parameters),
        design_(rig.Design()) {}

  AxleKinematics Kinematics(const TravelRange& range) {
    AxleKinematics kinematics{.axle = index_, .struts = {}, .travels = {}, .compliance = {}};
    std::vector<AxleTravel> travels = Travels();
    for (AxleTravel& travel : travels)
      if (rig_.Tangent(design_, RiseOf(travel, 1))) kinematics.travels.push_back(std::move(travel));
    for (const AxleStrut& strut : StrutsOf(vehicle_))
      if (IsMoved(strut, kinematics.travels)) kinematics.struts.push_back(strut);
    struts_ = kinematics.struts;
    if (kinematics.travels.empty()) return kinematics;
    FindStops(kinematics.travels.front(), kinematics);
    const TravelRange filled{range.lower.value_or(kinematics.stop_lower.value_or(-kUsualTravel)),
                             range.upper.value_or(kinematics.stop_upper.value_or(kUsualTravel)), range.step};
    for (AxleTravel& travel : kinematics.travels) Travel(filled, travel);
    kinematics.compliance = Compliance();
    return kinematics;
  }

  std::vector<std::optional<AxleStation>> At(const AxleTravel& travel, std::span<const double> travels,
                                             const StationWants& wants) {
    std::vector<std::optional<AxleStation>> stations(travels.size());
    if (!rig_.Tangent(design_, RiseOf(travel, 1))) return stations;
    if (wants.rates) struts_ = StrutsOf(vehicle_);
    std::vector<std::size_t> order(travels.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return std::abs(travels[a]) < std::abs(travels[b]); });
    // Of rebound and of bump.
    SuspensionRig::Pose reached[2] = {design_, design_};
    for (const std::size_t i : order) {
      SuspensionRig::Pose& pose = reached[travels[i] > 0 ? 1 : 0];
      const Eigen::VectorXd wanted = RiseOf(travel, travels[i]);
      if (pose.rise != wanted) pose = rig_.Move(pose, wanted);
      if (pose.rise == wanted) stations[i] = StationAt(travel, travels[i], pose, wants);
    }
    return stations;
  }

  std::vector<AxleCompliance> Compliance() {
    // Of a rad or metre per newton: far below any rubber, and far above rounding.
    constexpr double kYields = 1e-13;
    std::vector<AxleCompliance> all;
    if (rig_.IsRigid(design_)) return all;
    bool yields = false;
    for (const WheelLoad load : {WheelLoad::kLateral, WheelLoad::kBraking, WheelLoad::kDriving, WheelLoad::kAligning})
      for (const bool opposed : {false, true}) {
        if (opposed && !HasTwoSides()) continue;
        Eigen::VectorXd factors = Eigen::VectorXd::Zero(static_cast<Index>(suspension_.wheels.size()));
        for (std::size_t k = 0; k < axle_.wheels.size(); ++k)
          factors[static_cast<Index>(axle_.wheels[k])] = opposed ? Side(k) : 1;
        const std::optional<Eigen::VectorXd> motion = rig_.Yield(design_, load, factors);
        if (!motion) continue;
        const fourpost::Kinematics place = rig_.At(design_);
        AxleCompliance compliance{.load = load, .is_opposed = opposed, .wheels = {}};
        for (std::size_t k = 0; k < axle_.wheels.size(); ++k) {
          compliance.wheels.push_back(WheelRateOf(TyreOf(k), Side(k), place, *motion));
          const WheelPlace& wheel = compliance.wheels.back();
          yields = yields || std::max({std::abs(wheel.camber), std::abs(wheel.steer), wheel.centre.norm()}) > kYields;
        }
        all.push_back(std::move(compliance));
      }
    if (!yields) all.clear();
    return all;
  }

 private:
  const Tyre& TyreOf(std::size_t k) const { return vehicle_.tyres[axle_.wheels[k]]; }
  int Side(std::size_t k) const { return SideOf(suspension_.wheels[axle_.wheels[k]]); }
  bool HasTwoSides() const { return axle_.HasTwoSides(suspension_.wheels); }

  std::vector<AxleTravel> Travels() const {
    using Kind = AxleTravel::Kind;
    std::vector<AxleTravel> travels;
    travels.push_back({.kind = Kind::kHeave, .name = "heave", .stations = {}});
    if (HasTwoSides()) travels.push_back({.kind = Kind::kRoll, .name = "roll", .stations = {}});
    for (std::size_t k = 0; k < axle_.wheels.size() && axle_.wheels.size() > 1; ++k)
      travels.push_back(
          {.kind = Kind::kWheel, .wheel = k, .name = suspension_.wheels[axle_.wheels[k]].name, .stations = {}});
    return travels;
  }

  Eigen::VectorXd RiseOf(const AxleTravel& travel, double size) const {
    Eigen::VectorXd rise = Eigen::VectorXd::Zero(static_cast<Index>(suspension_.wheels.size()));
    for (std::size_t k = 0; k < axle_.wheels.size(); ++k) {
      const auto i = static_cast<Index>(axle_.wheels[k]);
      switch (travel.kind) {
        case AxleTravel::Kind::kHeave: rise[i] = size; break;
        case AxleTravel::Kind::kRoll: rise[i] = -suspension_.wheels[axle_.wheels[k]].side * size; break;
        case AxleTravel::Kind::kWheel: rise[i] = k == travel.wheel ? size : 0; break;
      }
    }
    return rise;
  }

  bool IsMoved(const AxleStrut& strut, const std::vector<AxleTravel>& travels) {
    const fourpost::Kinematics pose = rig_.At(design_);
    return std::any_of(travels.begin(), travels.end(), [&](const AxleTravel& travel) {
      const std::optional<Eigen::VectorXd> motion = rig_.Tangent(design_, RiseOf(travel, 1));
      return std::abs(LengthOf(vehicle_, strut, pose).gradient.dot(*motion)) > kUnmoved;
    });
  }

  /// Up to where the last stop of a side begins.
  void FindStops(const AxleTravel& heave, AxleKinematics& kinematics) {
    const fourpost::Kinematics pose = rig_.At(design_);
    const std::optional<Eigen::VectorXd> motion = rig_.Tangent(design_, RiseOf(heave, 1));
    double ends[2] = {0, 0};
    for (const AxleStrut& strut : struts_) {
      if (strut.kind != AxleStrut::Kind::kStop) continue;
      const double ratio = -LengthOf(vehicle_, strut, pose).gradient.dot(*motion);
      if (std::abs(ratio) < kUnmoved) continue;
      for (const SpringDescription::Knee& knee : vehicle_.springs[strut.index].law.knees) {
        // A knee of side -1 is met in bump.
        double& end = ends[(knee.side < 0) == (ratio > 0) ? 1 : 0];
        end = std::max(end, knee.at.At(parameters_) / std::abs(ratio));
      }
    }
    if (ends[0] > 0) kinematics.stop_lower = -ends[0];
    if (ends[1] > 0) kinematics.stop_upper = ends[1];
  }

  void Travel(const TravelRange& range, AxleTravel& travel) {
    travel.lower = *range.lower;
    travel.upper = *range.upper;
    std::vector<AxleStation> below;
    travel.reached_lower = Go(travel, travel.lower, range.step, below);
    travel.stations.assign(below.rbegin(), below.rend());
    travel.stations.push_back(StationAt(travel, 0, design_));
    travel.reached_upper = Go(travel, travel.upper, range.step, travel.stations);
  }

  /// From the design pose to the end, or as far as it goes; returns where.
  double Go(const AxleTravel& travel, double end, double step, std::vector<AxleStation>& stations) {
    constexpr double kThere_m = 1e-9;
    SuspensionRig::Pose pose = design_;
    const double way = std::abs(end);
    double next = 0;
    for (int k = 1; next < way; ++k) {
      next = k * step < way - kThere_m ? k * step : way;
      const Eigen::VectorXd wanted = RiseOf(travel, std::copysign(next, end));
      pose = rig_.Move(pose, wanted);
      if (pose.rise != wanted) return std::copysign(pose.rise.lpNorm<Eigen::Infinity>(), end);
      stations.push_back(StationAt(travel, std::copysign(next, end), pose));
    }
    return end;
  }

  AxleStation StationAt(const AxleTravel& travel, double size, const SuspensionRig::Pose& pose,
                        const StationWants& wants = {}) {
    AxleStation station{.travel = size};
    const Eigen::VectorXd motion = wants.rates ? rig_.Tangent(pose, RiseOf(travel, 1)).value()
                                               : Eigen::VectorXd(Eigen::VectorXd::Zero(pose.rest.q.size()));
    std::optional<Eigen::VectorXd> roll;
    if (wants.roll_centre && HasTwoSides() && travel.kind == AxleTravel::Kind::kHeave)
      roll = rig_.Tangent(pose, RiseOf({.kind = AxleTravel::Kind::kRoll, .stations = {}}, 1));
    const Eigen::VectorXd loads = rig_.PadForces(pose);
    const fourpost::Kinematics place = rig_.At(pose);
    for (std::size_t k = 0; k < axle_.wheels.size(); ++k) {
      const auto i = static_cast<Index>(axle_.wheels[k]);
      station.wheels.push_back({.rise = pose.rise[i],
                                .place = WheelPlaceOf(TyreOf(k), Side(k), place),
                                .rate = WheelRateOf(TyreOf(k), Side(k), place, motion),
                                .load = loads[i]});
    }
    if (HasTwoSides()) AddRoll(station);
    if (roll) station.roll_centre = RollCentre(place, *roll);
    station.wheelbase = Wheelbase(station);
    for (const AxleStrut& strut : struts_) {
      const Coordinate length = LengthOf(vehicle_, strut, place);
      station.lengths.push_back(length.value);
      station.ratios.push_back(-length.gradient.dot(motion));
    }
    return station;
  }

  /// Mean of the left wheels less that of the right ones.
  template <typename Number>
  double Difference(const Number& number) const {
    double sums[2] = {0, 0};
    int counts[2] = {0, 0};
    for (std::size_t k = 0; k < axle_.wheels.size(); ++k) {
      const int side = suspension_.wheels[axle_.wheels[k]].side;
      if (side == 0) continue;
      sums[side > 0 ? 0 : 1] += number(k);
      ++counts[side > 0 ? 0 : 1];
    }
    return sums[0] / std::max(counts[0], 1) - sums[1] / std::max(counts[1], 1);
  }

  void AddRoll(AxleStation& station) const {
    const auto feet = [&](Index axis) {
      return Difference([&](std::size_t k) { return station.wheels[k].place.foot[axis]; });
    };
    const auto rates = [&](Index axis) {
      return Difference([&](std::size_t k) { return station.wheels[k].rate.foot[axis]; });
    };
    const double across = feet(1);
    const double up = -feet(2);
    station.track = across;
    station.roll = std::atan2(up, across);
    station.roll_rate = (-rates(2) * across - up * rates(1)) / (across * across + up * up);
  }

  double RollCentre(const fourpost::Kinematics& place, const Eigen::VectorXd& roll) const {
    const auto foot = [&](std::size_t k, Index axis) {
      return place.FootPosition(TyreOf(k), Eigen::Vector3d::Unit(axis));
    };
    double aside = 0;
    for (std::size_t k = 0; k < axle_.wheels.size(); ++k)
      aside += foot(k, 1).gradient.dot(roll) / static_cast<double>(axle_.wheels.size());
    const double across = Difference([&](std::size_t k) { return foot(k, 1).value; });
    const double turn = -Difference([&](std::size_t k) { return foot(k, 2).gradient.dot(roll); }) / across;
    return -aside / turn;
  }

  std::optional<double> Wheelbase(const AxleStation& station) const {
    if (suspension_.axles.size() != 2) return std::nullopt;
    double here = 0;
    for (const WheelStation& wheel : station.wheels)
      here += wheel.place.centre.x() / static_cast<double>(station.wheels.size());
    const Axle& other = suspension_.axles[1 - index_];
    const fourpost::Kinematics place = rig_.At(design_);
    double there = 0;
    for (const std::size_t i : other.wheels)
      there += place.Location(vehicle_.tyres[i].point).x() / static_cast<double>(other.wheels.size());
    return std::abs(here - there);
  }

  SuspensionRig& rig_;
  const Vehicle& vehicle_;
  const Suspension& suspension_;
  std::size_t index_;
  const Axle& axle_;
  std::span<const double> parameters_;
  SuspensionRig::Pose design_;
  std::vector<AxleStrut> struts_;
};

}  // namespace

const AxleStation& AxleTravel::Design() const {
  return *std::find_if(stations.begin(), stations.end(),
                       [](const AxleStation& station) { return station.travel == 0; });
}

bool AxleKinematics::IsBeyondStops(const AxleStation& station) const {
  constexpr double kThere_m = 1e-9;
  return std::any_of(station.wheels.begin(), station.wheels.end(), [&](const WheelStation& wheel) {
    return (stop_lower && wheel.rise < *stop_lower - kThere_m) || (stop_upper && wheel.rise > *stop_upper + kThere_m);
  });
}

const char* KindName(AxleStrut::Kind kind) {
  switch (kind) {
    case AxleStrut::Kind::kSpring: return "spring";
    case AxleStrut::Kind::kStop: return "stop";
    case AxleStrut::Kind::kGas: return "gas";
    case AxleStrut::Kind::kDamper: return "damper";
    case AxleStrut::Kind::kAntiRollBar: return "anti-roll bar";
  }
  return "";
}

const char* LoadName(WheelLoad load) {
  switch (load) {
    case WheelLoad::kLateral: return "lateral";
    case WheelLoad::kBraking: return "braking";
    case WheelLoad::kDriving: return "driving";
    case WheelLoad::kAligning: return "aligning";
  }
  return "";
}

std::vector<AxleStrut> StrutsOf(const Vehicle& vehicle) {
  using Kind = AxleStrut::Kind;
  std::vector<AxleStrut> struts;
  for (std::size_t i = 0; i < vehicle.springs.size(); ++i) {
    const Spring& spring = vehicle.springs[i];
    const Kind kind = spring.kind == Spring::Kind::kCoil   ? Kind::kSpring
                      : spring.kind == Spring::Kind::kStop ? Kind::kStop
                                                           : Kind::kGas;
    struts.push_back({kind, i, spring.name});
  }
  for (std::size_t i = 0; i < vehicle.dampers.size(); ++i)
    struts.push_back({Kind::kDamper, i, vehicle.dampers[i].name});
  for (std::size_t i = 0; i < vehicle.antiroll_bars.size(); ++i)
    struts.push_back({Kind::kAntiRollBar, i, vehicle.antiroll_bars[i].name});
  std::stable_sort(struts.begin(), struts.end(),
                   [](const AxleStrut& a, const AxleStrut& b) { return a.kind < b.kind; });
  return struts;
}

std::vector<std::optional<AxleStation>> StationsAt(SuspensionRig& rig, std::size_t axle,
                                                   std::span<const double> parameters, const AxleTravel& travel,
                                                   std::span<const double> travels, const StationWants& wants) {
  return AxleOnRig(rig, axle, parameters).At(travel, travels, wants);
}

std::vector<AxleCompliance> ComplianceOf(SuspensionRig& rig, std::size_t axle, std::span<const double> parameters) {
  return AxleOnRig(rig, axle, parameters).Compliance();
}

std::vector<AxleKinematics> KinematicsOf(SuspensionRig& rig, std::span<const double> parameters,
                                         const TravelRange& range) {
  std::vector<AxleKinematics> all;
  for (std::size_t a = 0; a < rig.suspension().axles.size(); ++a) {
    AxleKinematics kinematics = AxleOnRig(rig, a, parameters).Kinematics(range);
    if (!kinematics.travels.empty()) all.push_back(std::move(kinematics));
  }
  return all;
}

}  // namespace fourpost
