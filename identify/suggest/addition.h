#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace fourpost {

/// Something that could be added to a vehicle or to what its study says of the recordings. How much of it is there is
/// its amount: 0 is the vehicle as it stands.
struct Addition {
  /// "friction", "mount": what is added, in a word that never changes.
  std::string mechanism;
  /// Names of the elements or channels that it is added to.
  std::vector<std::string> elements;
  /// "dry friction beside damper 'front'"
  std::string words;

  /// Text of the vehicle file with it, at the first amount; empty: the vehicle's own.
  std::string vehicle = {};
  /// Parameters that are then free beside those that are, and their values (SI) at an amount.
  std::vector<std::string> parameters = {};
  std::function<std::vector<double>(double amount)> values = {};
  /// Text of the study with it, where it is no matter of the vehicle; empty where it cannot be written there.
  std::function<std::string(double amount)> study = {};

  /// To look at first; not 0.
  double first = 1;
  double least = 0;
  double greatest = std::numeric_limits<double>::infinity();
  /// Numbers that it adds, for the criterion.
  int count = 1;
  /// How many changes it makes, each of which could be made alone: a choice each, for the criterion.
  int choices = 1;
  /// Which it is of all alternatives of the same key.
  int variant = 0;

  /// Of alternatives for the same thing, such as knees at several speeds, the best stands for all.
  std::string Key() const {
    std::string key = mechanism;
    for (const std::string& element : elements) key += '|' + element;
    return key;
  }

  /// Whether it is what another one adds, at some of its elements: one side of both.
  bool IsPartOf(const Addition& whole) const {
    return mechanism == whole.mechanism && elements.size() < whole.elements.size() &&
           std::all_of(elements.begin(), elements.end(), [&](const std::string& element) {
             return std::find(whole.elements.begin(), whole.elements.end(), element) != whole.elements.end();
           });
  }
};

}  // namespace fourpost
