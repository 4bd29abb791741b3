#include "vehicles/templates/hard_points.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "analysis/files/text_file.h"
#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "analysis/text/units.h"
#include "vehicles/templates/findings.h"

namespace fourpost {
namespace {

constexpr std::array<std::string_view, 7> kColumns = {"axle", "point", "x", "y", "z", "on", "note"};
constexpr std::size_t kNoColumn = kColumns.size();

std::string Trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

std::vector<std::string> CellsOf(std::string_view line, char separator) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    else if (c == separator && !is_quoted) cells.emplace_back();
    else cells.back() += c;
  }
  for (std::string& cell : cells) cell = Trimmed(cell);
  return cells;
}

char SeparatorOf(std::string_view header) {
  for (const char separator : {';', '\t'})
    if (header.find(separator) != std::string_view::npos) return separator;
  return ',';
}

struct PointColumn {
  /// Of kColumns.
  std::size_t kind = kNoColumn;
  /// As in the header.
  std::string text;
  /// Of a coordinate: metres per unit, negative for one that counts the other way.
  double metres = 1;
};

/// A table, read line by line.
class PointTable {
 public:
  PointTable(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  void Take(std::string_view line, int number) {
    if (Trimmed(line).empty() || Trimmed(line).front() == '#') return;
    line_ = number;
    if (columns_.empty()) return ReadHeader(line);
    ReadRow(CellsOf(line, separator_));
  }

  std::vector<HardPoint> Points() {
    if (columns_.empty()) Report(kPointsWithoutHeader);
    else if (!has_rows_ && !is_faulty_) Report(kPointsEmpty);
    return points_;
  }

 private:
  void Report(const Finding& finding, const std::vector<std::string>& words = {}) {
    diagnostics_.Report(finding, {file_, line_}, words);
  }

  void ReadHeader(std::string_view line) {
    separator_ = SeparatorOf(line);
    for (const std::string& cell : CellsOf(line, separator_)) columns_.push_back(ColumnOf(cell));
    const bool has_known =
        std::any_of(columns_.begin(), columns_.end(), [](const PointColumn& c) { return c.kind < 5; });
    if (!has_known) {
      Report(kPointsWithoutHeader);
      is_faulty_ = true;
      return;
    }
    for (std::size_t kind = 0; kind < kColumns.size(); ++kind) {
      const auto count =
          std::count_if(columns_.begin(), columns_.end(), [&](const PointColumn& c) { return c.kind == kind; });
      if (count > 1) Report(kPointsColumnTwice, {std::string(kColumns[kind])});
      if (count == 0 && kind < 5) Report(kPointsColumnMissing, {std::string(kColumns[kind])});
      is_faulty_ = is_faulty_ || count > 1 || (count == 0 && kind < 5);
    }
    for (const PointColumn& column : columns_) {
      if (column.kind == kNoColumn)
        Report(kPointsColumnUnknown, {column.text, DidYouMean(column.text, std::span(kColumns))});
      if (column.metres == 0) {
        const std::string name(kColumns[column.kind]);
        Report(kPointsUnit, {column.text, name, name});
      }
      is_faulty_ = is_faulty_ || column.kind == kNoColumn || column.metres == 0;
    }
  }

  /// "-x [mm]", "x (mm)", "x_mm", "x mm", "point". A coordinate without a unit of length has no metres.
  static PointColumn ColumnOf(const std::string& text) {
    PointColumn column{.text = text};
    std::string name;
    std::string unit;
    for (const char c : text) {
      const char lower = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      if (std::string_view("[]() _").find(c) != std::string_view::npos) {
        if (!name.empty() && unit.empty()) unit = " ";
      } else if (unit.empty()) {
        name += lower;
      } else {
        unit += c;
      }
    }
    const bool is_reversed = !name.empty() && name.front() == '-';
    if (is_reversed) name.erase(0, 1);
    const auto found = std::find(kColumns.begin(), kColumns.end(), name);
    column.kind = static_cast<std::size_t>(found - kColumns.begin());
    const bool is_coordinate = column.kind >= 2 && column.kind < 5;
    if (!is_coordinate) {
      if (is_reversed || !Trimmed(unit).empty()) column.kind = kNoColumn;
      return column;
    }
    const std::optional<Unit> parsed = ParseUnit(Trimmed(unit));
    column.metres = parsed && parsed->dimension == kLength ? parsed->si : 0;
    if (is_reversed) column.metres = -column.metres;
    return column;
  }

  void ReadRow(const std::vector<std::string>& cells) {
    has_rows_ = true;
    if (is_faulty_) return;
    // Trailing notes may be left out.
    std::size_t needed = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (columns_[i].kind < 5) needed = i + 1;
    if (cells.size() < needed || cells.size() > columns_.size())
      return Report(kPointsCells, {std::to_string(cells.size()), std::to_string(columns_.size())});
    HardPoint point{.line = line_};
    bool is_good = true;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      switch (columns_[i].kind) {
        case 0: point.axle = cells[i]; break;
        case 1: point.name = cells[i]; break;
        case 5: point.on = cells[i]; break;
        case 6: break;
        default: is_good = ReadCoordinate(cells[i], columns_[i], point) && is_good;
      }
    }
    if (is_good) points_.push_back(point);
    else
      points_.push_back({.axle = point.axle,
                         .name = point.name,
                         .xyz = Eigen::Vector3d::Constant(NAN),
                         .on = point.on,
                         .line = line_});
  }

  bool ReadCoordinate(std::string text, const PointColumn& column, HardPoint& point) {
    if (separator_ != ',') std::replace(text.begin(), text.end(), ',', '.');
    const double metres = std::abs(column.metres);
    const int power = static_cast<int>(std::lround(std::log10(metres)));
    // Powers of ten are exact: 1.1 mm is the double 0.0011.
    const bool is_power = std::abs(std::pow(10, power) - metres) < 1e-12 * metres;
    const std::optional<double> number = ParseNumber(text, is_power ? power : 0);
    if (!number) {
      Report(kPointsNumber, {text, column.text});
      return false;
    }
    const double size = is_power ? *number : *number * metres;
    point.xyz[static_cast<Eigen::Index>(column.kind) - 2] = column.metres < 0 ? 0 - size : size;
    return true;
  }

  std::string file_;
  Diagnostics& diagnostics_;
  int line_ = 0;
  char separator_ = ',';
  bool is_faulty_ = false;
  bool has_rows_ = false;
  std::vector<PointColumn> columns_;
  std::vector<HardPoint> points_;
};

}  // namespace

std::vector<HardPoint> HardPointsOf(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  PointTable table(file, diagnostics);
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    table.Take(text.substr(0, end), line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return table.Points();
}

std::vector<HardPoint> ReadHardPoints(const std::filesystem::path& file, Diagnostics& diagnostics) {
  const std::optional<std::string> text = ReadTextFile(file, diagnostics);
  if (!text) return {};
  return HardPointsOf(*text, file.string(), diagnostics);
}

}  // namespace fourpost
