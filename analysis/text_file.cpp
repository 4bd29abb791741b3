#include "analysis/text_file.h"

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "analysis/near_file.h"

namespace fourpost {

std::optional<std::string> ReadTextFile(const std::filesystem::path& file, Diagnostics& diagnostics) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  // Inserting no characters would set failbit, as a failure does: an empty file is passed over.
  if (stream && stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  // Reading a folder opens well and fails here.
  if (errno == 0 && stream.is_open() && !stream.bad() && text) return std::move(text).str();
  const std::string reason = std::generic_category().message(errno);
  diagnostics.Error(file.string(), 0, "cannot be read: " + reason + DidYouMeanFile(file));
  return std::nullopt;
}

}  // namespace fourpost
