#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "vehicles/description/scalar.h"

namespace fourpost {

/// Of a matrix that is its own transpose to the last bit, the upper triangle is stored.
inline bool IsBitwiseSymmetric(const Eigen::MatrixXd& matrix) {
  if (matrix.rows() != matrix.cols() || matrix.size() == 0) return false;
  const Eigen::MatrixXd transposed = matrix.transpose();
  return std::memcmp(matrix.data(), transposed.data(), static_cast<std::size_t>(matrix.size()) * sizeof(double)) == 0;
}

/// Writes records of which EachField() names the fields.
class ByteWriter {
 public:
  std::string Take() { return std::move(bytes_); }

  template <typename T>
  void operator()(const char*, const T& value) {
    Put(value);
  }
  template <typename Enum>
  void Choice(const char*, const Enum& value, const auto&) {
    Put(static_cast<int>(value));
  }
  void Put(std::string_view bytes) { bytes_ += bytes; }

 private:
  void PutInteger(std::uint64_t bits, int bytes) {
    for (int i = 0; i < bytes; ++i) bytes_ += static_cast<char>(bits >> (8 * i) & 0xff);
  }
  void Put(double number) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    PutInteger(bits, 8);
  }
  void Put(int number) { PutInteger(static_cast<std::uint32_t>(number), 4); }
  void Put(std::size_t number) { PutInteger(number, 4); }
  void Put(bool is_set) { PutInteger(is_set, 1); }
  void Put(const std::string& text) {
    Put(text.size());
    bytes_ += text;
  }
  void Put(const Scalar& scalar) {
    Put(scalar.parameter);
    Put(scalar.parameter < 0 ? scalar.value : scalar.factor);
  }
  void Put(const Eigen::Vector3d& vector) {
    for (const double number : vector) Put(number);
  }
  void Put(const Eigen::VectorXd& vector) {
    Put(static_cast<std::size_t>(vector.size()));
    for (const double number : vector) Put(number);
  }
  void Put(const Eigen::MatrixXd& matrix) {
    const bool is_symmetric = IsBitwiseSymmetric(matrix);
    Put(is_symmetric);
    Put(static_cast<std::size_t>(matrix.rows()));
    Put(static_cast<std::size_t>(matrix.cols()));
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      for (Eigen::Index i = 0; i < (is_symmetric ? j + 1 : matrix.rows()); ++i) Put(matrix(i, j));
  }
  template <typename T, std::size_t n>
  void Put(const std::array<T, n>& list) {
    for (const T& item : list) Put(item);
  }
  template <typename T>
  void Put(const std::vector<T>& list) {
    Put(list.size());
    for (const T& item : list) Put(item);
  }
  template <typename T>
  void Put(const std::optional<T>& value) {
    Put(value.has_value());
    if (value) Put(*value);
  }
  template <typename Record>
  void Put(const Record& record) {
    EachField(record, *this);
  }

  std::string bytes_;
};

/// Reads what ByteWriter wrote of the same records. Throws std::invalid_argument for other bytes.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <typename T>
  void operator()(const char*, T& value) {
    Get(value);
  }
  template <typename Enum>
  void Choice(const char*, Enum& value, const auto& names) {
    int index = 0;
    Get(index);
    if (index < 0 || static_cast<std::size_t>(index) >= names.size()) Refuse();
    value = static_cast<Enum>(index);
  }
  std::string_view Next(std::size_t count) {
    if (rest_.size() < count) Refuse();
    const std::string_view next = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return next;
  }
  bool AtEnd() const { return rest_.empty(); }
  [[noreturn]] static void Refuse() { throw std::invalid_argument("no reduced vehicle of this version"); }

 private:
  std::uint64_t Integer(std::size_t bytes) {
    std::uint64_t bits = 0;
    int shift = 0;
    for (const char byte : Next(bytes)) {
      bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(byte)) << shift;
      shift += 8;
    }
    return bits;
  }
  /// Of items that take a byte at the least.
  std::size_t Count() {
    const auto count = static_cast<std::size_t>(Integer(4));
    if (count > rest_.size()) Refuse();
    return count;
  }
  void Get(double& number) {
    const std::uint64_t bits = Integer(8);
    std::memcpy(&number, &bits, sizeof bits);
  }
  void Get(int& number) { number = static_cast<int>(static_cast<std::uint32_t>(Integer(4))); }
  void Get(std::size_t& number) { number = static_cast<std::size_t>(Integer(4)); }
  void Get(bool& is_set) { is_set = Integer(1) != 0; }
  void Get(std::string& text) { text = Next(Count()); }
  void Get(Scalar& scalar) {
    Get(scalar.parameter);
    Get(scalar.parameter < 0 ? scalar.value : scalar.factor);
  }
  void Get(Eigen::Vector3d& vector) {
    for (double& number : vector) Get(number);
  }
  void Get(Eigen::VectorXd& vector) {
    vector.resize(static_cast<Eigen::Index>(Count()));
    for (double& number : vector) Get(number);
  }
  void Get(Eigen::MatrixXd& matrix) {
    bool is_symmetric = false;
    std::size_t rows = 0;
    std::size_t cols = 0;
    Get(is_symmetric);
    Get(rows);
    Get(cols);
    // Before any memory is taken; sizes are of 32 bits. A vehicle without sensors has rows of none.
    const std::size_t stored = is_symmetric ? rows * (rows + 1) / 2 : rows * cols;
    if ((is_symmetric && rows != cols) || stored > rest_.size() / sizeof(double)) Refuse();
    matrix.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(cols));
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      for (Eigen::Index i = 0; i < (is_symmetric ? j + 1 : matrix.rows()); ++i) {
        Get(matrix(i, j));
        if (is_symmetric) matrix(j, i) = matrix(i, j);
      }
  }
  template <typename T, std::size_t n>
  void Get(std::array<T, n>& list) {
    for (T& item : list) Get(item);
  }
  void Get(std::vector<bool>& list) {
    list.resize(Count());
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = Integer(1) != 0;
  }
  template <typename T>
  void Get(std::vector<T>& list) {
    list.resize(Count());
    for (T& item : list) Get(item);
  }
  template <typename T>
  void Get(std::optional<T>& value) {
    bool has_value = false;
    Get(has_value);
    value.reset();
    if (!has_value) return;
    // clang 14 has no emplace() for a nested record with default values.
    T read{};
    Get(read);
    value = std::move(read);
  }
  template <typename Record>
  void Get(Record& record) {
    EachField(record, *this);
  }

  std::string_view rest_;
};

}  // namespace fourpost
