#include "analysis/files/hdf5/hdf5_dataset.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include <nlohmann/json.hpp>

#include "analysis/files/hdf5/findings.h"
#include "analysis/files/recording/inflated.h"
#include "analysis/files/recording/recording_fault.h"
#include "analysis/process/child_process.h"
#include "analysis/text/utf8.h"

namespace fourpost {
namespace {

using Json = nlohmann::json;

constexpr int kDeepestGroup = 20;
constexpr std::size_t kMostObjects = 100'000;
/// A matrix of more channels is a picture or a map.
constexpr std::uint64_t kMostColumns = 4096;
constexpr std::size_t kLongestText = 4096;

class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close) {
    if (id_ < 0) throw RecordingFault(kHdf5Object, {what});
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Texts of fixed length or not; none for other attributes.
std::vector<std::string> TextsOf(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return {};
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, name);
  const Handle type(H5Aget_type(attribute), H5Tclose, name);
  const Handle space(H5Aget_space(attribute), H5Sclose, name);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  if (H5Tget_class(type) != H5T_STRING || count < 1 || count > static_cast<hssize_t>(kMostColumns)) return {};
  std::vector<std::string> texts;
  if (H5Tis_variable_str(type) > 0) {
    std::vector<char*> pointers(count, nullptr);
    const Handle memory(H5Tcopy(type), H5Tclose, name);
    if (H5Aread(attribute, memory, pointers.data()) < 0) return {};
    for (const char* text : pointers) texts.emplace_back(text == nullptr ? "" : text);
    H5Dvlen_reclaim(memory, space, H5P_DEFAULT, pointers.data());
    return texts;
  }
  const std::size_t size = H5Tget_size(type);
  if (size == 0 || size > kLongestText) return {};
  std::string all(size * static_cast<std::size_t>(count), '\0');
  if (H5Aread(attribute, type, all.data()) < 0) return {};
  for (std::size_t at = 0; at < all.size(); at += size) {
    const std::string text = all.substr(at, size);
    texts.push_back(text.substr(0, text.find('\0')));
  }
  return texts;
}

std::vector<std::string> TextsOf(hid_t object, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (std::vector<std::string> texts = TextsOf(object, name); !texts.empty()) return texts;
  return {};
}

/// 0 without one.
double NumberOf(hid_t object, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (H5Aexists(object, name) <= 0) continue;
    const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, name);
    const Handle type(H5Aget_type(attribute), H5Tclose, name);
    const Handle space(H5Aget_space(attribute), H5Sclose, name);
    const H5T_class_t kind = H5Tget_class(type);
    double number = 0;
    const bool is_number = (kind == H5T_INTEGER || kind == H5T_FLOAT) && H5Sget_simple_extent_npoints(space) == 1;
    if (is_number && H5Aread(attribute, H5T_NATIVE_DOUBLE, &number) >= 0) return number;
  }
  return 0;
}

std::vector<std::uint64_t> SidesOf(hid_t dataset, const std::string& path) {
  const Handle space(H5Dget_space(dataset), H5Sclose, path);
  std::array<hsize_t, H5S_MAX_RANK> sides{};
  const int rank = H5Sget_simple_extent_dims(space, sides.data(), nullptr);
  if (rank < 0) throw RecordingFault(kHdf5Object, {path});
  return {sides.begin(), sides.begin() + rank};
}

/// Throws unless the file stores about as much as the numbers take: no more than packing explains.
void RequireStored(hid_t dataset, std::uint64_t numbers, const std::string& path) {
  const Handle type(H5Dget_type(dataset), H5Tclose, path);
  const Handle layout(H5Dget_create_plist(dataset), H5Pclose, path);
  const std::uint64_t stored = H5Dget_storage_size(dataset);
  const std::uint64_t size = std::max<std::uint64_t>(H5Tget_size(type), 1);
  const H5D_layout_t kind = H5Pget_layout(layout);
  std::uint64_t length = numbers;
  if (kind == H5D_CHUNKED) {
    std::array<hsize_t, H5S_MAX_RANK> sides{};
    const int rank = H5Pget_chunk(layout, H5S_MAX_RANK, sides.data());
    double chunk = rank < 0 ? 0 : 1;
    for (int i = 0; i < rank; ++i) chunk *= static_cast<double>(sides[static_cast<std::size_t>(i)]);
    // A chunk is unpacked as a whole.
    length = chunk < 1e15 ? std::max(length, static_cast<std::uint64_t>(chunk)) : ~std::uint64_t{0};
  }
  const std::uint64_t most = kind == H5D_CHUNKED ? kClosestDeflated * stored : stored;
  if (kind == H5D_VIRTUAL || H5Pget_external_count(layout) != 0 || length > most / size)
    throw RecordingFault(kHdf5Storage, {path, std::to_string(numbers), std::to_string(stored)});
}

class Lister {
 public:
  explicit Lister(const std::filesystem::path& file)
      : file_(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file") {}

  Hdf5Contents List() {
    const Handle root(H5Gopen2(file_, "/", H5P_DEFAULT), H5Gclose, "/");
    for (const char* name : {"title", "description", "comment"})
      for (const std::string& text : TextsOf(root, name))
        contents_.description += (contents_.description.empty() ? "" : "\n") + text;
    ListGroup(root, "/", 0);
    return std::move(contents_);
  }

 private:
  void ListGroup(hid_t group, const std::string& path, int depth) {
    H5G_info_t info;
    if (H5Gget_info(group, &info) < 0) throw RecordingFault(kHdf5Object, {path});
    for (hsize_t i = 0; i < info.nlinks; ++i) {
      if (++objects_ > kMostObjects || depth > kDeepestGroup)
        throw RecordingFault(kHdf5Objects, {std::to_string(kMostObjects), std::to_string(kDeepestGroup)});
      std::array<char, 1024> name{};
      if (H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_NATIVE, i, name.data(), name.size(), H5P_DEFAULT) < 0)
        throw RecordingFault(kHdf5Object, {path});
      H5L_info_t link;
      const bool is_here = H5Lget_info(group, name.data(), &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD;
      if (!is_here || name[0] == '#') continue;
      const std::string member = path + name.data();
      const Handle object(H5Oopen(group, name.data(), H5P_DEFAULT), H5Oclose, member);
      if (H5Aexists(object, "MATLAB_class") > 0) contents_.is_of_matlab = true;
      const H5I_type_t type = H5Iget_type(object);
      if (type == H5I_GROUP) ListGroup(object, member + "/", depth + 1);
      else if (type == H5I_DATASET) ListDataset(object, member);
    }
  }

  void ListDataset(hid_t object, const std::string& path) {
    const Handle type(H5Dget_type(object), H5Tclose, path);
    const H5T_class_t kind = H5Tget_class(type);
    const std::vector<std::uint64_t> sides = SidesOf(object, path);
    const bool is_number = kind == H5T_INTEGER || kind == H5T_FLOAT;
    if (!is_number || sides.empty() || sides.size() > 2) return contents_.left_out.push_back(path);
    Hdf5Dataset dataset = {.path = path, .rows = sides[0]};
    if (sides.size() == 2) {
      dataset.is_transposed = sides[0] < sides[1];
      dataset.rows = std::max(sides[0], sides[1]);
      dataset.columns = std::min(sides[0], sides[1]);
    }
    // A single number is a setting.
    if (dataset.rows < 2 || dataset.columns == 0) return;
    if (dataset.columns > kMostColumns) return contents_.left_out.push_back(path);
    dataset.names = TextsOf(object, {"names", "channels", "columns", "channel_names", "name"});
    dataset.units = TextsOf(object, {"unit", "units", "Unit", "Units", "unit_string"});
    dataset.step_s = NumberOf(object, {"dt", "wf_increment", "delta_t", "sample_interval"});
    const double rate_Hz = NumberOf(object, {"sample_rate", "sampling_rate", "rate", "fs", "samplerate"});
    if (!(dataset.step_s > 0)) dataset.step_s = rate_Hz > 0 ? 1 / rate_Hz : 0;
    dataset.start_s = NumberOf(object, {"t0", "wf_start_offset", "start"});
    contents_.datasets.push_back(std::move(dataset));
  }

  Handle file_;
  Hdf5Contents contents_;
  std::size_t objects_ = 0;
};

Json AsJson(const Hdf5Contents& contents) {
  const auto valid = [](std::vector<std::string> texts) {
    for (std::string& text : texts) text = ValidUtf8(text);
    return texts;
  };
  Json list = Json::array();
  for (const Hdf5Dataset& set : contents.datasets)
    list.push_back({set.path, set.rows, set.columns, set.is_transposed, valid(set.names), valid(set.units), set.step_s,
                    set.start_s});
  return {{"description", ValidUtf8(contents.description)},
          {"matlab", contents.is_of_matlab},
          {"datasets", list},
          {"left_out", valid(contents.left_out)}};
}

Hdf5Contents FromJson(const Json& json) {
  Hdf5Contents contents = {.description = json.at("description"), .is_of_matlab = json.at("matlab")};
  for (const Json& set : json.at("datasets"))
    contents.datasets.push_back({set.at(0), set.at(1), set.at(2), set.at(3), set.at(4), set.at(5),
                                 set.at(6).is_null() ? 0.0 : set.at(6).get<double>(),
                                 set.at(7).is_null() ? 0.0 : set.at(7).get<double>()});
  contents.left_out = json.at("left_out").get<std::vector<std::string>>();
  return contents;
}

// What an answer begins with.
constexpr char kGood = 'g';
constexpr char kFault = 'f';

/// What `work` gives, from a process of its own.
template <typename Work>
std::string Answer(const Work& work) {
  const std::optional<std::string> answer = AnswerOfChild([&]() -> std::string {
    // Else it prints what it did not like.
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    try {
      return kGood + work();
    } catch (const RecordingFault& fault) {
      std::vector<std::string> words = fault.found().words;
      for (std::string& word : words) word = ValidUtf8(word);
      return kFault + Json{std::string(fault.found().kind->id()), words}.dump();
    } catch (const std::exception&) {
      return "";
    }
  });
  if (!answer || answer->empty()) throw RecordingFault(kHdf5Failed);
  const std::string content = answer->substr(1);
  if (answer->front() == kGood) return content;
  const Json fault = Json::parse(content);
  throw RecordingFault(*AllFindings().at(fault.at(0).get<std::string>()), fault.at(1).get<std::vector<std::string>>());
}

std::string Column(const std::filesystem::path& file, const Hdf5Dataset& wanted, std::uint64_t column) {
  const Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file");
  const Handle dataset(H5Dopen2(opened, wanted.path.c_str(), H5P_DEFAULT), H5Dclose, wanted.path);
  RequireStored(dataset, wanted.rows * wanted.columns, wanted.path);
  const Handle space(H5Dget_space(dataset), H5Sclose, wanted.path);
  if (H5Sget_simple_extent_ndims(space) == 2) {
    const std::array<hsize_t, 2> first = {wanted.is_transposed ? column : 0, wanted.is_transposed ? 0 : column};
    const std::array<hsize_t, 2> count = {wanted.is_transposed ? 1 : wanted.rows,
                                          wanted.is_transposed ? wanted.rows : 1};
    H5Sselect_hyperslab(space, H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr);
  }
  const hsize_t rows = wanted.rows;
  const Handle memory(H5Screate_simple(1, &rows, nullptr), H5Sclose, wanted.path);
  std::string bytes(rows * sizeof(double), '\0');
  if (H5Dread(dataset, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, bytes.data()) < 0)
    throw RecordingFault(kHdf5Object, {wanted.path});
  return bytes;
}

}  // namespace

Hdf5Contents ListHdf5(const std::filesystem::path& file) {
  return FromJson(Json::parse(Answer([&] { return AsJson(Lister(file).List()).dump(); })));
}

std::vector<double> ReadHdf5(const std::filesystem::path& file, const Hdf5Dataset& dataset, std::uint64_t column) {
  const std::string bytes = Answer([&] { return Column(file, dataset, column); });
  std::vector<double> values(bytes.size() / sizeof(double));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
  return values;
}

}  // namespace fourpost
