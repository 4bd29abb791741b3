// libFuzzer's entry to one of the functions of fuzz_target.h, named by FOURPOST_FUZZ_TARGET.

#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fourpost::FOURPOST_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
