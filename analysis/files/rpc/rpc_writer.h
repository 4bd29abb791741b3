#pragma once

#include <string>

#include "analysis/files/recording/recording.h"

namespace fourpost {

enum class RpcNumbers { kShortInteger, kFloat };

/// An RPC III file (BINARY_IEEE_LITTLE_END, TIME_TYPE DRIVE) of channels with values of one length and step. Its frames
/// are the longest of 2048, 1024, 512 and 256 points that fill the record, else 256, of which the last is filled with
/// the channel's last value: a rig stays where it is.
///
/// Values that are multiples of the channel's `count` within 16 bits read back bit for bit as short integers; others
/// are rounded to 1/32752 of the channel's largest. Floats read back bit for bit where values are of single precision.
/// Throws std::invalid_argument without channels or values, for channels of different length or step, and for values
/// that are not finite.
std::string RpcBytes(const Recording& recording, RpcNumbers numbers);

}  // namespace fourpost
