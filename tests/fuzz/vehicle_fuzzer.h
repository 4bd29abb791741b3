#pragma once

#include <cstddef>
#include <cstdint>

/// Reads the bytes as a vehicle file. What can be read must read back after a change of its parameters and
/// with its defaults written out, and its multibody system must be built and told of, or refused by a finding. Throws
/// std::logic_error for a defect of fourpost; the name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
