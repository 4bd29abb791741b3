#pragma once

#include <string>

namespace fourpost {

/// What the words and signs of a ride's tables mean, as a list that is seen on demand, HTML; the scripts show each
/// where the pointer rests on it.
std::string RideTermsHtml();

}  // namespace fourpost
