#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fourpost {

/// A number over two things that can be set, cell by cell.
struct HeatChart {
  struct Cell {
    /// Not finite: there is none.
    double value = 0;
    /// Drawn pale: it may not be chosen.
    bool is_barred = false;
    /// Cells with this mark are framed together.
    bool is_framed = false;
  };
  /// A mark in a cell, by column and row.
  struct Mark {
    std::string label;
    std::pair<std::size_t, std::size_t> place;
  };

  std::string title;
  std::string note;
  /// "front", "rear": what the columns and the rows are, and what each of them is called.
  std::string x_label;
  std::string y_label;
  std::vector<std::string> columns;
  std::vector<std::string> rows;
  /// Rows x columns; the first row is drawn at the foot.
  std::vector<std::vector<Cell>> cells;
  /// "comfort and grip, change against now, %".
  std::string value_label;
  std::string framed_label;
  std::string barred_label;
  /// A ring, and a cross.
  std::optional<Mark> ring;
  std::optional<Mark> cross;
};

/// The map as an SVG document: blue below zero, white at zero, orange above, by the root of the size, as the legend
/// shows. Throws std::invalid_argument for a map without cells, for rows of another length than the columns, and
/// for a mark outside.
std::string HeatSvg(const HeatChart& chart);

}  // namespace fourpost
