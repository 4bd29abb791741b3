// Preloaded into the program: no file grows beyond FULL_DISK_BYTES, as on a full disk.
#include <dlfcn.h>
#include <sys/types.h>

#include <cerrno>
#include <cstdlib>

namespace {

using Write = ssize_t(int, const void*, size_t, off64_t);

ssize_t WriteWhereThereIsRoom(const char* name, int file, const void* bytes, size_t count, off64_t offset) {
  const char* limit = std::getenv("FULL_DISK_BYTES");
  if (limit != nullptr && offset + static_cast<off64_t>(count) > std::atoll(limit)) {
    errno = ENOSPC;
    return -1;
  }
  return reinterpret_cast<Write*>(dlsym(RTLD_NEXT, name))(file, bytes, count, offset);
}

}  // namespace

extern "C" ssize_t pwrite(int file, const void* bytes, size_t count, off_t offset) {
  return WriteWhereThereIsRoom("pwrite", file, bytes, count, offset);
}

extern "C" ssize_t pwrite64(int file, const void* bytes, size_t count, off64_t offset) {
  return WriteWhereThereIsRoom("pwrite64", file, bytes, count, offset);
}
