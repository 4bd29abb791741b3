#pragma once

#include <charconv>
#include <cstdint>
#include <string>

#include <CLI/CLI.hpp>

#include "analysis/text/diagnostics.h"
#include "identify/command_line/findings.h"

namespace fourpost {

/// Plain digits, the range of a study's seed: CLI11 itself takes "010" for 8 and "-1" for the largest of all.
inline CLI::Validator WholeNumber(const char* option) {
  const auto fault = [option](const std::string& text) -> std::string {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool good = error == std::errc() && end == text.data() + text.size() && number <= (1ULL << 62);
    const bool octal = text.size() > 1 && text[0] == '0';
    if (!good || octal) Refuse(kNotWholeNumber, Place::Option(option), {text});
    return "";
  };
  return {fault, "WHOLE NUMBER"};
}

}  // namespace fourpost
