#pragma once

#include <string>
#include <vector>

#include "identify/suggest/addition.h"
#include "identify/suggest/vehicle_edit.h"
#include "vehicles/description/vehicle.h"

namespace fourpost {

/// A vehicle as it was fitted, of which additions are made.
class AdditionSource {
 public:
  /// `values`: of all parameters, SI. The vehicle must outlive it, and have a text.
  AdditionSource(const Vehicle& vehicle, const std::vector<double>& values);

  const Vehicle& vehicle() const { return vehicle_; }
  const std::vector<double>& values() const { return values_; }
  VehicleEdit Edit() const { return VehicleEdit(vehicle_.text); }
  bool IsWritten(const char* tag, const std::string& name) const { return Edit().Find(tag, name) != nullptr; }

  /// A legal name for a new parameter that no other has.
  std::string ParameterName(const std::string& prefix, const std::vector<std::string>& elements) const;
  /// A name for a new element; without a mirror partner where `is_single`.
  std::string ElementName(const std::string& prefix, const std::string& element, bool is_single) const;

  /// Elements alone, and pairs of mirror images, by place in the list, of those that `takes` says. `lines`: of all.
  using Group = std::vector<std::size_t>;
  std::vector<Group> Groups(const std::vector<ForceLine>& lines, const std::vector<char>& takes) const;
  /// Of a group: those elements whose change in the file changes the group and nothing else; empty where there are
  /// none, as of one side of an element that is mirrored.
  std::vector<std::string> WrittenOf(const char* tag, const std::vector<std::string>& names) const;
  /// Name and `parent="..." child="..." axis="..."` of the elements at whose ends another one is to be written: of a
  /// pair that is mirrored the written one alone.
  std::vector<std::pair<std::string, std::string>> EndsOf(const char* tag, const std::vector<std::string>& names) const;
  /// Dampers with dry friction between two bodies, in whichever order they name these.
  std::vector<const Damper*> FrictionBetween(int one, int other) const;
  /// The element that fp:mirror makes of this one, written out in a document of its own; null where there is none.
  tinyxml2::XMLElement* ImageOf(const char* tag, const std::string& written, tinyxml2::XMLDocument& document) const;

 private:
  const Vehicle& vehicle_;
  std::vector<double> values_;
};

/// "'a'", "'a' and 'b'"
std::string Quoted(const std::vector<std::string>& names);

/// What can be added where, by the kind of the elements.
void AddDamperAdditions(const AdditionSource& source, std::vector<Addition>& additions);
/// Mounts in line with dampers, and their hardening.
void AddMountAdditions(const AdditionSource& source, std::vector<Addition>& additions);
/// Dry friction beside dampers and behind their mounts.
void AddFrictionAdditions(const AdditionSource& source, std::vector<Addition>& additions);
void AddSpringAdditions(const AdditionSource& source, std::vector<Addition>& additions);
/// Elastic friction beside springs.
void AddHysteresisAdditions(const AdditionSource& source, std::vector<Addition>& additions);
void AddTyreAdditions(const AdditionSource& source, std::vector<Addition>& additions);
void AddBushAdditions(const AdditionSource& source, std::vector<Addition>& additions);
void AddBodyAdditions(const AdditionSource& source, std::vector<Addition>& additions);
void AddGuideAdditions(const AdditionSource& source, std::vector<Addition>& additions);
/// Numbers that several elements share, one of them with its own.
void AddSideAdditions(const AdditionSource& source, std::vector<Addition>& additions);
/// Parameters with a range that the study holds. `free`: places of those that it does not.
void AddHeldAdditions(const AdditionSource& source, const std::vector<std::size_t>& free,
                      std::vector<Addition>& additions);
/// Delay and scale of channels, of all of one kind, and of all.
void AddChannelAdditions(const AdditionSource& source, const std::string& study, std::vector<Addition>& additions);

}  // namespace fourpost
