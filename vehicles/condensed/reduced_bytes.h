#pragma once

#include <string>
#include <string_view>

#include "vehicles/condensed/reduced_data.h"

namespace fourpost {

/// A reduced vehicle as bytes, the same on every machine; numbers keep all their bits. What ReducedVehicle does not
/// need, such as where sensors sit, is left out.
std::string BytesOf(const ReducedData& data);

/// Throws std::invalid_argument for bytes that BytesOf() of this version has not written.
ReducedData ReducedDataOf(std::string_view bytes);

}  // namespace fourpost
