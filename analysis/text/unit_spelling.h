#pragma once

#include <string>
#include <string_view>

namespace fourpost {

/// Units that are spelled out or in plural, in any case, by their short names, in a product too: "inches/second" is "in/s".
/// All else stays as it is; "lb" and "pounds", which are a mass or a force, as well.
std::string WithShortNames(std::string_view unit);

/// What to write in place of a unit that ParseUnit does not know, behind a number or not, to end a message with:
/// ", did you mean 'kN'?", or ": pounds are a mass or a force, write 'lbm' or 'lbf'". Empty where nothing is near.
std::string UnitHint(std::string_view text);

}  // namespace fourpost
