#include "analysis/files/recording/file_lines.h"

#include <algorithm>

namespace fourpost {
namespace {

constexpr std::uint64_t kPiece = std::uint64_t{1} << 18;

}  // namespace

bool FileLines::Next(std::string_view& line) {
  if (at_ >= bytes_->size()) return false;
  const auto end_of_line = [&] {
    const bool is_here = at_ >= buffer_at_ && at_ - buffer_at_ <= buffer_.size();
    return is_here ? buffer_.find('\n', at_ - buffer_at_) : std::string::npos;
  };
  std::size_t end = end_of_line();
  if (end == std::string::npos) {
    buffer_ = bytes_->ReadUpTo(at_, kPiece);
    buffer_at_ = at_;
    end = std::min(buffer_.find('\n'), buffer_.size());
  }
  const std::size_t begin = at_ - buffer_at_;
  line = std::string_view(buffer_).substr(begin, end - begin);
  at_ = buffer_at_ + std::min(end + 1, buffer_.size());
  ++next_line_;
  while (line.ends_with('\r')) line.remove_suffix(1);
  return !buffer_.empty();
}

}  // namespace fourpost
