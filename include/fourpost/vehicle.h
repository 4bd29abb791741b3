#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fourpost/diagnostics.h>

namespace fourpost {
struct Vehicle;
}

namespace fourpost::api {

/// A number of the vehicle file that can be fitted; SI.
struct Parameter {
  std::string name;
  double value = 0;
  /// Both equal to the value of a parameter without a range.
  double lower = 0;
  double upper = 0;
  /// As the file writes it.
  std::string unit;
};

struct Sensor {
  std::string name;
  /// SI unit of its readings.
  std::string unit;
};

/// A vehicle description, see ReadVehicle. Copies share what they have in common.
class Vehicle {
 public:
  const std::string& name() const;
  /// Names, in the order of the file.
  std::vector<std::string> links() const;
  std::vector<std::string> posts() const;
  std::vector<Sensor> sensors() const;
  std::vector<Parameter> parameters() const;

  /// Throws Error (code `name-unknown`) for a parameter that the vehicle does not have.
  double Value(const std::string& parameter) const;
  /// Sets a parameter, "40 kN/m". Throws Error as `fourpost --set` does.
  void Set(const std::string& parameter, const std::string& quantity);
  /// Sets a parameter to an SI value.
  void Set(const std::string& parameter, double value);

  /// The text of the file with the present values, for a file in the same folder.
  std::string Text() const;

 private:
  /// The library's own code.
  friend struct Inside;
  explicit Vehicle(std::shared_ptr<const fourpost::Vehicle> description);

  std::shared_ptr<const fourpost::Vehicle> description_;
};

/// Reads a vehicle file, URDF with the tags of urdf/README.md. Adds warnings to `warnings` where given. Throws Error
/// with all faults of the file.
Vehicle ReadVehicle(const std::filesystem::path& file, std::vector<Finding>* warnings = nullptr);

/// What is plausible of a vehicle, as `fourpost check` warns: odd numbers, places, motion ratios, loads.
std::vector<Finding> CheckVehicle(const Vehicle& vehicle);

}  // namespace fourpost::api
