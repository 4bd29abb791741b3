#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "analysis/files/recording/file_bytes.h"

namespace fourpost {

inline constexpr std::uint64_t kRpcBlock = 512;
inline constexpr std::uint64_t kRpcRecord = 128;
inline constexpr std::uint64_t kRpcKey = 32;

/// The keys and values of an RPC III header ("RPC III File Formats", MTS): records of 128 bytes, 32 of them the key, in
/// NUM_HEADER_BLOCKS blocks of 512. Functions throw RecordingFault.
class RpcHeader {
 public:
  explicit RpcHeader(const FileBytes& bytes);

  /// Of all its blocks.
  std::uint64_t size() const { return blocks_ * kRpcBlock; }
  /// Empty where it has none.
  std::string Text(const std::string& key) const;
  std::string RequiredText(const std::string& key) const;
  /// A whole number from `least` to 2^31 - 1; a key that is missing is a fault unless there is an `otherwise`.
  std::uint64_t Whole(const std::string& key, std::uint64_t least,
                      std::optional<std::uint64_t> otherwise = std::nullopt) const;
  /// Finite, and not zero.
  double Number(const std::string& key) const;
  /// 1-based.
  std::string RecordOf(const std::string& key) const;

 private:
  struct Entry {
    std::string value;
    std::uint64_t record = 0;
  };
  const Entry& Required(const std::string& key) const;

  std::uint64_t blocks_ = 1;
  std::map<std::string, Entry> entries_;
};

/// Whether these bytes begin an RPC III file.
bool IsRpc(std::string_view head);

}  // namespace fourpost
