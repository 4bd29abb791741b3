#include "analysis/files/mat/mat_version73.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <utility>

#include "analysis/files/mat/findings.h"
#include "analysis/files/mat/packed_variables.h"
#include "analysis/process/child_process.h"

namespace fourpost {
namespace {

using Kind = MatVariable::Kind;

/// Cells and fields of a damaged file may refer to each other without end.
constexpr std::size_t kMostObjects = 100'000;
/// Deflate packs zeros no closer (zlib.net, "Maximum Compression Factor").
constexpr std::uint64_t kClosestPacked = 1032;

/// Of any kind of object, closed when it goes.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id_ < 0) throw MatFault(kMatObject);
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Such as "double", "char", "cell", "struct"; empty where the object has none.
std::string ClassOf(hid_t object) {
  if (H5Aexists(object, "MATLAB_class") <= 0) return "";
  const Handle attribute(H5Aopen(object, "MATLAB_class", H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(attribute), H5Tclose);
  std::array<char, 64> text{};
  const bool is_short =
      H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 && H5Tget_size(type) < text.size();
  const Handle space(H5Aget_space(attribute), H5Sclose);
  if (!is_short || H5Sget_simple_extent_npoints(space) != 1 || H5Aread(attribute, type, text.data()) < 0) return "";
  return text.data();
}

std::vector<std::uint64_t> DimsOf(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose);
  std::array<hsize_t, H5S_MAX_RANK> sides{};
  const int rank = H5Sget_simple_extent_dims(space, sides.data(), nullptr);
  if (rank < 0) throw MatFault(kMatNoDimensions);
  // Stored row after row, so the sides stand the other way round.
  std::vector<std::uint64_t> dims(sides.rend() - rank, sides.rend());
  while (dims.size() < 2) dims.push_back(1);
  return dims;
}

/// Bytes of what the file packs as one; 0 where it packs nothing.
std::uint64_t ChunkLength(hid_t layout, std::uint64_t size) {
  if (H5Pget_layout(layout) != H5D_CHUNKED) return 0;
  std::array<hsize_t, H5S_MAX_RANK> sides{};
  const int rank = H5Pget_chunk(layout, H5S_MAX_RANK, sides.data());
  if (rank < 0) throw MatFault(kMatLayout);
  MatVariable chunk;
  chunk.dims.assign(sides.begin(), sides.begin() + rank);
  chunk.dims.push_back(size);
  return chunk.Length();
}

/// Throws unless the file stores about as much of the dataset as its dimensions say: no more than packing explains.
void RequireStored(const MatVariable& variable, hid_t dataset) {
  const Handle type(H5Dget_type(dataset), H5Tclose);
  const Handle layout(H5Dget_create_plist(dataset), H5Pclose);
  const std::uint64_t stored = H5Dget_storage_size(dataset);
  const std::uint64_t size = std::max<std::uint64_t>(H5Tget_size(type), 1);
  const H5D_layout_t kind = H5Pget_layout(layout);
  if (kind == H5D_VIRTUAL || kind < 0 || H5Pget_external_count(layout) != 0)
    throw MatFault(kMatElsewhere, {variable.name});
  const std::uint64_t most = kind == H5D_CHUNKED ? kClosestPacked * stored : stored;
  const std::uint64_t length = std::max(variable.Length(), ChunkLength(layout, size) / size);
  if (length > most / size)
    throw MatFault(kMatStorage, {variable.name, std::to_string(variable.Length()), std::to_string(stored)});
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file)
      : file_(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose) {}

  std::vector<MatVariable> Read() {
    const Handle root(H5Gopen2(file_, "/", H5P_DEFAULT), H5Gclose);
    return Members(root, 0);
  }

 private:
  /// Of a group, by name; not what MATLAB keeps for itself.
  std::vector<MatVariable> Members(hid_t group, int depth) {
    H5G_info_t info;
    if (H5Gget_info(group, &info) < 0) throw MatFault(kMatGroup);
    std::vector<MatVariable> members;
    for (hsize_t i = 0; i < info.nlinks; ++i) {
      const std::string name = NameOf(group, i);
      H5L_info_t link;
      const bool is_here = H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD;
      if (name.empty() || name.starts_with('#') || !is_here) continue;
      const Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
      members.push_back(ReadObject(object, name, depth));
    }
    return members;
  }

  static std::string NameOf(hid_t group, hsize_t i) {
    std::array<char, 1024> name{};
    const ssize_t length =
        H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_NATIVE, i, name.data(), name.size(), H5P_DEFAULT);
    if (length < 0) throw MatFault(kMatName);
    return name.data();
  }

  MatVariable ReadObject(hid_t object, const std::string& name, int depth) {
    if (++objects_ > kMostObjects || depth > kDeepestMat)
      throw MatFault(kMatObjects, {std::to_string(kMostObjects), std::to_string(kDeepestMat)});
    MatVariable variable{.name = name, .dims = {1, 1}};
    const H5I_type_t type = H5Iget_type(object);
    if (type == H5I_GROUP) {
      variable.kind = Kind::kStructure;
      variable.parts = Members(object, depth + 1);
    } else if (type == H5I_DATASET) {
      ReadDataset(object, depth, variable);
    }
    return variable;
  }

  void ReadDataset(hid_t dataset, int depth, MatVariable& variable) {
    // What is empty stores its dimensions in place of numbers.
    if (H5Aexists(dataset, "MATLAB_empty") > 0) return;
    variable.dims = DimsOf(dataset);
    if (variable.Length() == 0) return;
    RequireStored(variable, dataset);
    const std::string kind = ClassOf(dataset);
    const Handle type(H5Dget_type(dataset), H5Tclose);
    const H5T_class_t stored = H5Tget_class(type);
    if (kind == "cell" && stored == H5T_REFERENCE) ReadCells(dataset, type, depth, variable);
    // Complex numbers are compounds, and an array of structures holds references.
    else if (stored == H5T_INTEGER || stored == H5T_FLOAT) ReadNumbers(dataset, kind == "char", variable);
  }

  static void ReadNumbers(hid_t dataset, bool is_text, MatVariable& variable) {
    if (is_text && variable.Length() > kLongestMatText) return;
    std::vector<double> numbers(variable.Length());
    if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0)
      throw MatFault(kMatContent, {variable.name});
    if (!is_text) {
      variable.kind = Kind::kNumbers;
      variable.numbers = std::move(numbers);
      return;
    }
    variable.kind = Kind::kText;
    std::vector<std::string> characters;
    for (const double code : numbers)
      characters.push_back(code >= 0 && code < 0x110000 ? Utf8(static_cast<std::uint32_t>(code)) : "?");
    variable.rows = RowsOf(characters, variable.dims[0]);
  }

  void ReadCells(hid_t dataset, hid_t type, int depth, MatVariable& variable) {
    if (H5Tequal(type, H5T_STD_REF_OBJ) <= 0) return;
    variable.kind = Kind::kCells;
    if (variable.Length() > kMostObjects) throw MatFault(kMatCells, {variable.name});
    std::vector<hobj_ref_t> references(variable.Length());
    if (H5Dread(dataset, H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data()) < 0)
      throw MatFault(kMatContent, {variable.name});
    for (const hobj_ref_t& reference : references) {
      const Handle cell(H5Rdereference2(dataset, H5P_DEFAULT, H5R_OBJECT, &reference), H5Oclose);
      variable.parts.push_back(ReadObject(cell, "", depth + 1));
    }
  }

  Handle file_;
  std::size_t objects_ = 0;
};

// What an answer begins with.
constexpr char kVariables = 'v';
constexpr char kFault = 'f';

/// The variables, packed, or what is wrong with the file.
std::string AnswerOf(const std::filesystem::path& file) {
  // Else it prints what it did not like.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  try {
    return kVariables + Packed(Reader(file).Read());
  } catch (const MatFault& fault) {
    return kFault + Packed(fault);
  } catch (const std::exception&) {
    return kFault + Packed(MatFault(kMatOutOfMemory));
  }
}

}  // namespace

bool IsMatVersion73(std::string_view bytes) {
  constexpr std::string_view kSignature = "\x89HDF\r\n\x1A\n";
  // Before it MATLAB writes a head of 512 bytes.
  return bytes.starts_with(kSignature) || (bytes.size() > 512 && bytes.substr(512).starts_with(kSignature));
}

std::vector<MatVariable> ReadMatVersion73(const std::filesystem::path& file) {
  // HDF5 trusts much of what a file says, and is not ours to mend: a crash in it is a fault of the file.
  const std::optional<std::string> answer = AnswerOfChild([&] { return AnswerOf(file); });
  if (!answer) throw MatFault(kMatCrashed);
  if (answer->front() == kFault) throw UnpackedFault(std::string_view(*answer).substr(1));
  return Unpacked(std::string_view(*answer).substr(1));
}

}  // namespace fourpost
