#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "analysis/files/recording/recording_file.h"
#include "analysis/files/recording_format.h"
#include "analysis/files/sha256.h"
#include "tests/temporary_folder.h"

namespace fourpost {

/// The bytes of a number.
template <typename Number>
std::string BytesOf(Number number, bool is_big_endian = false) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (is_big_endian) std::reverse(bytes.begin(), bytes.end());
  return {bytes.begin(), bytes.end()};
}

template <typename Number>
std::string BytesOf(const std::vector<Number>& numbers, bool is_big_endian = false) {
  std::string bytes;
  for (const Number number : numbers) bytes += BytesOf(number, is_big_endian);
  return bytes;
}

/// Filled up with `filling`.
inline std::string Padded(const std::string& text, std::size_t size, char filling = '\0') {
  std::string padded(size, filling);
  return padded.replace(0, std::min(size, text.size()), text, 0, size);
}

/// SHA-256 of the numbers as doubles, little endian, one behind the other: what an independent reader computes.
inline std::string DigestOf(const std::vector<double>& numbers) {
  Sha256 digest;
  digest.AddBytes(BytesOf(numbers));
  return digest.Hex();
}

/// The file of this name, or throws what is wrong with it.
inline std::shared_ptr<const RecordingFile> OpenGood(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  std::shared_ptr<const RecordingFile> opened = OpenRecording(file, diagnostics);
  if (!opened) throw std::runtime_error("not read: " + diagnostics.Format());
  return opened;
}

/// A file of these bytes.
inline Recording ReadBytes(const std::string& bytes) {
  const TemporaryFolder folder;
  return OpenGood(folder.Write("recording", bytes))->ReadAll();
}

/// What is wrong with a file of these bytes.
inline Diagnostics FaultsOfBytes(const std::string& bytes) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  EXPECT_FALSE(OpenRecording(folder.Write("recording", bytes), diagnostics));
  return diagnostics;
}

inline std::filesystem::path SampleRecording(const std::string& name) {
  return std::filesystem::path(FOURPOST_SOURCE_DIR) / "tests/data/recordings" / name;
}

}  // namespace fourpost
