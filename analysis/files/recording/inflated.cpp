#include "analysis/files/recording/inflated.h"

#include <zlib.h>

namespace fourpost {

std::string Inflated(std::string_view packed, std::uint64_t size) {
  if (size / kClosestDeflated > packed.size()) return {};
  std::string bytes(size, '\0');
  uLongf held = size;
  const int code = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &held,
                              reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  return code == Z_OK && held == size ? bytes : std::string();
}

}  // namespace fourpost
