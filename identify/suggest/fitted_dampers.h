#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "identify/suggest/addition_source.h"

namespace fourpost {

/// A damper in which something can be added, with its rates at the fitted values; a hydraulic one has none.
struct FittedDamper {
  const Damper* damper = nullptr;
  double bump = 0;
  double rebound = 0;

  double rate() const { return std::max(bump, rebound); }
  bool HasRate() const { return bump > 0 && rebound > 0; }
  bool HasMount() const { return damper->series.has_value(); }
  bool HasFrictionBehindMount() const { return HasMount() && damper->law.friction; }
};

/// The dampers of a fitted vehicle.
class FittedDampers {
 public:
  /// The source must outlive it.
  explicit FittedDampers(const AdditionSource& source);

  const FittedDamper& at(std::size_t i) const { return dampers_[i]; }

  template <typename Takes>
  std::vector<AdditionSource::Group> GroupsOf(const Takes& takes) const {
    std::vector<char> flags;
    for (const FittedDamper& one : dampers_) flags.push_back(takes(one) ? 1 : 0);
    return source_.Groups(lines_, flags);
  }
  std::vector<std::string> NamesOf(const AdditionSource::Group& group) const;
  /// Their mean.
  double RateOf(const AdditionSource::Group& group) const;

  /// Dry friction that no mount relieves, in an element of its own or in the damper itself; null where there is none.
  const Damper* FrictionBeside(const FittedDamper& one) const;
  /// Friction of elements of their own becomes that of the dampers of a group. False where it has no such elements, or
  /// they cannot be written as the dampers can.
  bool PutFrictionInside(const AdditionSource::Group& group, VehicleEdit& edit) const;
  /// Adds a child of each damper of the addition in its file, with one parameter for all; not where it cannot be
  /// written.
  void AddAsChild(Addition addition, const NewParameter& parameter, const std::string& xml,
                  std::vector<Addition>& additions) const;

 private:
  const AdditionSource& source_;
  std::vector<FittedDamper> dampers_;
  std::vector<ForceLine> lines_;
};

/// Of an element with all that it has.
std::string TextOf(const tinyxml2::XMLElement& element);

}  // namespace fourpost
