#include "analysis/files/universal/universal_index.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/files/recording/file_lines.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/universal/findings.h"
#include "analysis/files/universal/universal_number.h"

namespace fourpost {
namespace {

std::string_view Trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool IsDelimiter(std::string_view line) { return Trimmed(line) == "-1"; }

std::string_view Column(std::string_view line, std::size_t from, std::size_t to) {
  return from < line.size() ? line.substr(from, to - from) : std::string_view();
}

/// Empty for what stands where there is none.
std::string NameIn(std::string_view field) {
  const std::string_view name = Trimmed(field);
  return name == "NONE" ? "" : std::string(name);
}

std::vector<std::string_view> Words(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(" \t"); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(" \t", end);
  }
  return words;
}

/// Data set 164: what lengths and forces are divided by for metres and newtons.
struct Units {
  double length = 1;
  double force = 1;
};

struct Quantity {
  int code;
  int length_exponent;
  int force_exponent;
  /// Of SI.
  const char* unit;
};
constexpr std::array<Quantity, 10> kQuantities = {{
    {2, -2, 1, "N/m^2"},
    {3, 0, 0, "m/m"},
    {8, 1, 0, "m"},
    {9, 0, 1, "N"},
    {11, 1, 0, "m/s"},
    {12, 1, 0, "m/s^2"},
    {13, 0, 1, "N"},
    {15, -2, 1, "N/m^2"},
    {17, 0, 0, "s"},
    {18, 0, 0, "Hz"},
}};

void ToSi(const Units& units, UniversalAxis& axis) {
  const auto quantity = std::find_if(kQuantities.begin(), kQuantities.end(),
                                     [&](const Quantity& other) { return other.code == axis.quantity; });
  if (!axis.unit.empty() || quantity == kQuantities.end()) return;
  axis.unit = quantity->unit;
  axis.factor = std::pow(units.length, -quantity->length_exponent) * std::pow(units.force, -quantity->force_exponent);
}

class IndexReader {
 public:
  explicit IndexReader(const FileBytes& bytes) : bytes_(bytes), lines_(bytes) {}

  UniversalIndex Read() {
    for (std::string_view line; lines_.Next(line);) {
      if (!IsDelimiter(line)) continue;
      // Of the data set before, and of this one.
      while (IsDelimiter(line) || Trimmed(line).empty())
        if (!lines_.Next(line)) return std::move(index_);
      ReadDataSet(Trimmed(line), Words(line));
    }
    return std::move(index_);
  }

 private:
  void ReadDataSet(std::string_view number, const std::vector<std::string_view>& words) {
    if (words[0] == "58b" || words[0] == "58B") return ReadBinary(words);
    if (words[0] == "58") return ReadText();
    const std::string name(words[0].substr(0, 10));
    if (name.find_first_not_of("0123456789b") != std::string::npos)
      throw RecordingFault(kUniversalBlock, {std::string(number.substr(0, 40))}, lines_.line());
    if (name == "151") ReadDescription();
    else if (name == "164") ReadUnits();
    else if ((", " + index_.others + ",").find(", " + name + ",") == std::string::npos)
      index_.others += (index_.others.empty() ? "" : ", ") + name;
    Skip();
  }

  /// To the delimiter behind a data set that is not a function; the next line is read then.
  void Skip() {
    for (std::string_view line; !ended_ && lines_.Next(line);)
      if (IsDelimiter(line)) break;
    ended_ = false;
  }

  /// False at the end of the data set, which it remembers.
  bool NextOfSet(std::string_view& line) {
    ended_ = ended_ || !lines_.Next(line) || IsDelimiter(line);
    return !ended_;
  }

  void ReadDescription() {
    for (std::string_view line; NextOfSet(line);)
      if (const std::string text = NameIn(line); !text.empty())
        index_.description += (index_.description.empty() ? "" : "\n") + text;
  }

  void ReadUnits() {
    std::string_view line;
    if (!NextOfSet(line) || !NextOfSet(line)) return;
    std::string_view rest = line;
    const std::optional<double> length = TakeUniversalNumber(rest);
    const std::optional<double> force = TakeUniversalNumber(rest);
    if (length && force && *length > 0 && *force > 0) units_ = {*length, *force};
  }

  std::string_view RequireLine(const char* what) {
    std::string_view line;
    if (!lines_.Next(line)) throw RecordingFault(kUniversalEnds, {what}, lines_.line());
    return line;
  }

  double Number(std::string_view field, int record, const char* what) {
    const std::optional<double> number = UniversalField(field);
    if (!number)
      throw RecordingFault(kUniversalField, {std::to_string(record), what, std::string(Trimmed(field)), ""},
                           lines_.line());
    return *number;
  }

  std::uint64_t Count(std::string_view field, int record, const char* what) {
    const double number = Number(field, record, what);
    if (!(number >= 0 && number < 1e15))
      throw RecordingFault(kUniversalField, {std::to_string(record), what, std::string(Trimmed(field)), " of samples"},
                           lines_.line());
    return static_cast<std::uint64_t>(number);
  }

  int Code(std::string_view field, int record, const char* what) {
    const double number = Number(field, record, what);
    return number >= -1e6 && number <= 1e6 ? static_cast<int>(number) : -1;
  }

  UniversalFunction ReadHead() {
    UniversalFunction function;
    function.line = lines_.line();
    for (std::string& id : function.id) id = NameIn(RequireLine("58"));
    ReadPoints(RequireLine("58"), function);
    ReadForm(RequireLine("58"), function);
    for (UniversalAxis* axis : {&function.abscissa, &function.ordinate, &function.denominator})
      ReadAxis(RequireLine("58"), *axis);
    // Of the z axis.
    RequireLine("58");
    function.data_at = lines_.at();
    function.data_line = lines_.line() + 1;
    return function;
  }

  void ReadPoints(std::string_view line, UniversalFunction& function) {
    function.type = Code(Column(line, 0, 5), 6, "the type of function");
    function.response = ReadPoint(line, 31);
    function.reference = ReadPoint(line, 56);
  }

  UniversalPoint ReadPoint(std::string_view line, std::size_t at) {
    constexpr std::array<const char*, 13> kDirections = {"-RZ", "-RY", "-RX", "-Z",  "-Y",  "-X", "",
                                                         "+X",  "+Y",  "+Z",  "+RX", "+RY", "+RZ"};
    UniversalPoint point;
    point.entity = NameIn(Column(line, at, at + 10));
    // Programs that do not know the point leave the columns to others.
    const double node = UniversalField(Column(line, at + 10, at + 20)).value_or(0);
    const double direction = UniversalField(Column(line, at + 20, at + 24)).value_or(0);
    if (node > 0 && node < 1e10) point.node = static_cast<std::uint64_t>(node);
    if (std::abs(direction) <= 6) point.direction = kDirections[static_cast<std::size_t>(direction + 6)];
    return point;
  }

  void ReadForm(std::string_view line, UniversalFunction& function) {
    std::vector<std::string_view> fields = Words(line);
    // Numbers that leave no blank between them stand in their columns.
    if (fields.size() != 6)
      fields = {Column(line, 0, 10),  Column(line, 10, 20), Column(line, 20, 30),
                Column(line, 30, 43), Column(line, 43, 56), Column(line, 56, 69)};
    const int type = Code(fields[0], 7, "the type of data");
    if (type != 2 && type != 4 && type != 5 && type != 6)
      throw RecordingFault(kUniversalField, {"7", "the type of data", std::string(fields[0]), " 2, 4, 5 or 6"},
                           lines_.line());
    function.is_double = type == 4 || type == 6;
    function.is_complex = type >= 5;
    function.samples = Count(fields[1], 7, "the number of samples");
    function.is_even = Code(fields[2], 7, "the spacing") != 0;
    function.start = Number(fields[3], 7, "the start");
    function.step = Number(fields[4], 7, "the step");
  }

  void ReadAxis(std::string_view line, UniversalAxis& axis) {
    axis.quantity = Code(Column(line, 0, 10), 8, "the quantity");
    axis.label = NameIn(Column(line, 26, 46));
    axis.unit = NameIn(Column(line, 47, 67));
    if (units_) ToSi(*units_, axis);
  }

  void ReadText() {
    UniversalFunction function = ReadHead();
    bool ends = false;
    std::uint64_t end = lines_.at();
    for (std::string_view line; !ends && lines_.Next(line);) {
      ends = IsDelimiter(line);
      if (!ends) end = lines_.at();
    }
    function.data_bytes = end - function.data_at;
    // A number takes a digit and a blank.
    if (function.samples > function.data_bytes)
      throw RecordingFault(kUniversalValues,
                           {"at most " + std::to_string(function.data_bytes / 2), std::to_string(function.samples)},
                           function.line);
    index_.functions.push_back(std::move(function));
  }

  void ReadBinary(const std::vector<std::string_view>& words) {
    const auto word = [&](std::size_t i) { return i < words.size() ? words[i] : std::string_view(); };
    const int floats = Code(word(2), 1, "the format of numbers");
    const bool is_big_endian = Code(word(1), 1, "the order of bytes") == 2;
    const std::uint64_t stated = Count(word(4), 1, "the number of bytes");
    const int line = lines_.line();
    UniversalFunction function = ReadHead();
    if (floats != 2) throw RecordingFault(kUniversalFloats, {floats == 1 ? "DEC VMS" : "IBM 370"}, line);
    function.is_binary = true;
    function.is_big_endian = is_big_endian;
    const std::uint64_t size = function.is_double ? 8 : 4;
    // Times may be of single precision.
    const std::uint64_t needed = function.samples * ((function.is_complex ? 2 : 1) * size + (function.is_even ? 0 : 4));
    function.data_bytes = stated == 0 ? needed : stated;
    if (function.data_bytes < needed)
      throw RecordingFault(
          kUniversalBytes,
          {std::to_string(function.data_bytes), std::to_string(function.data_at), std::to_string(needed)}, line);
    bytes_.Require(function.data_at, function.data_bytes, "the data set 58b");
    lines_ = FileLines(bytes_, function.data_at + function.data_bytes, function.data_line);
    index_.functions.push_back(std::move(function));
  }

  const FileBytes& bytes_;
  FileLines lines_;
  UniversalIndex index_;
  std::optional<Units> units_;
  bool ended_ = false;
};

}  // namespace

UniversalIndex ReadUniversalIndex(const FileBytes& bytes) { return IndexReader(bytes).Read(); }

bool IsUniversal(std::string_view head) {
  const auto take_line = [&] {
    const std::size_t end = std::min(head.find('\n'), head.size());
    std::string_view line = head.substr(0, end);
    head.remove_prefix(std::min(end + 1, head.size()));
    while (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  };
  std::string_view line = take_line();
  while (Trimmed(line).empty() && !head.empty()) line = take_line();
  if (!IsDelimiter(line)) return false;
  const std::vector<std::string_view> words = Words(take_line());
  return !words.empty() && words[0].find_first_not_of("0123456789bB") == std::string_view::npos;
}

}  // namespace fourpost
