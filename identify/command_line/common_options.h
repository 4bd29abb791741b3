#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "vehicles/requests/amplitude_limits.h"

namespace fourpost {

// Options that several commands share, alike in name and meaning; what they fill must live until all is parsed.

/// An option that may be given several times, with one value each: a file that follows is none of them.
CLI::Option* AddList(CLI::App& app, const char* name, std::vector<std::string>& values, const char* help);

/// MODEL
void AddVehicle(CLI::App& app, std::filesystem::path& file);

/// --set
CLI::Option* AddSettings(CLI::App& app, std::vector<std::string>& settings);

/// --channels
CLI::Option* AddChannels(CLI::App& app, std::vector<std::string>& channels);

/// --amplitude, --velocity, --acceleration
std::vector<CLI::Option*> AddLimits(CLI::App& app, LimitText& limits);

/// --stroke
CLI::Option* AddStroke(CLI::App& app, std::string& stroke);

inline constexpr const char* kModeHelp =
    "Motion of the posts: heave, pitch, roll, warp, or an amplitude for each such as FL=1,FR=-1";

/// "{up,down}": the type of an option for help and completion.
std::string Braced(std::span<const std::string_view> words);

/// Takes one of these words as the value of `option`; refuses another and names what is near, or all where none is.
CLI::Validator OneOf(const char* option, std::span<const std::string_view> legal);

/// Engines of time histories.
inline constexpr std::array<std::string_view, 3> kHistoryEngines = {"auto", "reduced", "full"};

/// Takes one of these engines, by its older names too.
CLI::Validator EngineOf(std::span<const std::string_view> legal);

}  // namespace fourpost
