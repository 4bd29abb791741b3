#include <vector>

#include "vehicles/description/vehicle.h"

int main() {
  fourpost::Vehicle vehicle;
  vehicle.parameters.push_back({.name = "k_front", .value = 32e3});
  return vehicle.ParameterValues() == std::vector{32e3} ? 0 : 1;
}
