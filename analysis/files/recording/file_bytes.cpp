#include "analysis/files/recording/file_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "analysis/files/recording/findings.h"
#include "analysis/files/recording/recording_fault.h"

namespace fourpost {
namespace {

[[noreturn]] void ThrowErrno() { throw RecordingFault(kRecordingNotOpened, {std::generic_category().message(errno)}); }

}  // namespace

FileBytes::FileBytes(const std::filesystem::path& file, std::string format) : format_(std::move(format)) {
  file_ = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (file_ < 0) ThrowErrno();
  struct stat status {};
  if (fstat(file_, &status) != 0) {
    close(file_);
    ThrowErrno();
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

FileBytes::~FileBytes() { close(file_); }

void FileBytes::Require(std::uint64_t at, std::uint64_t count, const std::string& what) const {
  if (at <= size_ && count <= size_ - at) return;
  throw RecordingFault(kRecordingCutShort,
                       {format_, what, std::to_string(at), std::to_string(count), std::to_string(size_)});
}

std::string FileBytes::Read(std::uint64_t at, std::uint64_t count, const std::string& what) const {
  Require(at, count, what);
  std::string bytes = ReadUpTo(at, count);
  // Cut while it was read.
  if (bytes.size() != count)
    throw RecordingFault(kRecordingCutShort,
                         {format_, what, std::to_string(at), std::to_string(count), std::to_string(at + bytes.size())});
  return bytes;
}

std::string FileBytes::ReadUpTo(std::uint64_t at, std::uint64_t count) const {
  if (at >= size_) return {};
  std::string bytes(std::min(count, size_ - at), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t read = pread(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(at + done));
    if (read < 0 && errno == EINTR) continue;
    if (read < 0) ThrowErrno();
    if (read == 0) break;
    done += static_cast<std::size_t>(read);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace fourpost
