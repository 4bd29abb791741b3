#include "vehicles/loops/loop_lock.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include <Eigen/Core>

#include "analysis/numerics/decompositions.h"
#include "analysis/text/enumeration.h"
#include "vehicles/loops/dead_centre.h"
#include "vehicles/loops/findings.h"
#include "vehicles/loops/loop_pose.h"
#include "vehicles/loops/wheel_ride.h"

namespace fourpost {
namespace {

std::string Quoted(const Link& link) { return "link '" + link.name + "'"; }

/// The design pose and, for a link that reverses there does not move either, one some millimetres away.
std::vector<LoopPose> SomePoses(Multibody& multibody) {
  constexpr double kStep = 5e-3;
  // Newton's method squares the error, from 1e-5 at worst; where loops lock it stops near enough.
  constexpr int kIterations = 6;
  multibody.SetPose(multibody.design_pose());
  std::vector<LoopPose> poses = {LoopPose(multibody)};
  const Eigen::MatrixXd& motions = poses[0].space().motions;
  Eigen::VectorXd mix(motions.cols());
  for (Eigen::Index i = 0; i < mix.size(); ++i) mix[i] = std::cos(1.0 + static_cast<double>(i));
  Eigen::VectorXd q = multibody.design_pose() + kStep * motions * mix.normalized();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    multibody.SetPose(q);
    q -= LeastNorm(multibody.LoopJacobian(), kLoopRankTolerance).Solve(multibody.LoopError());
  }
  multibody.SetPose(q);
  poses.emplace_back(multibody);
  multibody.SetPose(multibody.design_pose());
  return poses;
}

/// For each link the first of those that fixed joints and welds make one body with it.
std::vector<int> DeclaredBodies(const Vehicle& vehicle) {
  std::vector<int> first(vehicle.links.size());
  std::iota(first.begin(), first.end(), 0);
  const auto join = [&](int a, int b) {
    const int one = first[static_cast<std::size_t>(a)];
    const int other = first[static_cast<std::size_t>(b)];
    std::replace(first.begin(), first.end(), std::max(one, other), std::min(one, other));
  };
  for (const Joint& joint : vehicle.joints)
    if (joint.type == Joint::Type::kFixed) join(joint.parent, joint.child);
  for (const Weld& weld : vehicle.welds) join(weld.parent.link, weld.child.link);
  return first;
}

class LockSearch {
 public:
  explicit LockSearch(Multibody& multibody)
      : multibody_(multibody),
        vehicle_(multibody.vehicle()),
        closures_(multibody.loop_closures()),
        poses_(SomePoses(multibody)),
        wheels_(vehicle_, poses_[0]) {}

  Diagnostics Faults() {
    FindRigidLinks();
    FindLockedWheels();
    FindDeadCentres();
    return faults_;
  }

  FaultyInput CannotFollow() {
    Faults();
    if (!faults_.HasErrors()) Report(kLoopsStiff, Stressed(multibody_, poses_[0].space().stresses), {});
    return FaultyInput(faults_);
  }

 private:
  /// Whether a pose shows a lock with the motions that are left there.
  using Lock = std::function<bool(const LoopPose&, const Eigen::MatrixXd& motions)>;

  bool IsLocked(const Indices& closures, const Lock& lock) const;
  Indices LockingSet(const Lock& lock) const;
  /// As few closures as make one body of these links.
  Indices RigidifyingSet(const std::vector<int>& links) const;
  std::vector<std::vector<int>> ApartFromTheBody(const std::vector<int>& set) const;
  Indices AllClosures() const;
  std::vector<std::vector<int>> RigidLinks() const;
  void FindRigidLinks();
  void FindLockedWheels();
  void FindDeadCentres();
  /// `words` stand before the closures and the remedy.
  void Report(const Finding& kind, const Indices& closures, std::vector<std::string> words);
  std::string PrecisionHint() const;

  Multibody& multibody_;
  const Vehicle& vehicle_;
  const std::vector<LoopClosure>& closures_;
  std::vector<LoopPose> poses_;
  WheelRide wheels_;
  Diagnostics faults_;
};

Indices LockSearch::AllClosures() const {
  Indices all(closures_.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

bool LockSearch::IsLocked(const Indices& closures, const Lock& lock) const {
  // What the design pose allows, taken along to poses where it may be less: that is for FindDeadCentres.
  const Eigen::Index rank = poses_[0].SpaceOf(closures).rank;
  return std::all_of(poses_.begin(), poses_.end(),
                     [&](const LoopPose& pose) { return lock(pose, pose.SpaceOf(closures, rank).motions); });
}

/// As few closures as lock together; without any of them the others do not.
Indices LockSearch::LockingSet(const Lock& lock) const {
  Indices set = AllClosures();
  for (std::size_t i = closures_.size(); i-- > 0;) {
    Indices fewer = set;
    fewer.erase(std::find(fewer.begin(), fewer.end(), i));
    if (IsLocked(fewer, lock)) set = fewer;
  }
  return set;
}

/// Sets of links, of declared bodies the first, that do not move against each other.
std::vector<std::vector<int>> LockSearch::RigidLinks() const {
  const std::vector<int> declared = DeclaredBodies(vehicle_);
  std::vector<std::vector<int>> sets;
  for (int link = 0; link < static_cast<int>(declared.size()); ++link) {
    if (declared[static_cast<std::size_t>(link)] != link) continue;
    const auto with = std::find_if(sets.begin(), sets.end(), [&](const std::vector<int>& set) {
      return IsLocked(AllClosures(), [&](const LoopPose& pose, const Eigen::MatrixXd& motions) {
        return pose.MoveTogether(set.front(), link, motions);
      });
    });
    if (with == sets.end()) sets.push_back({link});
    else with->push_back(link);
  }
  return sets;
}

Indices LockSearch::RigidifyingSet(const std::vector<int>& links) const {
  return LockingSet([&](const LoopPose& pose, const Eigen::MatrixXd& motions) {
    return std::all_of(links.begin(), links.end(),
                       [&](int link) { return pose.MoveTogether(links.front(), link, motions); });
  });
}

/// The links that closures in common hold on the body, or on the first one: both sides of a car lock by themselves.
std::vector<std::vector<int>> LockSearch::ApartFromTheBody(const std::vector<int>& set) const {
  const int body = std::find(set.begin(), set.end(), wheels_.body()) == set.end() ? set.front() : wheels_.body();
  struct Group {
    std::vector<int> links;
    Indices closures;
  };
  const auto share = [](const Indices& a, const Indices& b) {
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
  };
  std::vector<Group> groups;
  for (const int link : set) {
    if (link == body) continue;
    Group joined{{link}, RigidifyingSet({body, link})};
    for (auto group = groups.begin(); group != groups.end();) {
      if (!share(group->closures, joined.closures)) {
        ++group;
        continue;
      }
      joined.links.insert(joined.links.begin(), group->links.begin(), group->links.end());
      joined.closures.insert(joined.closures.end(), group->closures.begin(), group->closures.end());
      group = groups.erase(group);
    }
    groups.push_back(std::move(joined));
  }
  std::vector<std::vector<int>> parts;
  for (Group& group : groups) {
    group.links.push_back(body);
    std::sort(group.links.begin(), group.links.end());
    parts.push_back(group.links);
  }
  return parts;
}

void LockSearch::FindRigidLinks() {
  for (const std::vector<int>& set : RigidLinks()) {
    if (set.size() < 2) continue;
    for (const std::vector<int>& part : ApartFromTheBody(set)) {
      std::vector<std::string> names;
      for (const int link : part) names.push_back(Quoted(vehicle_.links[static_cast<std::size_t>(link)]));
      Report(kLoopsRigid, RigidifyingSet(part), {Enumeration(names), PrecisionHint()});
    }
  }
}

void LockSearch::FindLockedWheels() {
  for (const auto& [link, centres] : wheels_.centres()) {
    const auto together = [&, link = link](const LoopPose& pose, const Eigen::MatrixXd& motions) {
      return pose.MoveTogether(wheels_.body(), link, motions);
    };
    const std::string lost = wheels_.LostBy(poses_[0], link, poses_[0].space().motions);
    const auto loses = [&, link = link](const LoopPose& pose, const Eigen::MatrixXd& motions) {
      return wheels_.LostBy(pose, link, motions) == lost;
    };
    // What moves with the body was found before, or is welded to it.
    if (lost.empty() || IsLocked(AllClosures(), together) || !IsLocked(AllClosures(), loses)) continue;
    const Indices closures = LockingSet(loses);
    const bool is_meant = closures.size() == 1 && closures_[closures[0]].rows >= 5;
    if (is_meant) continue;
    Report(kLoopsWheel, closures,
           {lost, Quoted(vehicle_.links[static_cast<std::size_t>(link)]),
            Quoted(vehicle_.links[static_cast<std::size_t>(wheels_.body())]), PrecisionHint()});
  }
}

void LockSearch::FindDeadCentres() {
  for (const DeadCentre& dead : DeadCentres(multibody_, poses_[0], wheels_.body()))
    Report(kLoopsDeadCentre, dead.closures, {dead.motion.Text()});
}

/// Equations of typed numbers that are meant to agree, as along parallel axes, but do so to a few digits only.
std::string LockSearch::PrecisionHint() const {
  // An angle typed with three digits.
  constexpr double kNearly = 5e-4;
  if (poses_[0].space().least > kNearly) return "";
  return ", though only just (axes or points that should agree may have too few digits),";
}

void LockSearch::Report(const Finding& kind, const Indices& closures, std::vector<std::string> words) {
  std::vector<std::string> names;
  for (const std::size_t i : closures) {
    const LoopClosure& closure = closures_[i];
    names.push_back(closure.element);
    if (closures.size() > 1 && closure.source_line > 0)
      names.back() += " (line " + std::to_string(closure.source_line) + ")";
  }
  words.push_back(Enumeration(names));
  const bool is_one = closures.size() == 1;
  words.insert(words.end(), {is_one ? "its place" : "their places", is_one ? "it" : "one of them"});
  faults_.Report(kind, {vehicle_.file, closures.empty() ? 0 : closures_[closures.front()].source_line}, words);
}

}  // namespace

Diagnostics LoopLocks(Multibody& multibody) { return LockSearch(multibody).Faults(); }

FaultyInput LoopsCannotFollow(Multibody& multibody) { return LockSearch(multibody).CannotFollow(); }

}  // namespace fourpost
