#include "analysis/files/csv_text_mark.h"

namespace fourpost {
namespace {

constexpr char kMark = '\'';

/// Apostrophes before the sign are text marks of text marks.
bool IsFormula(std::string_view text) {
  const std::size_t at = text.find_first_not_of(kMark);
  return at != std::string_view::npos && std::string_view("=+-@").find(text[at]) != std::string_view::npos;
}

}  // namespace

std::string WithTextMark(std::string_view text) {
  return (IsFormula(text) ? std::string(1, kMark) : "") + std::string(text);
}

std::string_view WithoutTextMark(std::string_view field) {
  return field.starts_with(kMark) && IsFormula(field) ? field.substr(1) : field;
}

}  // namespace fourpost
