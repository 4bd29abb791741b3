#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "vehicles/description/vehicle.h"
#include "vehicles/tags/file_faults.h"
#include "vehicles/tags/tag.h"

namespace fourpost {

/// What a file states by `like` and `like_sd` of the parameter at this place; nothing where it states neither, and
/// after an error. `sound`: of all parameters, whether they were read without an error of their own.
std::optional<Parameter::Likeness> ReadLikeness(const Tag& tag, std::size_t place,
                                                const std::vector<Parameter>& parameters,
                                                const std::vector<bool>& sound, FileFaults& faults);

}  // namespace fourpost
