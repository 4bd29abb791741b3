#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/text/diagnostics.h"
#include "vehicles/curves/curve_limits.h"

namespace fourpost {

/// A file in TeimOrbit format, as Adams writes properties of springs, dampers and bushings: blocks `[NAME]` of lines
/// `NAME = VALUE` and rows of a table below its names of columns in braces; `$` and `!` begin comments. Names have no
/// case. Subblocks `(NAME)` are passed over: these files have comments in them.
/// Source: Adams Tire, "About", on the format; Altair MotionView, AutoSpring, AutoDamper and AutoBush, on the blocks.
class PropertyFile {
 public:
  struct Value {
    /// Without quotes.
    std::string text;
    int line = 0;
  };
  struct Row {
    std::string text;
    int line = 0;
  };
  struct Block {
    int line = 0;
    /// By names in capitals.
    std::map<std::string, Value, std::less<>> values;
    std::vector<Row> rows;
  };
  /// SI units per unit of the file.
  struct Units {
    double length = 1;
    double force = 1;
    double angle = 1;
    double time = 1;
  };

  /// Reports lines that are none of such a file, and blocks that stand twice. Ends at HasManyFaults().
  PropertyFile(std::string file, std::string_view text, Diagnostics& diagnostics);

  /// Whether a text looks like one: its first line that is no comment is a block.
  static bool IsOne(std::string_view text);

  /// Reports a file of another type: `type` as in 'spr', `what` as in "a spring". Files need not state a type.
  void CheckType(std::string_view type, std::string_view what) const;
  /// nullptr, reported, for one that is missing. `what` as in "springs".
  const Block* Find(std::string_view name, std::string_view what) const;
  /// The same without a report.
  const Block* FindAny(std::string_view name) const;
  /// Reports those that are missing or unknown. `with_angle`: the angle must be stated.
  std::optional<Units> ReadUnits(bool with_angle, std::string_view what) const;
  /// The number of a value times `si`; nothing, reported, for one that is missing or none. `sample`: as in "300.0".
  std::optional<double> Number(std::string_view block, std::string_view name, double si, std::string_view sample) const;

  const std::string& file() const { return file_; }
  bool HasManyFaults() const { return fourpost::HasManyFaults(diagnostics_); }
  void Report(const Finding& finding, int line, const std::vector<std::string>& words = {}) const {
    diagnostics_.Report(finding, {file_, line}, words);
  }

 private:
  void Take(std::string_view line, int number);

  std::string file_;
  Diagnostics& diagnostics_;
  std::map<std::string, Block, std::less<>> blocks_;
  Block* block_ = nullptr;
  bool is_in_subblock_ = false;
};

/// A number of a text times a unit's size, rounded once where that is a power of ten: "1.1" in mm is the double 0.0011.
std::optional<double> NumberInSi(std::string_view text, double si);

}  // namespace fourpost
