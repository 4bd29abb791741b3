#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "identify/report/run_result.h"

namespace fourpost {

// Tables of a report as HTML; empty where there is nothing to show.

/// Intervals of 95 % by profile likelihood.
std::string ProfileTableHtml(const nlohmann::json& result, const RunContents& run);

/// What differs between model and measurement, by channel.
std::string ChannelTableHtml(const nlohmann::json& result);

/// `modes`: of SceneJson().
std::string ModeTableHtml(const nlohmann::json& modes);

/// A section of that table beside the map of the poles.
std::string ModeSectionHtml(const nlohmann::json& modes);

/// What searched, and what its accelerations and migrations brought; empty for results that do not say.
std::string SearchNoteHtml(const nlohmann::json& result);

/// The refinements, each from its own start.
std::string StartTableHtml(const nlohmann::json& result);

/// Every setting, and the versions.
std::string SettingsHtml(const nlohmann::json& result);

}  // namespace fourpost
