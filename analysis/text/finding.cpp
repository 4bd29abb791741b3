#include "analysis/text/finding.h"

#include <stdexcept>

namespace fourpost {
namespace {

constexpr std::string_view kSlot = "{}";

std::map<std::string_view, const Finding*>& Table() {
  static std::map<std::string_view, const Finding*> table;
  return table;
}

}  // namespace

Finding::Finding(std::string_view id, Severity severity, std::string_view text, std::string_view remedy)
    : id_(id), severity_(severity), text_(text), remedy_(remedy) {
  if (!Table().emplace(id, this).second) throw std::logic_error("two findings are called " + std::string(id));
}

std::string Finding::Message(const std::vector<std::string>& words) const {
  const std::string form = std::string(text_) + (remedy_.empty() ? "" : ": ") + std::string(remedy_);
  std::string message;
  std::size_t from = 0;
  for (const std::string& word : words) {
    const std::size_t slot = form.find(kSlot, from);
    if (slot == std::string::npos) throw std::logic_error("too many words for finding " + std::string(id_));
    message += form.substr(from, slot - from) + word;
    from = slot + kSlot.size();
  }
  if (form.find(kSlot, from) != std::string::npos)
    throw std::logic_error("too few words for finding " + std::string(id_));
  return message + form.substr(from);
}

const std::map<std::string_view, const Finding*>& AllFindings() { return Table(); }

}  // namespace fourpost
