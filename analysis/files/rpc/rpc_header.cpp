#include "analysis/files/rpc/rpc_header.h"

#include <string_view>

#include "analysis/files/recording/recording_fault.h"
#include "analysis/files/rpc/findings.h"
#include "analysis/text/number.h"

namespace fourpost {
namespace {

constexpr std::uint64_t kMostWhole = (std::uint64_t{1} << 31) - 1;

/// Up to the zero that ends it, without blanks around it and quotes, which belong to descriptions of several words.
std::string TextOf(std::string_view field) {
  field = field.substr(0, field.find('\0'));
  constexpr std::string_view kAround = " \t\r\n\"";
  const std::size_t first = field.find_first_not_of(kAround);
  if (first == std::string_view::npos) return "";
  return std::string(field.substr(first, field.find_last_not_of(kAround) - first + 1));
}

}  // namespace

RpcHeader::RpcHeader(const FileBytes& bytes) {
  const auto read = [&](std::uint64_t from, std::uint64_t to) {
    const std::string records = bytes.Read(from * kRpcRecord, (to - from) * kRpcRecord, "the header");
    for (std::uint64_t i = 0; i < to - from; ++i) {
      const std::string_view record = std::string_view(records).substr(i * kRpcRecord, kRpcRecord);
      const std::string key = TextOf(record.substr(0, kRpcKey));
      if (!key.empty()) entries_.emplace(key, Entry{TextOf(record.substr(kRpcKey)), from + i + 1});
    }
  };
  constexpr std::uint64_t kFirst = 3;
  read(0, kFirst);
  blocks_ = Whole("NUM_HEADER_BLOCKS", 1);
  read(kFirst, blocks_ * kRpcBlock / kRpcRecord);
}

const RpcHeader::Entry& RpcHeader::Required(const std::string& key) const {
  const auto found = entries_.find(key);
  if (found == entries_.end()) throw RecordingFault(kRpcKeyMissing, {key});
  return found->second;
}

std::string RpcHeader::Text(const std::string& key) const {
  const auto found = entries_.find(key);
  return found == entries_.end() ? "" : found->second.value;
}

std::string RpcHeader::RequiredText(const std::string& key) const { return Required(key).value; }

std::uint64_t RpcHeader::Whole(const std::string& key, std::uint64_t least,
                               std::optional<std::uint64_t> otherwise) const {
  if (otherwise && !entries_.contains(key)) return *otherwise;
  const Entry& entry = Required(key);
  const std::optional<double> number = ParseNumber(entry.value);
  const bool is_good = number && *number >= static_cast<double>(least) && *number <= static_cast<double>(kMostWhole) &&
                       *number == static_cast<double>(static_cast<std::uint64_t>(*number));
  if (!is_good)
    throw RecordingFault(kRpcValue, {std::to_string(entry.record), key, entry.value,
                                     "a whole number from " + std::to_string(least) + " on"});
  return static_cast<std::uint64_t>(*number);
}

double RpcHeader::Number(const std::string& key) const {
  const Entry& entry = Required(key);
  const std::optional<double> number = ParseNumber(entry.value);
  if (!number || *number == 0)
    throw RecordingFault(kRpcValue, {std::to_string(entry.record), key, entry.value, "a number other than zero"});
  return *number;
}

std::string RpcHeader::RecordOf(const std::string& key) const { return std::to_string(Required(key).record); }

bool IsRpc(std::string_view head) {
  return head.size() >= 2 * kRpcRecord && TextOf(head.substr(0, kRpcKey)) == "FORMAT" &&
         TextOf(head.substr(kRpcRecord, kRpcKey)) == "NUM_HEADER_BLOCKS";
}

}  // namespace fourpost
