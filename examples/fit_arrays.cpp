// Fits arrays in memory: here a quarter car's own response, so that the rates that made it come back.
#include <cmath>
#include <cstdio>
#include <string>

#include <fourpost/fit.h>
#include <fourpost/response.h>
#include <fourpost/vehicle.h>

namespace fp = fourpost::api;

int main(int, char** arguments) try {
  fp::Vehicle car = fp::ReadVehicle(std::string(arguments[1]) + "/studies/starter/vehicle.urdf");
  fp::Study study(car);
  study.free = {"k", "c_bump", "c_rebound"};
  car.Set("k", "26 kN/m");
  fp::SteppedSineTest test{.frequency_Hz = {0.6, 1, 1.5, 2, 3, 5, 8, 12}, .amplitude_m = {0.01}};
  const fp::Response measured = fp::Respond(car, {test.frequency_Hz, test.amplitude_m});
  for (const char* sensor : {"a_body", "a_wheel", "s_strut"})
    test.channels[sensor] = {.frf = measured.At(sensor).frf, .mean = measured.At(sensor).mean};
  study.Add(test);
  const fp::FittedParameter k = fp::Fit(study, arguments[2]).At("k");
  std::printf("k = %.6g +- %.2g N/m\n", k.value, k.sd);
  return std::abs(k.value / 26e3 - 1) < 1e-6 ? 0 : 1;
} catch (const fp::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
