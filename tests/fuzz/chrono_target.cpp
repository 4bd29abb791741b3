#include <algorithm>
#include <array>
#include <filesystem>

#include "analysis/files/text_file.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_target.h"
#include "vehicles/chrono/chrono_text.h"
#include "vehicles/chrono/chrono_vehicle.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {
namespace {

constexpr std::array<const char*, 6> kNames = {"vehicle.json",  "car/chassis.json", "car/wishbones.json",
                                               "car/leaf.json", "car/wheel.json",   "car/tyre.json"};

const std::filesystem::path kCar = std::filesystem::path(FOURPOST_SOURCE_DIR) / "tests/data/chrono";

/// The tests' car, with these files in place of its own; those that are empty or missing stay.
void WriteCar(const FuzzFolder& folder, const std::string& bytes) {
  static const std::array<std::string, kNames.size()> car = [] {
    std::array<std::string, kNames.size()> texts;
    Diagnostics faults;
    for (std::size_t i = 0; i < texts.size(); ++i) texts[i] = ReadTextFile(kCar / kNames[i], faults).value();
    return texts;
  }();
  std::size_t at = 0;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const std::size_t end = std::min(bytes.find('\x1E', at), bytes.size());
    folder.Write(kNames[i], end > at ? bytes.substr(at, end - at) : car[i]);
    at = std::min(end + 1, bytes.size());
  }
}

}  // namespace

void FuzzChrono(const std::string& bytes) {
  static const FuzzFolder folder("chrono");
  std::filesystem::create_directories(folder.path() / "car");
  WriteCar(folder, bytes);
  const std::filesystem::path file = folder.path() / kNames.front();
  const std::vector<std::filesystem::path> tyres = {folder.path() / kNames.back()};

  Diagnostics faults;
  const std::optional<ChronoVehicle> car = ReadChronoVehicle(file, tyres, {}, faults);
  Require(car.has_value() != faults.HasErrors(), "a model is read when it has no error", faults.Format());
  if (!car) return;
  for (const AxlePoints& axle : car->points)
    for (const auto& [name, point] : axle.points) Require(point.xyz.allFinite(), "points are finite", name);

  Diagnostics found;
  const std::string text = ChronoVehicleText(file, tyres, "car", "car.urdf", found);
  Require(text.empty() == found.HasErrors(), "a vehicle is written where there is no error", found.Format());
  if (text.empty()) return;
  Diagnostics again;
  Require(ReadVehicleText(text, "car.urdf", again).has_value(), "what is written is read", again.Format());
}

}  // namespace fourpost
