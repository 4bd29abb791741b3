#pragma once

#include <memory>
#include <utility>

#include <fourpost/vehicle.h>

#include "vehicles/description/vehicle.h"

namespace fourpost::api {

/// What a public Vehicle holds.
struct Inside {
  static const fourpost::Vehicle& Of(const Vehicle& vehicle) { return *vehicle.description_; }
  static Vehicle Made(fourpost::Vehicle description) {
    return Vehicle(std::make_shared<const fourpost::Vehicle>(std::move(description)));
  }
};

}  // namespace fourpost::api
