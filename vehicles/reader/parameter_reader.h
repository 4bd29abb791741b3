#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "vehicles/description/vehicle.h"
#include "vehicles/reader/parameter_uses.h"
#include "vehicles/tags/file_faults.h"
#include "vehicles/tags/tag.h"

namespace fourpost {

/// Whether a number of the tree agrees with the parameter bound to it.
bool Agrees(double literal, double bound);

/// Reads the parameters of a file and the numbers that refer to them.
class ParameterReader {
 public:
  ParameterReader(const tinyxml2::XMLElement& robot, FileFaults& faults);

  const std::vector<Parameter>& parameters() const { return parameters_; }
  /// As the file gives them.
  std::vector<double> Values() const;

  /// The number in an attribute of the kind kScalar: "32 N/mm" or "0.5*$k". NaN after an error, so that comparisons
  /// report no further one.
  Scalar ReadScalar(const Tag& tag, std::string_view attribute);

  /// Binds a number of the tree, `literal` in the file, to the parameter of this `<fp:bind>`. Empty after an error.
  std::optional<Scalar> Bind(const Tag& bind, double literal, const Dimension& dimension) const;

  /// The least and the greatest value that a number takes within the bounds of its parameter.
  double Least(const Scalar& scalar) const;
  double Greatest(const Scalar& scalar) const;
  /// Whether a < b for all values of their parameters within bounds.
  bool IsBelow(const Scalar& a, const Scalar& b) const;

  /// Reports parameters that nothing refers to.
  void CheckUse() const;

 private:
  Parameter ReadParameter(const Tag& tag) const;
  void CheckQuantities(const Tag& tag) const;
  void CheckDimensions(const Tag& tag, const Parameter& parameter) const;
  void ReadBounds(const Tag& tag, Parameter& parameter) const;
  void CheckBounds(const Tag& tag, const Parameter& parameter) const;
  void ReadPrior(const Tag& tag, Parameter& parameter) const;
  void JudgeByUses(const tinyxml2::XMLElement& robot);
  void NoteMisspelt(const std::string& name);
  bool AgreesWithUses(const Parameter& parameter, const std::vector<ParameterUse>& uses) const;
  Scalar ReadReference(const Tag& tag, const AttributeRule& rule, const std::string& text);
  Found NumberFault(const AttributeRule& rule, const std::string& text) const;
  /// The attribute stands before the words of `fault`.
  Scalar Fault(const Tag& tag, std::string_view attribute, const Found& fault) const;
  Scalar Unreadable() const;
  void CheckRange(const Tag& tag, const AttributeRule& rule, const Scalar& scalar) const;
  Found BindFault(const Scalar& scalar, const Dimension& given, double literal, const Dimension& wanted) const;
  std::vector<std::string> Names() const;

  FileFaults& faults_;
  std::vector<Parameter> parameters_;
  std::map<std::string, int, std::less<>> index_;
  /// See LostNames.
  std::set<std::string, std::less<>> lost_names_;
  std::vector<bool> used_;
  int misspelt_ = 0;
  /// Read without an error of its own, so that references to it can be checked.
  std::vector<bool> sound_;
};

}  // namespace fourpost
