#include "vehicles/requests/versions.h"

#include <elf.h>
#include <link.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include <ceres/version.h>
#include <Eigen/Core>

#include "analysis/files/sha256.h"

#include "vehicles/multibody/simbody_version.h"

namespace fourpost {
namespace {

std::string Hex(std::string_view bytes) {
  std::string hex;
  for (const char byte : bytes) {
    hex += "0123456789abcdef"[static_cast<unsigned char>(byte) >> 4];
    hex += "0123456789abcdef"[static_cast<unsigned char>(byte) & 15];
  }
  return hex;
}

/// A note: its head, its name and its bytes, the latter two on multiples of four.
std::string BuildIdIn(std::string_view notes) {
  const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
  while (notes.size() >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) head;
    std::memcpy(&head, notes.data(), sizeof head);
    const std::size_t start = sizeof head + padded(head.n_namesz);
    const std::size_t end = start + padded(head.n_descsz);
    if (end > notes.size()) break;
    const bool is_gnu = notes.substr(sizeof head, head.n_namesz) == std::string_view("GNU\0", 4);
    if (is_gnu && head.n_type == NT_GNU_BUILD_ID) return Hex(notes.substr(start, head.n_descsz));
    notes.remove_prefix(end);
  }
  return "";
}

/// Called for each loaded object, the program itself first.
int TakeFirst(dl_phdr_info* object, std::size_t, void* id) {
  for (std::size_t i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    const auto* notes = reinterpret_cast<const char*>(object->dlpi_addr + segment.p_vaddr);
    std::string found = BuildIdIn({notes, segment.p_memsz});
    if (!found.empty()) *static_cast<std::string*>(id) = std::move(found);
  }
  return 1;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> Versions() {
  const std::string eigen = std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                            std::to_string(EIGEN_MINOR_VERSION);
  return {
      {"fourpost", FOURPOST_VERSION}, {"simbody", SimbodyVersion()}, {"ceres", CERES_VERSION_STRING}, {"eigen", eigen}};
}

std::string BuildId() {
  std::string id;
  dl_iterate_phdr(TakeFirst, &id);
  return id.empty() ? ProgramDigest() : id;
}

std::string ProgramDigest() {
  std::ifstream stream("/proc/self/exe", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (bytes.empty()) throw std::runtime_error("cannot read /proc/self/exe, which tells builds of fourpost apart");
  Sha256 digest;
  digest.Add(bytes);
  return digest.Hex();
}

}  // namespace fourpost
