#pragma once

#include <string>

namespace fourpost {

/// A parameter of the file; numbers in `unit`.
struct ParameterText {
  std::string name;
  double value = 0;
  double lower = 0;
  double upper = 0;
  double precision = 0;
  std::string unit;
  std::string source;
};
std::string Text(const ParameterText& parameter);

}  // namespace fourpost
