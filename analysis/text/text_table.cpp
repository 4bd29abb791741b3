#include "analysis/text/text_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "analysis/text/shortened.h"
#include "analysis/text/text_width.h"
#include "analysis/text/units.h"

namespace fourpost {
namespace {

/// Bytes of a cell; a name of megabytes would make each line as long.
constexpr std::size_t kWidest = 200;

/// Begins as a number does, or is what stands for one.
bool IsNumber(const std::string& text) {
  return !text.empty() && (text.find_first_of("-+0123456789") == 0 || text == "inf" || text == "undetermined");
}

}  // namespace

TextTable::TextTable(std::vector<std::string> head) { rows_.push_back(std::move(head)); }

void TextTable::Add(std::vector<std::string> row) {
  if (row.size() != rows_.front().size()) throw std::invalid_argument("a table row needs one cell per column");
  for (std::string& cell : row)
    if (cell.size() > kWidest) cell = Shortened(cell, kWidest);
  rows_.push_back(std::move(row));
}

std::string TextTable::Format() const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  std::vector<bool> numbers;
  for (std::size_t c = 0; c < widths.size(); ++c) numbers.push_back(rows_.size() > 1 && IsNumber(rows_[1][c]));
  for (const auto& row : rows_)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], Width(row[c]));
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string padding(widths[c] - Width(row[c]), ' ');
      line += (c == 0 ? "" : "  ") + (numbers[c] ? padding + row[c] : row[c] + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string Rounded(double value, int digits) {
  if (!std::isfinite(value)) return std::isnan(value) ? "-" : "inf";
  char text[64];
  const int decimals = value == 0 ? 0 : digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (decimals > 9 || decimals < -9) std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
  else std::snprintf(text, sizeof text, "%.*f", std::max(decimals, 0), value);
  return text;
}

std::string InUnit(double si, const std::string& unit, int digits) {
  return Rounded(si / ParseUnit(unit.empty() ? "1" : unit)->si, digits);
}

}  // namespace fourpost
