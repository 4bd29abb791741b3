#pragma once

#include <string>

#include "identify/choice/choice_answer.h"

namespace fourpost {

/// choose.html: one file that needs no network.
std::string ChoicePage(const ChoiceAnswer& answer);

}  // namespace fourpost
