#include "identify/problems/test_problem.h"

#include <stdexcept>
#include <string>

#include "identify/problems/coil_spring.h"
#include "identify/problems/gear_train.h"
#include "identify/problems/half_car_twin.h"
#include "identify/problems/oscillator.h"
#include "identify/problems/pressure_vessel.h"
#include "identify/problems/speed_reducer.h"

namespace fourpost {

TestProblem MakeTestProblem(std::string_view name) {
  if (name == "oscillator") return {OscillatorProblem(), kOscillatorTarget};
  if (name == "gear_train") return {GearTrainProblem(), kGearTrainTarget};
  if (name == "coil_spring") return {CoilSpringProblem(1e-12), kCoilSpringTarget};
  if (name == "pressure_vessel") return {PressureVesselProblem(), kPressureVesselTarget};
  if (name == "speed_reducer") return {SpeedReducerProblem(), kSpeedReducerTarget};
  if (name == "half_car") return HalfCarInTime();
  if (name == "half_car_frequency") return HalfCarInFrequency();
  if (name == "half_car_out_of_bounds") return HalfCarOutOfBounds();
  throw std::invalid_argument("there is no test problem '" + std::string(name) + "'");
}

}  // namespace fourpost
