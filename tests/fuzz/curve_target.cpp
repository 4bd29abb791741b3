#include <cmath>

#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_target.h"
#include "vehicles/curves/curve_file.h"

namespace fourpost {
namespace {

void CheckRising(const std::vector<CurvePoint>& points) {
  Require(points.size() >= 2, "a curve has two points at least");
  for (std::size_t i = 0; i < points.size(); ++i) {
    Require(std::isfinite(points[i].x) && std::isfinite(points[i].force), "points are finite");
    Require(i == 0 || (points[i - 1].x < points[i].x && points[i - 1].force < points[i].force), "points rise");
  }
}

}  // namespace

void FuzzCurve(const std::string& bytes) {
  static const FuzzFolder folder("curve");
  const std::filesystem::path file = folder.Write("fuzz.csv", bytes);
  const auto expect = [](bool reads, const Diagnostics& faults) {
    Require(reads != faults.HasErrors(), "a file reads when it has no error", faults.Format());
  };

  Diagnostics spring_faults;
  const std::optional<SpringCurve> spring = ReadSpringCurve(file, spring_faults);
  expect(spring.has_value(), spring_faults);
  if (spring) CheckRising(spring->points);

  Diagnostics damper_faults;
  const std::optional<std::vector<CurvePoint>> damper = ReadDamperCurve(file, damper_faults);
  expect(damper.has_value(), damper_faults);
  if (damper) CheckRising(*damper);

  Diagnostics bushing_faults;
  const std::optional<BushingRates> bushing = ReadBushingRates(file, bushing_faults);
  expect(bushing.has_value(), bushing_faults);
  for (std::size_t i = 0; bushing && i < 6; ++i)
    Require(bushing->stiffness[i] >= 0 && bushing->damping[i] >= 0 && std::isfinite(bushing->stiffness[i]) &&
                std::isfinite(bushing->damping[i]),
            "rates are numbers of zero or more");
}

}  // namespace fourpost
