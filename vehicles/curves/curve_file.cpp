#include "vehicles/curves/curve_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <system_error>

#include "analysis/files/recorded_table.h"
#include "analysis/files/recorded_unit.h"
#include "analysis/files/text_file.h"
#include "analysis/text/nearest.h"
#include "analysis/text/number.h"
#include "analysis/text/short_number.h"
#include "analysis/text/units.h"
#include "vehicles/curves/curve_limits.h"
#include "vehicles/curves/curve_points.h"
#include "vehicles/curves/findings.h"
#include "vehicles/curves/property_file.h"

namespace fourpost {
namespace {

/// What a file holds, in words of the table and of the property file.
struct CurveForm {
  std::string_view x;
  /// Another name of the column.
  std::string_view other_x;
  Dimension dimension;
  std::string_view x_unit;
  /// Of property files.
  std::string_view type;
  std::string_view what;
  /// Signs of both coordinates there.
  int sign = 1;
  std::string_view block = "CURVE";
};

constexpr CurveForm kSpring = {.x = "extension",
                               .other_x = "extension",
                               .dimension = kLength,
                               .x_unit = "mm",
                               .type = "spr",
                               .what = "a spring",
                               .sign = -1};
constexpr CurveForm kDamper = {
    .x = "speed", .other_x = "velocity", .dimension = kVelocity, .x_unit = "m/s", .type = "dpr", .what = "a damper"};

constexpr CurveForm kTyre = {.x = "deflection",
                             .other_x = "deflection",
                             .dimension = kLength,
                             .x_unit = "mm",
                             .type = "tir",
                             .what = "a tyre",
                             .block = "DEFLECTION_LOAD_CURVE"};

/// The unit itself where quantities can be shown in it; else another.
std::string ShownUnit(const std::string& written, const Unit& recorded, std::string_view other) {
  const std::optional<Unit> unit = ParseUnit(written);
  const bool is_same = unit && unit->dimension == recorded.dimension && unit->si == recorded.si;
  return is_same ? written : std::string(other);
}

/// One of this size; else another.
std::string UnitOfSize(double si, std::span<const std::string_view> known, std::string_view other) {
  constexpr double kRounding = 1e-9;
  for (const std::string_view name : known)
    if (const std::optional<Unit> unit = ParseUnit(name); unit && std::abs(unit->si / si - 1) < kRounding)
      return std::string(name);
  return std::string(other);
}

/// A column of a table.
struct CurveColumn {
  std::size_t index = 0;
  /// In which its numbers are shown.
  std::string unit = {};
  /// SI per unit, negative where it counts the other way.
  double si = 1;
};

/// Points of a table with named columns.
class CurveTable {
 public:
  CurveTable(const RecordedTable& table, const CurveForm& form, Diagnostics& diagnostics)
      : table_(table), form_(form), diagnostics_(diagnostics) {}

  /// With the units of the file for `names`.
  std::optional<std::vector<CurvePoint>> Points(CurveNames& names) {
    const std::optional<CurveColumn> x = Column({form_.x, form_.other_x}, form_.dimension, form_.x_unit);
    const std::optional<CurveColumn> force = Column({"force", "force"}, kForce, "N");
    if (!x || !force) return std::nullopt;
    names.x_unit = x->unit;
    names.force_unit = force->unit;
    std::vector<CurvePoint> points;
    const std::size_t rows = std::min(table_.rows(x->index), table_.rows(force->index));
    bool is_good = true;
    for (std::size_t row = 0; row < rows && !HasManyFaults(diagnostics_); ++row) {
      const std::optional<double> at = Number(row, *x);
      const std::optional<double> value = Number(row, *force);
      is_good = is_good && at && value;
      if (at && value) points.push_back({*at, *value, table_.line(row)});
    }
    if (!is_good) return std::nullopt;
    return points;
  }

 private:
  static std::string LowerCase(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) {
      return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : static_cast<char>(c);
    });
    return lower;
  }

  std::optional<CurveColumn> Column(const std::array<std::string_view, 2>& names, const Dimension& dimension,
                                    std::string_view such) {
    std::optional<CurveColumn> found;
    for (std::size_t i = 0; i < table_.names().size(); ++i) {
      const std::string given = LowerCase(table_.names()[i]);
      const std::string_view name =
          given.starts_with('-') ? std::string_view(given).substr(1) : std::string_view(given);
      if (name != names[0] && name != names[1]) continue;
      if (found) {
        diagnostics_.Report(kCurveColumnTwice, {table_.file(), table_.names_line()}, {table_.names()[i]});
        return std::nullopt;
      }
      found = CurveColumn{.index = i, .si = given.starts_with('-') ? -1.0 : 1.0};
    }
    const std::string wanted(names[0]);
    if (!found) {
      diagnostics_.Report(
          kCurveColumnMissing, {table_.file(), table_.names_line()},
          {wanted, DidYouMean(wanted, table_.names()), std::string(form_.x) + " and force", std::string(form_.x)});
      return std::nullopt;
    }
    const std::string& written = table_.unit(found->index);
    const std::optional<Unit> unit = ParseRecordedUnit(written);
    if (!unit || unit->dimension != dimension || !(unit->si > 0)) {
      diagnostics_.Report(kCurveUnit, {table_.file(), std::max(table_.names_line(), table_.units_line())},
                          {table_.names()[found->index], written.empty() ? "no unit" : "the unit '" + written + "'",
                           "unit of " + DimensionName(dimension), wanted, std::string(such)});
      return std::nullopt;
    }
    found->si *= unit->si;
    found->unit = ShownUnit(written, *unit, such);
    return found;
  }

  std::optional<double> Number(std::size_t row, const CurveColumn& column) {
    const std::optional<double> number = table_.Number(row, column.index);
    if (number && !std::isnan(*number)) {
      const double size = std::abs(column.si);
      // At its digits, which powers of ten of a unit only shift.
      const double si = NumberInSi(FormatNumber(*number), size).value_or(*number * size);
      return column.si < 0 ? 0 - si : si;
    }
    table_.Report(kCurveNumber, row, {table_.Text(row, column.index), table_.names()[column.index]}, diagnostics_);
    return std::nullopt;
  }

  const RecordedTable& table_;
  const CurveForm& form_;
  Diagnostics& diagnostics_;
};

std::optional<std::pair<double, double>> TwoNumbers(std::string_view text, double first_si, double second_si) {
  constexpr std::string_view kBlanks = " \t,;";
  const std::size_t end = text.find_first_of(kBlanks);
  if (end == std::string_view::npos) return std::nullopt;
  const std::size_t second = text.find_first_not_of(kBlanks, end);
  if (second == std::string_view::npos) return std::nullopt;
  const std::optional<double> x = NumberInSi(text.substr(0, end), first_si);
  const std::optional<double> y = NumberInSi(text.substr(second), second_si);
  if (!x || !y) return std::nullopt;
  return std::pair(*x, *y);
}

/// Rows of a block times these units; nothing, reported, where one is no point.
std::optional<std::vector<CurvePoint>> PointsOf(const PropertyFile& file, const PropertyFile::Block& block,
                                                std::string_view x, double x_si, double force_si) {
  std::vector<CurvePoint> points;
  bool is_good = true;
  for (const PropertyFile::Row& row : block.rows) {
    if (file.HasManyFaults()) return std::nullopt;
    const auto numbers = TwoNumbers(row.text, x_si, force_si);
    if (numbers) points.push_back({numbers->first, numbers->second, row.line});
    else file.Report(kTeimRow, row.line, {row.text, std::string(x)});
    is_good = is_good && numbers;
  }
  if (!is_good) return std::nullopt;
  return points;
}

std::optional<std::vector<CurvePoint>> PropertyPoints(const PropertyFile& file, const CurveForm& form,
                                                      CurveNames& names) {
  const std::string what = std::string(form.what) + ", type '" + std::string(form.type) + "'";
  file.CheckType(form.type, form.what);
  const std::optional<PropertyFile::Units> units = file.ReadUnits(false, what);
  const PropertyFile::Block* block = file.Find(form.block, what);
  if (!units || !block) return std::nullopt;
  const double x_si = form.dimension == kVelocity ? units->length / units->time : units->length;
  constexpr std::array<std::string_view, 6> kLengths = {"mm", "m", "cm", "km", "in", "ft"};
  constexpr std::array<std::string_view, 6> kSpeeds = {"mm/s", "m/s", "cm/s", "km/h", "in/s", "ft/s"};
  constexpr std::array<std::string_view, 4> kForces = {"N", "kN", "lbf", "MN"};
  names.x_unit = UnitOfSize(x_si, form.dimension == kVelocity ? kSpeeds : kLengths, form.x_unit);
  names.force_unit = UnitOfSize(units->force, kForces, "N");
  std::optional<std::vector<CurvePoint>> points = PointsOf(file, *block, form.x, x_si, units->force);
  if (points && form.sign < 0)
    for (CurvePoint& point : *points) point = {0 - point.x, 0 - point.force, point.line};
  return points;
}

std::optional<double> FreeLength(const PropertyFile& file) {
  const PropertyFile::Block* block = file.FindAny("SPRING_DATA");
  const std::optional<PropertyFile::Units> units = file.FindAny("UNITS") ? file.ReadUnits(false, "") : std::nullopt;
  if (!block || !units || !block->values.contains("FREE_LENGTH")) return std::nullopt;
  const std::optional<double> length = file.Number("SPRING_DATA", "FREE_LENGTH", units->length, "300.0");
  if (length && !(*length > 0)) {
    const PropertyFile::Value& value = block->values.find("FREE_LENGTH")->second;
    file.Report(kTeimFreeLength, value.line, {value.text});
    return std::nullopt;
  }
  return length;
}

bool IsXml(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

/// Without a byte order mark; nothing, reported, where the file cannot be read, is too large or XML.
std::optional<std::string> ReadCurveText(const std::filesystem::path& path, Diagnostics& diagnostics) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::error_code failure;
  if (const std::uintmax_t size = std::filesystem::file_size(path, failure); !failure && size > kMostCurve_MiB << 20U) {
    diagnostics.Report(kCurveFileTooLarge, {path.string()},
                       {std::to_string(kMostCurve_MiB) + " MiB", std::to_string(kMostCurvePoints)});
    return std::nullopt;
  }
  std::optional<std::string> text = ReadTextFile(path, diagnostics);
  if (!text) return std::nullopt;
  if (text->starts_with(kByteOrderMark)) text->erase(0, kByteOrderMark.size());
  if (!IsXml(*text)) return text;
  diagnostics.Report(kCurveXml, {path.string()});
  return std::nullopt;
}

/// Of either kind of file, and in which units it has them. `free_length`: of property files, if any.
std::optional<std::vector<CurvePoint>> ReadPoints(const std::filesystem::path& path, const CurveForm& form,
                                                  CurveNames& names, std::optional<double>* free_length,
                                                  Diagnostics& diagnostics) {
  const std::optional<std::string> text = ReadCurveText(path, diagnostics);
  if (!text) return std::nullopt;
  if (PropertyFile::IsOne(*text)) {
    const PropertyFile file(path.string(), *text, diagnostics);
    if (file.HasManyFaults()) return std::nullopt;
    std::optional<std::vector<CurvePoint>> points = PropertyPoints(file, form, names);
    if (points && free_length) *free_length = FreeLength(file);
    return points;
  }
  const std::optional<RecordedTable> table = ReadRecordedTable(path, diagnostics);
  if (!table) return std::nullopt;
  try {
    return CurveTable(*table, form, diagnostics).Points(names);
  } catch (const FaultyInput& faulty) {
    diagnostics.Add(faulty.diagnostics());
    return std::nullopt;
  }
}

constexpr std::array<std::string_view, 6> kComponents = {"FX", "FY", "FZ", "TX", "TY", "TZ"};

double Chord(const CurvePoint& a, const CurvePoint& b) { return (b.force - a.force) / (b.x - a.x); }

/// As of numbers in a vehicle file.
constexpr double kLargestRate = 1e30;

/// Of one component, between the points next to zero.
std::optional<double> RateAtZero(const PropertyFile& file, std::string_view name, const PropertyFile::Units& units,
                                 bool turns, Diagnostics& diagnostics) {
  const std::string block_name = std::string(name) + "_CURVE";
  const PropertyFile::Block* block = file.Find(block_name, "a bushing, type 'bus'");
  if (!block) return std::nullopt;
  const CurveNames names = {
      .x = turns ? "angle" : "displacement", .x_unit = turns ? "deg" : "mm", .force_unit = turns ? "N*m" : "N"};
  std::optional<std::vector<CurvePoint>> points = PointsOf(file, *block, names.x, turns ? units.angle : units.length,
                                                           turns ? units.force * units.length : units.force);
  if (!points) return std::nullopt;
  // An axis along which the bush resists nothing.
  const bool is_free = points->size() > 1 && std::all_of(points->begin(), points->end(),
                                                         [](const CurvePoint& point) { return point.force == 0; });
  if (is_free) return 0;
  if (!OrderPoints(file.file(), names, *points, diagnostics)) return std::nullopt;
  if (!(points->front().x < 0) || !(points->back().x > 0)) {
    file.Report(kBushingCurveZero, block->line, {block_name});
    return std::nullopt;
  }
  const auto below =
      std::find_if(points->rbegin(), points->rend(), [](const CurvePoint& point) { return point.x < 0; });
  const auto above = std::find_if(points->begin(), points->end(), [](const CurvePoint& point) { return point.x > 0; });
  const double rate = Chord(*below, *above);
  const double mean = Chord(points->front(), points->back());
  if (!(rate <= kLargestRate)) {
    file.Report(kBushingRateTooLarge, above->line, {block_name});
    return std::nullopt;
  }
  // A tenth is what bushes of one drawing differ by.
  if (std::abs(mean - rate) > 0.1 * rate) {
    const std::string unit = turns ? "N*m/deg" : "N/mm";
    const auto shown = [&](double si) { return FormatQuantity(AtDigits(si, 4), unit); };
    file.Report(kBushingCurveBent, block->line, {block_name, shown(rate), shown(mean)});
  }
  return rate;
}

double DampingOf(const PropertyFile& file, const std::string& name, double si) {
  const double damping = file.Number("DAMPING", name, si, "0.0").value_or(0);
  if (damping < 0) {
    const PropertyFile::Value& value = file.FindAny("DAMPING")->values.find(name)->second;
    file.Report(kBushingDamping, value.line, {name, value.text});
  }
  return damping;
}

BushingRates RatesOf(const std::filesystem::path& path, Diagnostics& diagnostics) {
  BushingRates rates;
  const std::optional<std::string> text = ReadCurveText(path, diagnostics);
  if (!text) return rates;
  const PropertyFile file(path.string(), *text, diagnostics);
  if (file.HasManyFaults()) return rates;
  file.CheckType("bus", "a bushing");
  const std::optional<PropertyFile::Units> units = file.ReadUnits(true, "a bushing, type 'bus'");
  for (std::size_t i = 0; units && i < kComponents.size(); ++i) {
    const bool turns = i >= 3;
    rates.stiffness[i] = RateAtZero(file, kComponents[i], *units, turns, diagnostics).value_or(0);
    const double si = units->force * units->time * (turns ? units->length / units->angle : 1 / units->length);
    if (file.FindAny("DAMPING")) rates.damping[i] = DampingOf(file, std::string(kComponents[i]) + "_DAMPING", si);
  }
  return rates;
}

}  // namespace

std::optional<SpringCurve> ReadSpringCurve(const std::filesystem::path& file, Diagnostics& diagnostics) {
  Diagnostics found;
  SpringCurve curve;
  CurveNames names = {.x = "extension", .x_unit = "mm"};
  std::optional<std::vector<CurvePoint>> points = ReadPoints(file, kSpring, names, &curve.free_length, found);
  if (points && OrderPoints(file.string(), names, *points, found)) curve.points = *std::move(points);
  diagnostics.Add(found);
  if (found.HasErrors()) return std::nullopt;
  return curve;
}

std::optional<std::vector<CurvePoint>> ReadDamperCurve(const std::filesystem::path& file, Diagnostics& diagnostics) {
  Diagnostics found;
  CurveNames names = {.x = "speed", .x_unit = "m/s"};
  std::optional<std::vector<CurvePoint>> points = ReadPoints(file, kDamper, names, nullptr, found);
  // Points that drive the motion everywhere fall: one fault, not one for each.
  if (points && CheckResistance(file.string(), names, *points, found))
    OrderPoints(file.string(), names, *points, found);
  diagnostics.Add(found);
  if (found.HasErrors()) return std::nullopt;
  return points;
}

std::optional<std::vector<CurvePoint>> ReadTyreCurve(const std::filesystem::path& file, Diagnostics& diagnostics) {
  Diagnostics found;
  CurveNames names = {.x = "deflection", .x_unit = "mm"};
  std::optional<std::vector<CurvePoint>> points = ReadPoints(file, kTyre, names, nullptr, found);
  if (points) OrderPoints(file.string(), names, *points, found);
  diagnostics.Add(found);
  if (found.HasErrors()) return std::nullopt;
  return points;
}

std::optional<BushingRates> ReadBushingRates(const std::filesystem::path& file, Diagnostics& diagnostics) {
  Diagnostics found;
  const BushingRates rates = RatesOf(file, found);
  diagnostics.Add(found);
  if (found.HasErrors()) return std::nullopt;
  return rates;
}

}  // namespace fourpost
