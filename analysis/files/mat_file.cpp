#include "analysis/files/mat_file.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "analysis/files/findings.h"
#include "analysis/files/mat/mat_variable.h"
#include "analysis/files/mat/mat_version4.h"
#include "analysis/files/mat/mat_version5.h"
#include "analysis/files/mat/mat_version73.h"
#include "analysis/files/recording_format.h"
#include "analysis/files/text_file.h"

namespace fourpost {
namespace {

using Kind = MatVariable::Kind;

/// All sides except one are 1.
bool IsVector(const MatVariable& variable) {
  const std::uint64_t length = variable.Length();
  return length > 1 && std::find(variable.dims.begin(), variable.dims.end(), length) != variable.dims.end();
}

/// Empty for what is no vector of real numbers.
std::vector<double> NumbersOf(MatVariable& variable) {
  return variable.kind == Kind::kNumbers && IsVector(variable) ? std::move(variable.numbers) : std::vector<double>();
}

/// Empty for what is no line of text.
std::string TextOf(const MatVariable& variable) {
  return variable.kind == Kind::kText && variable.rows.size() == 1 ? variable.rows.front() : "";
}

/// Of a cell array of nothing but texts, and of several rows of characters without the blanks behind them; else empty.
std::vector<std::string> TextsOf(const MatVariable& variable) {
  if (variable.dims.size() != 2) return {};
  std::vector<std::string> texts;
  if (variable.kind == Kind::kText && variable.rows.size() > 1)
    for (const std::string& row : variable.rows) texts.push_back(row.substr(0, row.find_last_not_of(' ') + 1));
  if (variable.kind != Kind::kCells || !IsVector(variable)) return texts;
  for (const MatVariable& cell : variable.parts) {
    if (cell.kind != Kind::kText) return {};
    texts.push_back(TextOf(cell));
  }
  return texts;
}

bool IsOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class MatReader {
 public:
  MatReader(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  /// `variables`: of the file.
  std::optional<std::vector<MatVector>> Read(std::vector<MatVariable> variables) {
    for (MatVariable& variable : variables) Take(variable, variable.name);
    if (std::all_of(vectors_.begin(), vectors_.end(), [](const MatVector& vector) { return vector.values.empty(); }))
      return Fault(kMatNoVector);
    for (MatVector& vector : vectors_)
      if (vector.unit.empty()) vector.unit = units_[vector.name];
    if (!good_) return std::nullopt;
    return std::move(vectors_);
  }

 private:
  std::nullopt_t Fault(const Finding& kind, const std::vector<std::string>& words = {}) {
    diagnostics_.Report(kind, {file_}, words);
    good_ = false;
    return std::nullopt;
  }

  void Take(MatVariable& variable, const std::string& name) {
    if (variable.kind == Kind::kStructure) return TakeFields(variable, name);
    constexpr std::string_view kEnding = "_unit";
    if (std::string unit = TextOf(variable); !unit.empty() && name.ends_with(kEnding))
      units_[name.substr(0, name.size() - kEnding.size())] = std::move(unit);
    else Add({name, "", NumbersOf(variable), TextsOf(variable)});
  }

  void TakeFields(MatVariable& structure, const std::string& name) {
    const std::size_t first = vectors_.size();
    std::string unit;
    for (MatVariable& field : structure.parts) {
      if (IsOneOf(name, {"unit", "units"})) units_[field.name] = TextOf(field);
      else if (IsOneOf(field.name, {"unit", "units"}) && TextsOf(field).empty()) unit = TextOf(field);
      else Take(field, IsOneOf(field.name, {"data", "values", "signal"}) ? name : field.name);
    }
    const auto is_numbers = [](const MatVector& vector) { return !vector.values.empty(); };
    const auto begin = vectors_.begin() + static_cast<std::ptrdiff_t>(first);
    if (!unit.empty() && std::count_if(begin, vectors_.end(), is_numbers) == 1)
      std::find_if(begin, vectors_.end(), is_numbers)->unit = std::move(unit);
  }

  void Add(MatVector vector) {
    if (vector.values.empty() && vector.texts.empty()) return;
    const auto [place, is_new] = place_of_.emplace(vector.name, vectors_.size());
    if (is_new) return vectors_.push_back(std::move(vector));
    // Texts may be notes, of which each channel has its own.
    if (vector.values.empty()) return;
    MatVector& other = vectors_[place->second];
    if (!other.values.empty()) Fault(kMatVectorTwice, {vector.name});
    other = std::move(vector);
  }

  std::string file_;
  Diagnostics& diagnostics_;
  std::vector<MatVector> vectors_;
  std::map<std::string, std::size_t> place_of_;
  std::map<std::string, std::string> units_;
  bool good_ = true;
};

/// By `read`, whose faults are the file's.
template <typename ReadVariables>
std::optional<std::vector<MatVector>> VectorsOf(const std::string& file, Diagnostics& diagnostics,
                                                const ReadVariables& read) {
  try {
    return MatReader(file, diagnostics).Read(read());
  } catch (const MatFault& fault) {
    diagnostics.Report(*fault.found().kind, {file}, fault.found().words);
    return std::nullopt;
  }
}

}  // namespace

std::optional<std::vector<MatVector>> ParseMat(std::string_view bytes, const std::string& file,
                                               Diagnostics& diagnostics) {
  return VectorsOf(file, diagnostics,
                   [&] { return IsMatVersion5(bytes) ? ReadMatVersion5(bytes) : ReadMatVersion4(bytes); });
}

std::optional<std::vector<MatVector>> ReadMatFile(const std::filesystem::path& file, Diagnostics& diagnostics) {
  // HDF5 reads what it needs of a file that may be larger than memory.
  if (IsMatVersion73(FileHead(file)))
    return VectorsOf(file.string(), diagnostics, [&] { return ReadMatVersion73(file); });
  const std::optional<std::string> bytes = ReadTextFile(file, diagnostics);
  if (!bytes) return std::nullopt;
  return ParseMat(*bytes, file.string(), diagnostics);
}

}  // namespace fourpost
