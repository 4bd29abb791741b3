#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json.hpp>

#include "identify/suggest/suggestions.h"

namespace fourpost {

/// How much of it is expected, with units: "149 N"; of a channel "2 ms" or "times 1.02".
std::string ExpectedText(const SuggestedAddition& suggestion, const LoadedStudy& study);

/// An entry of the lists of `suggest` and result.json; numbers in SI. `number`: its place in the list, from 1.
nlohmann::ordered_json SuggestionJson(const SuggestedAddition& suggestion, std::size_t number,
                                      const LoadedStudy& study);

}  // namespace fourpost
