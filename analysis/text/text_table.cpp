#include "analysis/text/text_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "analysis/text/shortened.h"
#include "analysis/text/table_width.h"
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

std::size_t table_width = std::numeric_limits<std::size_t>::max();

/// The columns of each block, as many as there is room for, and one beside the first at least.
std::vector<std::vector<std::size_t>> ColumnBlocks(const std::vector<std::size_t>& widths) {
  std::vector<std::vector<std::size_t>> blocks = {{0}};
  std::size_t used = widths[0];
  for (std::size_t c = 1; c < widths.size(); ++c) {
    if (used + 2 + widths[c] > table_width && blocks.back().size() > 1) {
      blocks.push_back({0});
      used = widths[0];
    }
    blocks.back().push_back(c);
    used += 2 + widths[c];
  }
  return blocks;
}

/// These columns of a table.
std::string ColumnsText(const std::vector<std::vector<std::string>>& rows, const std::vector<std::size_t>& block,
                        const std::vector<std::size_t>& widths) {
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (const std::size_t c : block) {
      const std::string padding(widths[c] - Width(row[c]), ' ');
      const bool is_number = rows.size() > 1 && IsNumber(rows[1][c]);
      line += (c == 0 ? "" : "  ") + (is_number ? padding + row[c] : row[c] + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
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
  for (const auto& row : rows_)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], Width(row[c]));
  std::string text;
  for (const std::vector<std::size_t>& block : ColumnBlocks(widths))
    text += (text.empty() ? "" : "\n") + ColumnsText(rows_, block, widths);
  return text;
}

void SetTableWidth(std::size_t columns) { table_width = columns; }

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
