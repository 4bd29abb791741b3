#pragma once

#include <string>

#include <gtest/gtest.h>

#include "analysis/text/diagnostics.h"
#include "tests/temporary_folder.h"

namespace fourpost {

/// What `read` finds in a file of this name and text, which it must refuse; without the file's folder.
template <typename Read>
std::string FaultsOf(const std::string& name, const std::string& text, Read read) {
  const TemporaryFolder folder;
  const std::string path = folder.Write(name, text);
  Diagnostics diagnostics;
  EXPECT_FALSE(read(path, diagnostics));
  std::string faults = diagnostics.Format();
  for (std::size_t at = faults.find(path); at != std::string::npos; at = faults.find(path))
    faults.replace(at, path.size(), name);
  return faults;
}

}  // namespace fourpost
