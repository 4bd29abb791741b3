#pragma once

#include <string>

#include <gtest/gtest.h>

#include "analysis/text/diagnostics.h"
#include "tests/temporary_folder.h"

namespace fourpost {

/// What `read` finds in a file of this name and text, which it must refuse.
template <typename Read>
Diagnostics FaultsOf(const std::string& name, const std::string& text, Read read) {
  const TemporaryFolder folder;
  const std::string path = folder.Write(name, text);
  Diagnostics diagnostics;
  EXPECT_FALSE(read(path, diagnostics));
  for (const Diagnostic& item : diagnostics.items()) EXPECT_EQ(item.place.file, path);
  return diagnostics;
}

}  // namespace fourpost
