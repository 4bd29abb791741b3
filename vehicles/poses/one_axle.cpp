#include "vehicles/poses/one_axle.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace fourpost {
namespace {

/// Which links move together once ground and chassis are held.
class LinkGroups {
 public:
  LinkGroups(const Vehicle& vehicle, const std::vector<int>& chassis) : is_held_(vehicle.links.size()) {
    parent_.resize(vehicle.links.size());
    std::iota(parent_.begin(), parent_.end(), 0);
    is_held_[0] = true;
    for (const int link : chassis) Hold(vehicle, link);
    for (const Joint& joint : vehicle.joints) Join(joint.parent, joint.child);
    for (const Spring& spring : vehicle.springs) JoinLine(spring.line);
    for (const Damper& damper : vehicle.dampers) JoinLine(damper.line);
    for (const AntiRollBar& bar : vehicle.antiroll_bars)
      JoinAny({bar.left.parent.link, bar.left.child.link, bar.right.parent.link, bar.right.child.link});
    JoinEnds(vehicle.bushings);
    JoinEnds(vehicle.rods);
    JoinEnds(vehicle.balls);
    JoinEnds(vehicle.welds);
    JoinEnds(vehicle.hinges);
  }

  bool IsHeld(int link) const { return is_held_[At(link)]; }
  bool AreTogether(int a, int b) { return Root(At(a)) == Root(At(b)); }

 private:
  static std::size_t At(int link) { return static_cast<std::size_t>(link); }

  /// With all that carries it.
  void Hold(const Vehicle& vehicle, int link) {
    is_held_[At(link)] = true;
    for (const Joint& joint : vehicle.joints)
      if (joint.child == link && joint.parent != 0) Hold(vehicle, joint.parent);
  }

  std::size_t Root(std::size_t link) {
    while (parent_[link] != link) link = parent_[link] = parent_[parent_[link]];
    return link;
  }
  void Join(int a, int b) {
    if (!IsHeld(a) && !IsHeld(b)) parent_[Root(At(a))] = Root(At(b));
  }
  void JoinLine(const ForceLine& line) { Join(line.parent.link, line.child.link); }
  template <typename Elements>
  void JoinEnds(const Elements& elements) {
    for (const auto& element : elements) Join(element.parent.link, element.child.link);
  }
  /// Those that are not held.
  void JoinAny(const std::vector<int>& links) {
    int last = -1;
    for (const int link : links) {
      if (IsHeld(link)) continue;
      if (last >= 0) Join(last, link);
      last = link;
    }
  }

  std::vector<bool> is_held_;
  std::vector<std::size_t> parent_;
};

/// Leaves out links, and what is fixed to them.
class Pruner {
 public:
  Pruner(const Vehicle& vehicle, const std::vector<bool>& stays) : new_place_(vehicle.links.size(), -1) {
    axle_.vehicle = vehicle;
    Vehicle& left = axle_.vehicle;
    left.links.clear();
    for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
      if (!stays[i]) continue;
      new_place_[i] = static_cast<int>(left.links.size());
      left.links.push_back(vehicle.links[i]);
    }
    left.posts.clear();
    left.sensors.clear();
    left.actuators.clear();
    left.text.clear();
    Keep(left.joints, [&](Joint& joint) { return Place(joint.parent) && Place(joint.child); });
    axle_.springs = Keep(left.springs, [&](Spring& spring) { return PlaceLine(spring.line); });
    Keep(left.dampers, [&](Damper& damper) { return PlaceLine(damper.line); });
    Keep(left.antiroll_bars, [&](AntiRollBar& bar) { return PlaceLine(bar.left) && PlaceLine(bar.right); });
    Keep(left.tyres, [&](Tyre& tyre) { return Place(tyre.point.link); });
    axle_.bushings = KeepEnds(left.bushings);
    KeepEnds(left.rods);
    KeepEnds(left.balls);
    KeepEnds(left.welds);
    KeepEnds(left.hinges);
  }

  OneAxle axle() && { return std::move(axle_); }

 private:
  bool Place(int& link) const {
    link = new_place_[static_cast<std::size_t>(link)];
    return link >= 0;
  }
  bool PlaceLine(ForceLine& line) const {
    const bool has_parent = Place(line.parent.link);
    return Place(line.child.link) && has_parent;
  }

  /// Places of those that stay.
  template <typename Element, typename Stays>
  static std::vector<std::size_t> Keep(std::vector<Element>& elements, const Stays& stays) {
    std::vector<std::size_t> places;
    std::vector<Element> left;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (!stays(elements[i])) continue;
      places.push_back(i);
      left.push_back(std::move(elements[i]));
    }
    elements = std::move(left);
    return places;
  }
  template <typename Element>
  std::vector<std::size_t> KeepEnds(std::vector<Element>& elements) const {
    return Keep(elements, [&](Element& element) {
      const bool has_parent = Place(element.parent.link);
      return Place(element.child.link) && has_parent;
    });
  }

  std::vector<int> new_place_;
  OneAxle axle_;
};

}  // namespace

Preloads OneAxle::PreloadsOf(const Preloads& whole) const {
  Preloads preloads;
  for (const std::size_t i : springs) preloads.spring.push_back(whole.spring[i]);
  for (const std::size_t i : bushings) preloads.bushing.push_back(whole.bushing[i]);
  preloads.tyre.assign(vehicle.tyres.size(), 0);
  return preloads;
}

OneAxle OneAxleOf(const Vehicle& vehicle, const Suspension& suspension, std::size_t axle) {
  std::vector<bool> stays(vehicle.links.size(), true);
  if (suspension.chassis >= 0) {
    LinkGroups groups(vehicle, suspension.bodies[static_cast<std::size_t>(suspension.chassis)].links);
    for (std::size_t i = 0; i < stays.size(); ++i) {
      const int link = static_cast<int>(i);
      const auto moves_with = [&](std::size_t wheel) {
        return groups.AreTogether(link, suspension.wheels[wheel].link);
      };
      const std::vector<std::size_t>& wheels = suspension.axles[axle].wheels;
      stays[i] = groups.IsHeld(link) || std::any_of(wheels.begin(), wheels.end(), moves_with);
    }
  }
  return Pruner(vehicle, stays).axle();
}

}  // namespace fourpost
