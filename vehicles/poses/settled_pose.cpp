#include "vehicles/poses/settled_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/numerics/decompositions.h"
#include "analysis/text/diagnostics.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/condensed/preload_map.h"
#include "vehicles/condensed/unheld_motion.h"
#include "vehicles/description/gravity.h"
#include "vehicles/loops/loop_space.h"
#include "vehicles/poses/rest_solver.h"

namespace fourpost {
namespace {

using Eigen::Index;

Vehicle OnRollingTyres(Vehicle vehicle) {
  for (Tyre& tyre : vehicle.tyres) tyre.lateral = tyre.longitudinal = Scalar{};
  return vehicle;
}

/// As of preloads in a file.
constexpr double kTyped = 1e-6;
/// Middle and turn.
constexpr Index kPlanGuides = 3;

bool IsHeldByEquilibrium(const Spring& spring) { return !spring.preload && !spring.free_length; }

Vehicle LeftToEquilibrium(Vehicle vehicle) {
  for (Spring& spring : vehicle.springs)
    if (spring.kind == Spring::Kind::kCoil) {
      spring.preload.reset();
      spring.free_length.reset();
    }
  for (Tyre& tyre : vehicle.tyres) tyre.preload.reset();
  return vehicle;
}

class Settling {
 public:
  Settling(const Vehicle& vehicle, std::span<const double> parameters)
      : vehicle_(OnRollingTyres(vehicle)),
        parameters_(parameters),
        multibody_(vehicle_),
        solver_(multibody_),
        design_(AtDesign()) {
    for (const Bushing& bushing : vehicle_.bushings) {
      child_axes_.push_back(design_.ChildAxes(bushing));
      design_places_.push_back(design_.BushingPlace(bushing, child_axes_.back()));
    }
    for (const Spring& spring : vehicle_.springs) {
      const double length = design_.LineLength(spring.line).value;
      const double given = spring.preload ? spring.preload->At(parameters_)
                           : spring.free_length
                               ? -spring.law.At(parameters_).Force(spring.free_length->At(parameters_) - length)
                               : 0;
      preloads_.spring.push_back(given);
    }
    for (const Tyre& tyre : vehicle_.tyres) preloads_.tyre.push_back(tyre.preload ? tyre.preload->At(parameters_) : 0);
    preloads_.bushing.assign(vehicle_.bushings.size(), Eigen::Vector3d::Zero());
    multibody_.SetParameters(parameters_, preloads_);
  }

  std::optional<SettledPose> Pose() {
    const std::optional<RestSolver::Rest> rest = Solve();
    if (!rest) return std::nullopt;
    multibody_.SetPose(rest->q);
    SettledPose settled;
    const Kinematics place = Here();
    const Eigen::VectorXd forces = Shared(Guides(place).directions, *rest);
    AddStruts(place, forces, settled);
    for (std::size_t i = 0; i < vehicle_.bushings.size(); ++i) {
      const std::array<Coordinate, 6> now = place.BushingPlace(vehicle_.bushings[i], child_axes_[i]);
      double most = 0;
      for (std::size_t k = 0; k < now.size(); ++k)
        if (vehicle_.bushings[i].stiffness[k].At(parameters_) > 0)
          most = std::max(most, std::abs(now[k].value - design_places_[i][k].value));
      settled.bushings.push_back(most);
    }
    for (const AntiRollBar& bar : vehicle_.antiroll_bars)
      settled.antiroll_bars.push_back(place.Twist(bar).value - design_.Twist(bar).value);
    for (std::size_t i = 0; i < vehicle_.links.size(); ++i) {
      settled.rest.push_back(PoseOf(place, static_cast<int>(i)));
      settled.design.push_back(PoseOf(design_, static_cast<int>(i)));
    }
    AddHolding(settled);
    return settled;
  }

 private:
  Kinematics AtDesign() {
    multibody_.SetPose(multibody_.design_pose());
    return Here();
  }
  Kinematics Here() const { return Kinematics(multibody_); }
  static Eigen::Isometry3d PoseOf(const Kinematics& place, int link) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = place.Rotation(link);
    pose.translation() = place.Location({link, Eigen::Vector3d::Zero()});
    return pose;
  }

  /// What equilibrium sets keeps its length; one row each, in the order of springs, tyres, bushings.
  RestSolver::Guides Guides(const Kinematics& place) const {
    std::vector<std::pair<double, Eigen::VectorXd>> rows;
    const auto hold = [&](const Coordinate& now, const Coordinate& before) {
      rows.emplace_back(now.value - before.value, now.gradient);
    };
    for (const Spring& spring : vehicle_.springs)
      if (IsHeldByEquilibrium(spring)) hold(place.LineLength(spring.line), design_.LineLength(spring.line));
    const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
    for (const Tyre& tyre : vehicle_.tyres)
      if (!tyre.preload) hold(place.FootPosition(tyre, down), design_.FootPosition(tyre, down));
    for (std::size_t i = 0; i < vehicle_.bushings.size(); ++i) {
      if (!vehicle_.bushings[i].holds) continue;
      const std::array<Coordinate, 6> now = place.BushingPlace(vehicle_.bushings[i], child_axes_[i]);
      for (std::size_t k = 0; k < 3; ++k) hold(now[k], design_places_[i][k]);
    }
    if (keeps_place_)
      for (const PlanGuide& guide : PlanGuides())
        rows.emplace_back(OnPlan(guide, place).value - OnPlan(guide, design_).value, OnPlan(guide, place).gradient);
    const auto count = static_cast<Index>(rows.size());
    RestSolver::Guides guides{Eigen::VectorXd(count), Eigen::MatrixXd(count, multibody_.coordinate_count()), {}};
    for (Index i = 0; i < count; ++i) {
      guides.error[i] = rows[static_cast<std::size_t>(i)].first;
      guides.jacobian.row(i) = rows[static_cast<std::size_t>(i)].second.transpose();
    }
    guides.directions = guides.jacobian;
    return guides;
  }

  /// Forces of the guides of which only some are given by rest, shared by rates as those of the design pose are, see
  /// PreloadMap.
  Eigen::VectorXd Shared(const Eigen::MatrixXd& directions, const RestSolver::Rest& rest) const {
    const Index count = HeldCount();
    const Eigen::VectorXd forces = rest.forces.tail(directions.rows()).head(count);
    if (forces.size() == 0) return forces;
    const Eigen::MatrixXd holders =
        LoopSpaceOf(multibody_.LoopJacobian()).motions.transpose() * directions.topRows(count).transpose();
    return PreloadMap(holders).At(-(holders * forces),
                                  [this](const Eigen::VectorXd& shared) { return TangentsAt(shared); });
  }

  Index HeldCount() const { return TangentsAt({}).rates.size(); }

  /// One per guide. `forces`: of the guides, pull of springs and minus the push of tyres; empty: none.
  HolderTangents TangentsAt(const Eigen::VectorXd& forces) const {
    std::vector<double> rates;
    std::vector<double> slack;
    bool is_curved = false;
    const auto add = [&](double rate) {
      rates.push_back(rate);
      slack.push_back(0);
    };
    for (const Spring& spring : vehicle_.springs)
      if (IsHeldByEquilibrium(spring)) add(spring.law.At(parameters_).Slope(0));
    for (const Tyre& tyre : vehicle_.tyres) {
      if (tyre.preload) continue;
      const auto place = static_cast<Index>(rates.size());
      const double load = forces.size() > 0 ? -forces[place] : 0;
      const LoadedTyre loaded = tyre.law.At(parameters_).Under(load);
      add(loaded.Rate(0));
      if (tyre.law.IsLinear()) continue;
      is_curved = true;
      slack.back() = -(load + loaded.Rate(0) * loaded.Liftoff());
    }
    for (const Bushing& bushing : vehicle_.bushings)
      for (std::size_t k = 0; bushing.holds && k < 3; ++k) add(bushing.stiffness[k].At(parameters_));
    const auto vector = [](const std::vector<double>& numbers) -> Eigen::VectorXd {
      return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Index>(numbers.size()));
    };
    return {vector(rates), is_curved ? vector(slack) : Eigen::VectorXd()};
  }

  /// Of a sum over the tyres' feet, factors of each one's x and y.
  using PlanGuide = std::vector<Eigen::Vector2d>;

  /// Where the feet are on the ground as a whole: their middle, and their turn about it.
  std::vector<PlanGuide> PlanGuides() const {
    const auto count = static_cast<double>(vehicle_.tyres.size());
    std::vector<Eigen::Vector2d> feet;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Tyre& tyre : vehicle_.tyres) {
      feet.emplace_back(design_.FootPosition(tyre, Eigen::Vector3d::UnitX()).value,
                        design_.FootPosition(tyre, Eigen::Vector3d::UnitY()).value);
      middle += feet.back() / count;
    }
    PlanGuide turn;
    for (const Eigen::Vector2d& foot : feet) turn.emplace_back(-(foot - middle).y(), (foot - middle).x());
    return {PlanGuide(feet.size(), Eigen::Vector2d::UnitX() / count),
            PlanGuide(feet.size(), Eigen::Vector2d::UnitY() / count), turn};
  }

  Coordinate OnPlan(const PlanGuide& guide, const Kinematics& place) const {
    Coordinate sum{.value = 0, .gradient = Eigen::VectorXd::Zero(multibody_.coordinate_count())};
    for (std::size_t i = 0; i < guide.size(); ++i)
      for (const Eigen::Index axis : {0, 1}) {
        const Coordinate foot = place.FootPosition(vehicle_.tyres[i], Eigen::Vector3d::Unit(axis));
        sum.value += guide[i][axis] * foot.value;
        sum.gradient += guide[i][axis] * foot.gradient;
      }
    return sum;
  }

  /// Rolling tyres leave open where the car stands on the ground: of all poses at rest the one that stays there, unless
  /// something else than tyres holds it.
  std::optional<RestSolver::Rest> Solve() {
    keeps_place_ = !vehicle_.tyres.empty();
    std::optional<RestSolver::Rest> rest = Approach();
    if (!keeps_place_ || (rest && rest->forces.tail(kPlanGuides).norm() <= kTyped * Weight())) return rest;
    keeps_place_ = false;
    return Approach();
  }

  /// The forces that hold the design pose are taken away little by little.
  std::optional<RestSolver::Rest> Approach() {
    constexpr int kSteps = 10;
    const RestSolver::Guide guide = [this](const Kinematics& place) { return Guides(place); };
    RestSolver::Rest rest{multibody_.design_pose(), {}};
    const Eigen::VectorXd lacking = solver_.Lacking(rest.q);
    const Eigen::MatrixXd loops = multibody_.LoopJacobian();
    const Eigen::MatrixXd held = Guides(Here()).jacobian;
    Eigen::MatrixXd across(rest.q.size(), loops.rows() + held.rows());
    across << loops.transpose(), held.transpose();
    const Eigen::VectorXd carried = across.cols() > 0 ? LeastNorm(across).Solve(lacking) : Eigen::VectorXd();
    Eigen::VectorXd unbalanced = lacking;
    if (across.cols() > 0) unbalanced -= across * carried;
    rest.forces = carried;
    for (int k = 1; k <= kSteps; ++k) {
      solver_.Carry((1 - static_cast<double>(k) / kSteps) * unbalanced);
      const std::optional<RestSolver::Rest> next = solver_.Solve(rest, guide);
      if (!next) return std::nullopt;
      rest = *next;
    }
    return IsAtRest(rest, guide) ? std::optional(rest) : std::nullopt;
  }

  /// A motion that nothing holds leaves its force.
  bool IsAtRest(const RestSolver::Rest& rest, const RestSolver::Guide& guide) {
    const Eigen::VectorXd lacking = solver_.Lacking(rest.q);
    const Eigen::MatrixXd loops = multibody_.LoopJacobian();
    const Eigen::MatrixXd held = guide(Here()).directions;
    Eigen::VectorXd left = lacking - loops.transpose() * rest.forces.head(loops.rows());
    left -= held.transpose() * rest.forces.tail(held.rows());
    return left.norm() <= kTyped * std::max(Weight(), lacking.norm());
  }

  double Weight() const {
    double weight = 0;
    for (const Link& link : vehicle_.links) weight += link.mass.At(parameters_) * kGravity;
    return weight;
  }

  void AddStruts(const Kinematics& place, const Eigen::VectorXd& forces, SettledPose& settled) const {
    Index next = 0;
    for (std::size_t i = 0; i < vehicle_.springs.size(); ++i) {
      const Spring& spring = vehicle_.springs[i];
      SettledPose::Strut strut{.element = spring.Element(),
                               .design_length = design_.LineLength(spring.line).value,
                               .length = place.LineLength(spring.line).value,
                               .is_held = IsHeldByEquilibrium(spring)};
      strut.force = strut.is_held
                        ? -forces[next++]
                        : preloads_.spring[i] + spring.law.At(parameters_).Force(strut.length - strut.design_length);
      settled.springs.push_back(strut);
    }
    const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
    for (std::size_t i = 0; i < vehicle_.tyres.size(); ++i) {
      const Tyre& tyre = vehicle_.tyres[i];
      SettledPose::Strut strut{.element = "fp:tyre '" + tyre.name + "'",
                               .design_length = design_.FootPosition(tyre, down).value,
                               .length = place.FootPosition(tyre, down).value,
                               .is_held = !tyre.preload};
      strut.force = strut.is_held
                        ? -forces[next++]
                        : tyre.law.At(parameters_).Under(preloads_.tyre[i]).Force(strut.length - strut.design_length);
      settled.tyres.push_back(strut);
    }
  }

  void AddHolding(SettledPose& settled) const {
    Preloads holding;
    try {
      holding = CondensedVehicle(LeftToEquilibrium(vehicle_)).PreloadsAt(parameters_);
    } catch (const FaultyInput&) {
      return;
    }
    for (std::size_t i = 0; i < vehicle_.springs.size(); ++i) {
      if (vehicle_.springs[i].kind != Spring::Kind::kCoil) continue;
      SettledPose::Strut& strut = settled.springs[i];
      strut.holding_force = holding.spring[i];
      strut.holding_length =
          GivenForce::FreeSpring{vehicle_.springs[i].law.At(parameters_), strut.design_length}.FreeLengthFor(
              holding.spring[i]);
    }
    for (std::size_t i = 0; i < vehicle_.tyres.size(); ++i) settled.tyres[i].holding_force = holding.tyre[i];
  }

  Vehicle vehicle_;
  std::span<const double> parameters_;
  Multibody multibody_;
  RestSolver solver_;
  Kinematics design_;
  std::vector<Eigen::Matrix3d> child_axes_;
  std::vector<std::array<Coordinate, 6>> design_places_;
  Preloads preloads_;
  /// Whether the feet are to stay where they are on the ground.
  bool keeps_place_ = false;
};

}  // namespace

double SettledPose::Shift() const {
  double shift = 0;
  for (std::size_t i = 0; i < rest.size(); ++i)
    shift = std::max(shift, (rest[i].translation() - design[i].translation()).norm());
  return shift;
}

double SettledPose::Turn() const {
  double turn = 0;
  for (std::size_t i = 0; i < rest.size(); ++i)
    turn =
        std::max(turn, Eigen::AngleAxisd(Eigen::Matrix3d(rest[i].linear() * design[i].linear().transpose())).angle());
  return turn;
}

std::optional<SettledPose> Settle(const Vehicle& vehicle, std::span<const double> parameters) {
  return Settling(vehicle, parameters).Pose();
}

}  // namespace fourpost
