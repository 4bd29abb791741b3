#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fourpost {

/// A text of at most about `most` bytes: what is longer keeps its beginning and its end, whole characters, with a note
/// of how many bytes were left out between. Names in files may be of any length; messages are for people.
std::string Shortened(std::string_view text, std::size_t most);

}  // namespace fourpost
