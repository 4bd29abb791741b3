#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fourpost {

/// The legal name that a misspelt one probably means: the fewest letters typed wrong, left out, added or swapped with
/// their neighbour, at most a third of the longer name; case does not count. The first of equals; nothing when none is
/// that near. The view is of the legal name.
std::optional<std::string_view> NearestName(std::string_view name, std::span<const std::string_view> legal);
std::optional<std::string_view> NearestName(std::string_view name, std::span<const std::string> legal);

/// ", did you mean 'gain'?" to end a message with; empty when no legal name is near.
std::string DidYouMean(std::string_view name, std::span<const std::string_view> legal);
std::string DidYouMean(std::string_view name, std::span<const std::string> legal);

/// The same, or where no legal name is near "; there are gain, phase".
std::string DidYouMeanOrAll(std::string_view name, std::span<const std::string_view> legal);
std::string DidYouMeanOrAll(std::string_view name, std::span<const std::string> legal);

}  // namespace fourpost
