#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "analysis/text/diagnostics.h"

namespace fourpost {

/// A JSON file of Chrono, which may have comments.
struct ChronoFile {
  std::filesystem::path path;
  std::string text;
  nlohmann::json json;
};

/// A number, and the name under which it stands.
struct ChronoNumber {
  std::string_view name;
  double value = 0;
};

/// A value in such a file, with what is needed to report it: its path of names, and where it stands. Reading one that
/// is missing or of another kind reports that and gives zero; what lies below it then gives zero without a report.
class ChronoNode {
 public:
  /// Of a list; longer ones are reported. The largest of Chrono's cars are curves of some tens of points.
  static constexpr std::size_t kMostItems = 1000;

  /// The whole of a file; nothing, reported, where it is missing or no JSON.
  static std::optional<ChronoNode> Read(const std::filesystem::path& path, Diagnostics& diagnostics);

  bool Has(std::string_view name) const;
  bool IsNull() const { return value_ == nullptr; }

  ChronoNode Child(std::string_view name) const;
  std::vector<ChronoNode> Items(std::string_view name, std::size_t most = kMostItems) const;
  double Number(std::string_view name) const;
  /// Whether it is there and true.
  bool IsTrue(std::string_view name) const { return Has(name) && *value_->find(name) == true; }
  /// Nothing where it is missing.
  std::optional<double> MaybeNumber(std::string_view name) const;
  Eigen::Vector3d Vector(std::string_view name) const;
  /// An empty one is reported, too.
  std::string Text(std::string_view name) const;
  /// Rows of numbers, each of this many, or of any where 0.
  std::vector<std::vector<double>> Rows(std::string_view name, std::size_t width) const;
  std::vector<double> Numbers(std::string_view name) const;
  /// A file that a text names, found from the folders above this one; nothing after a fault.
  std::optional<ChronoNode> File(std::string_view name) const;

  /// The first number under one of these names in this file, at any depth and of any size.
  std::optional<ChronoNumber> Find(const std::vector<std::string_view>& names) const;
  /// The same, if a car can have it.
  std::optional<double> FindNumber(const std::vector<std::string_view>& names) const;

  /// "Spring" of "HMMWV_Front.json".
  std::string Called() const;
  std::string Called(std::string_view name) const;
  const std::filesystem::path& path() const { return file_->path; }
  void Report(const Finding& finding, const std::vector<std::string>& words = {}) const;
  void ReportAt(std::string_view name, const Finding& finding, const std::vector<std::string>& words = {}) const;

 private:
  ChronoNode(std::shared_ptr<const ChronoFile> file, const nlohmann::json* value, std::string name, std::size_t at,
             Diagnostics& diagnostics)
      : file_(std::move(file)), value_(value), name_(std::move(name)), at_(at), diagnostics_(&diagnostics) {}

  /// nullptr, reported, where it is missing.
  const nlohmann::json* Needed(std::string_view name, std::string_view what) const;
  /// The same, of a list that may have so many items.
  const nlohmann::json* NeededList(std::string_view name, std::string_view what, std::size_t most) const;
  std::optional<double> NumberIn(const nlohmann::json& value, std::string_view name) const;
  /// Where a name stands behind this value's.
  std::size_t PlaceOf(std::string_view name) const;
  int LineAt(std::size_t place) const;

  std::shared_ptr<const ChronoFile> file_;
  const nlohmann::json* value_ = nullptr;
  std::string name_;
  std::size_t at_ = 0;
  Diagnostics* diagnostics_ = nullptr;
};

}  // namespace fourpost
