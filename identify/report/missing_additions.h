#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace fourpost {

/// Html of what a fit found that its model lacks (`missing` of result.json); empty of runs that did not look.

/// The first, as a part of the verdict.
std::string MostLikelyMissing(const nlohmann::json& result);
/// "delay of 's_strut' (6.94 ms)": the first, where it is a correction of a channel and not of the vehicle; empty
/// otherwise.
std::string LikeliestCorrection(const nlohmann::json& result);
/// All that the fit names, each with what it would change, and what they would change together. Where it names nothing,
/// it says so if the misfit is large.
std::string WhatIsMissing(const nlohmann::json& result, bool is_misfit_large);

}  // namespace fourpost
