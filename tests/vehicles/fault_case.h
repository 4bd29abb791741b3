#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/text/finding.h"

namespace fourpost {

/// One thing broken in a good file.
struct FaultCase {
  std::string name;
  std::string from;
  std::string to;
  /// Stands first in the line that must be named.
  std::string at;
  const Finding& kind;
  /// Names and numbers in the message.
  std::vector<std::string> words = {};
};

inline std::ostream& operator<<(std::ostream& out, const FaultCase& fault) { return out << fault.name; }

inline std::string CaseName(const ::testing::TestParamInfo<FaultCase>& info) { return info.param.name; }

}  // namespace fourpost
