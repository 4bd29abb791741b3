#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace fourpost {

/// Numbers of an HDF5 file and what stands beside them.
struct Hdf5Dataset {
  /// "/run/force".
  std::string path;
  std::uint64_t rows = 0;
  /// Of a matrix; else 1.
  std::uint64_t columns = 1;
  /// A channel a row, in place of a column.
  bool is_transposed = false;
  std::vector<std::string> names;
  std::vector<std::string> units;
  double step_s = 0;
  double start_s = 0;
};

struct Hdf5Contents {
  std::string description;
  bool is_of_matlab = false;
  std::vector<Hdf5Dataset> datasets;
  /// Paths of datasets that are no plain numbers.
  std::vector<std::string> left_out;
};

/// By the HDF5 library in a process of its own. Throws RecordingFault.
Hdf5Contents ListHdf5(const std::filesystem::path& file);
/// One column. What is asked for is compared with the bytes that the file stores of it before memory is taken.
std::vector<double> ReadHdf5(const std::filesystem::path& file, const Hdf5Dataset& dataset, std::uint64_t column);

}  // namespace fourpost
