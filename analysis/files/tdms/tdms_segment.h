#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/files/recording/file_bytes.h"
#include "analysis/files/recording/stored_number.h"

namespace fourpost {

/// A text, a number, or seconds of a time stamp.
using TdmsProperty = std::variant<std::string, double>;
using TdmsProperties = std::map<std::string, TdmsProperty>;

/// Names between the slashes of "/'Group'/'Channel'": none of the file, one of a group, two of a channel.
using TdmsPath = std::vector<std::string>;

/// What an object has in each chunk of a segment.
struct TdmsLayout {
  enum class Content { kNumbers, kTimeStamps, kOther };

  std::size_t object = 0;
  Content content = Content::kNumbers;
  StoredNumber stored;
  std::uint64_t count = 0;
  /// In a chunk.
  std::uint64_t bytes = 0;
};

/// Where raw data are: chunks, one behind the other, each of the values of all its objects.
struct TdmsSegment {
  std::uint64_t data_at = 0;
  std::uint64_t chunks = 0;
  std::uint64_t chunk_bytes = 0;
  bool is_interleaved = false;
  std::vector<TdmsLayout> layout;
};

struct TdmsObject {
  TdmsPath path;
  TdmsProperties properties;
};

/// The objects of a TDMS file and their data ("TDMS File Format Internal Structure", NI).
struct TdmsIndex {
  std::vector<TdmsObject> objects;
  std::vector<TdmsSegment> segments;
  /// Segments whose last chunk is incomplete.
  std::vector<std::uint64_t> cut_at;
};

/// Reads the lead-ins and properties of all segments. Throws RecordingFault.
TdmsIndex ReadTdmsIndex(const FileBytes& bytes);

}  // namespace fourpost
