#include "analysis/mat_file.h"

#include <matio.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include "analysis/near_file.h"

namespace fourpost {
namespace {

struct Close {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};

std::size_t Length(const matvar_t& variable) {
  std::size_t length = variable.rank > 0 ? 1 : 0;
  for (int i = 0; i < variable.rank; ++i) length *= variable.dims[i];
  return length;
}

/// All but one side of it are 1.
bool IsVector(const matvar_t& variable) {
  const std::size_t length = Length(variable);
  return length > 1 &&
         std::any_of(variable.dims, variable.dims + variable.rank, [&](std::size_t side) { return side == length; });
}

template <typename Number>
std::vector<double> Doubles(const matvar_t& variable) {
  const auto* numbers = static_cast<const Number*>(variable.data);
  return {numbers, numbers + Length(variable)};
}

/// Empty for what is no vector of real numbers.
std::vector<double> NumbersOf(const matvar_t& variable) {
  if (variable.data == nullptr || variable.isComplex != 0 || !IsVector(variable)) return {};
  switch (variable.class_type) {
    case MAT_C_DOUBLE: return Doubles<double>(variable);
    case MAT_C_SINGLE: return Doubles<float>(variable);
    case MAT_C_INT8: return Doubles<std::int8_t>(variable);
    case MAT_C_UINT8: return Doubles<std::uint8_t>(variable);
    case MAT_C_INT16: return Doubles<std::int16_t>(variable);
    case MAT_C_UINT16: return Doubles<std::uint16_t>(variable);
    case MAT_C_INT32: return Doubles<std::int32_t>(variable);
    case MAT_C_UINT32: return Doubles<std::uint32_t>(variable);
    case MAT_C_INT64: return Doubles<std::int64_t>(variable);
    case MAT_C_UINT64: return Doubles<std::uint64_t>(variable);
    default: return {};
  }
}

/// Empty for what is no text.
std::string TextOf(const matvar_t& variable) {
  if (variable.data == nullptr || variable.class_type != MAT_C_CHAR) return {};
  if (variable.data_size == 1) return {static_cast<const char*>(variable.data), Length(variable)};
  std::string text;
  const auto* codes = static_cast<const std::uint16_t*>(variable.data);
  if (variable.data_size == 2)
    // Units need no more than Latin-1.
    std::transform(codes, codes + Length(variable), std::back_inserter(text),
                   [](std::uint16_t code) { return static_cast<char>(code < 256 ? code : '?'); });
  return text;
}

/// A row of characters each, as columns of one after the other hold them.
std::vector<std::string> RowsOf(const std::string& characters, std::size_t rows) {
  std::vector<std::string> texts(rows);
  for (std::size_t i = 0; i < characters.size(); ++i) texts[i % rows] += characters[i];
  for (std::string& text : texts) text.erase(text.find_last_not_of(' ') + 1);
  return texts;
}

/// Of a cell array of nothing but texts, and of several rows of characters; else empty.
std::vector<std::string> TextsOf(matvar_t& variable) {
  if (variable.data == nullptr || variable.rank != 2) return {};
  if (variable.class_type == MAT_C_CHAR && variable.dims[0] > 1) return RowsOf(TextOf(variable), variable.dims[0]);
  if (variable.class_type != MAT_C_CELL || !IsVector(variable)) return {};
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < Length(variable); ++i) {
    const matvar_t* cell = Mat_VarGetCell(&variable, static_cast<int>(i));
    if (cell == nullptr || cell->class_type != MAT_C_CHAR) return {};
    texts.push_back(TextOf(*cell));
  }
  return texts;
}

/// Bytes of the variable of version 4 that begins with this head, without it; nothing when it begins none.
std::optional<std::uintmax_t> LengthOfVersion4(const std::array<unsigned char, 20>& head) {
  const auto number = [&](std::size_t field, bool swapped) {
    std::uintmax_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = 256 * value + head[4 * field + (swapped ? i : 3 - i)];
    return value;
  };
  // A type of four digits: the order of bytes, 0, the kind of numbers, the kind of matrix.
  const bool swapped = number(0, false) >= 1000;
  const std::uintmax_t type = number(0, swapped) % 1000;
  constexpr std::array<std::uintmax_t, 6> kBytes = {8, 4, 4, 2, 2, 1};
  if (number(0, swapped) >= 2000 || type / 10 >= kBytes.size() || type % 10 > 2) return std::nullopt;
  const std::uintmax_t parts = number(3, swapped) == 0 ? 1 : 2;
  return number(4, swapped) + number(1, swapped) * number(2, swapped) * kBytes[type / 10] * parts;
}

/// Of a file of version 4, which has no head: its variables are longer than what is there.
bool IsVersion4CutShort(std::ifstream& stream, std::uintmax_t size) {
  std::uintmax_t at = 0;
  std::array<unsigned char, 20> head{};
  while (at < size) {
    if (!stream.seekg(static_cast<std::streamoff>(at)) ||
        !stream.read(reinterpret_cast<char*>(head.data()), head.size()))
      return at > 0;
    const std::optional<std::uintmax_t> length = LengthOfVersion4(head);
    if (!length) return false;
    if (*length > size) return true;
    at += head.size() + *length;
  }
  return at > size;
}

/// Of a file of versions 4 and 5, which matio fills up with zeros: variables are longer than what is there.
bool IsCutShort(const std::filesystem::path& file) {
  constexpr std::uintmax_t kHeader = 128;
  const std::uintmax_t size = std::filesystem::file_size(file);
  std::ifstream stream(file, std::ios::binary);
  std::array<char, kHeader> header{};
  if (!stream.read(header.data(), kHeader) || !std::string_view(header.data(), 10).starts_with("MATLAB 5.0")) {
    stream.clear();
    return IsVersion4CutShort(stream, size);
  }
  const bool swapped = header[126] == 'M';
  std::uintmax_t at = kHeader;
  std::array<unsigned char, 8> tag{};
  while (at < size && stream.seekg(static_cast<std::streamoff>(at)) &&
         stream.read(reinterpret_cast<char*>(tag.data()), sizeof tag)) {
    std::uintmax_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = 256 * length + tag[swapped ? 4 + i : 7 - i];
    at += sizeof tag + length;
  }
  return at != size;
}

bool IsOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class MatReader {
 public:
  MatReader(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  std::optional<std::vector<MatVector>> Read() {
    if (IsCutShort(file_)) return Fault("is cut short; save or copy it again");
    const std::unique_ptr<mat_t, Close> mat(Mat_Open(file_.c_str(), MAT_ACC_RDONLY));
    if (!mat) return Fault("is no MAT file that can be read; save it anew, with -v7 for instance");
    while (const std::unique_ptr<matvar_t, Close> variable{Mat_VarReadNext(mat.get())}) {
      if (variable->name == nullptr) return Fault("is damaged: it holds a variable without a name");
      if (variable->data == nullptr && Length(*variable) > 0)
        return Fault("is cut short: variable '" + std::string(variable->name) + "' has no data");
      Take(*variable, variable->name);
    }
    if (std::all_of(vectors_.begin(), vectors_.end(), [](const MatVector& vector) { return vector.values.empty(); }))
      return Fault("holds no vector of real numbers; save each channel as a variable of its own");
    for (MatVector& vector : vectors_)
      if (vector.unit.empty()) vector.unit = units_[vector.name];
    if (!good_) return std::nullopt;
    return std::move(vectors_);
  }

 private:
  std::nullopt_t Fault(const std::string& message) {
    diagnostics_.Error(file_, 0, message);
    good_ = false;
    return std::nullopt;
  }

  void Take(matvar_t& variable, const std::string& name) {
    if (variable.class_type == MAT_C_STRUCT) return TakeFields(variable, name);
    constexpr std::string_view kEnding = "_unit";
    if (std::string unit = TextOf(variable); !unit.empty() && name.ends_with(kEnding))
      units_[name.substr(0, name.size() - kEnding.size())] = std::move(unit);
    else Add({name, "", NumbersOf(variable), TextsOf(variable)});
  }

  void TakeFields(matvar_t& structure, const std::string& name) {
    // An array of structures is no set of channels.
    if (Length(structure) != 1) return;
    const unsigned count = Mat_VarGetNumberOfFields(&structure);
    char* const* names = Mat_VarGetStructFieldnames(&structure);
    const std::size_t first = vectors_.size();
    std::string unit;
    for (unsigned i = 0; i < count; ++i) {
      matvar_t* field = Mat_VarGetStructFieldByIndex(&structure, i, 0);
      if (field == nullptr) continue;
      const std::string field_name = names[i];
      if (IsOneOf(name, {"unit", "units"})) units_[field_name] = TextOf(*field);
      else if (IsOneOf(field_name, {"unit", "units"}) && TextsOf(*field).empty()) unit = TextOf(*field);
      else Take(*field, IsOneOf(field_name, {"data", "values", "signal"}) ? name : field_name);
    }
    const auto is_numbers = [](const MatVector& vector) { return !vector.values.empty(); };
    const auto begin = vectors_.begin() + static_cast<std::ptrdiff_t>(first);
    if (!unit.empty() && std::count_if(begin, vectors_.end(), is_numbers) == 1)
      std::find_if(begin, vectors_.end(), is_numbers)->unit = std::move(unit);
  }

  std::vector<MatVector>::iterator Find(const std::string& name) {
    return std::find_if(vectors_.begin(), vectors_.end(), [&](const MatVector& other) { return other.name == name; });
  }

  void Add(MatVector vector) {
    if (vector.values.empty() && vector.texts.empty()) return;
    const auto other = Find(vector.name);
    if (other == vectors_.end()) return vectors_.push_back(std::move(vector));
    // Texts may be notes, of which each channel has its own.
    if (vector.values.empty()) return;
    if (!other->values.empty()) Fault("holds two vectors called '" + vector.name + "'; rename one");
    *other = std::move(vector);
  }

  std::string file_;
  Diagnostics& diagnostics_;
  std::vector<MatVector> vectors_;
  std::map<std::string, std::string> units_;
  bool good_ = true;
};

}  // namespace

std::optional<std::vector<MatVector>> ReadMatFile(const std::filesystem::path& file, Diagnostics& diagnostics) {
  if (std::filesystem::is_directory(file) || !std::ifstream(file)) {
    diagnostics.Error(file.string(), 0,
                      "cannot be read: there is no such file, or it may not be read" + DidYouMeanFile(file));
    return std::nullopt;
  }
  return MatReader(file.string(), diagnostics).Read();
}

}  // namespace fourpost
