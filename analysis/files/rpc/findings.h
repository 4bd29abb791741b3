#pragma once

#include "analysis/text/finding.h"

// What can be wrong with a file of RPC III.
namespace fourpost {

inline const Finding kRpcKeyMissing{"rpc-key-missing", Severity::kError, "RPC III header has no {}",
                                    "copy or export the file again"};
inline const Finding kRpcValue{"rpc-value", Severity::kError, "record {} of the RPC III header: {} is '{}', not {}",
                               "copy or export the file again"};
inline const Finding kRpcFormat{
    "rpc-format", Severity::kError, "record {} of the RPC III header: unknown {} '{}'",
    "export it as BINARY_IEEE_LITTLE_END, BINARY_IEEE_BIG_END, BINARY or ASCII, of SHORT_INTEGER or FLOATING_POINT"};
inline const Finding kRpcNotTime{"rpc-not-time", Severity::kError,
                                 "record {} of the RPC III header: {} is {}, not a time history of channels by groups",
                                 "export a response or drive file"};
inline const Finding kRpcAscii{"rpc-ascii", Severity::kError,
                               "RPC III file has {} numbers in ASCII behind its header, and needs {}",
                               "copy or export the file again"};

}  // namespace fourpost
