#pragma once

#include <string>

#include "analysis/files/recording/recording.h"

namespace fourpost {

/// A universal file with data set 151 and a binary data set 58b of double precision (IEEE 754, little endian) per
/// channel, which reads back bit for bit; channels may have rates or times of their own. Start and step have the five
/// decimals that the format gives them: samples whose step needs more are written with their times. Throws
/// std::invalid_argument without channels, for a channel without values or without times.
std::string UniversalBytes(const Recording& recording);

}  // namespace fourpost
