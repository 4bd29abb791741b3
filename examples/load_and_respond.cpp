// Loads a vehicle, makes its dampers stiffer, and prints how its body answers stepped sines of its posts.
#include <cmath>
#include <cstdio>
#include <string>

#include <fourpost/response.h>
#include <fourpost/vehicle.h>

namespace fp = fourpost::api;

int main(int, char** arguments) try {
  fp::Vehicle car = fp::ReadVehicle(std::string(arguments[1]) + "/urdf/quarter_car.urdf");
  car.Set("c_bump", "2 kN*s/m");
  const fp::Response response = fp::Respond(car, {.frequency_Hz = {0.5, 1, 2, 5, 10}, .amplitude_m = {0.005}});
  const fp::ChannelResponse& body = response.At("a_sprung");
  for (std::size_t i = 0; i < response.frequency_Hz.size(); ++i)
    std::printf("%5.1f Hz: %.3f\n", response.frequency_Hz[i], std::abs(body.frf[static_cast<Eigen::Index>(i)]));
} catch (const fp::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
