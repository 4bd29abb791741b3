#pragma once

#include <string>
#include <string_view>

namespace fourpost {

/// Bytes in the digits of RFC 4648, section 4.
std::string Base64(std::string_view bytes);

}  // namespace fourpost
