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

Finding::Finding(std::string_view id, Severity severity, std::string_view text, std::string_view remedy, Weight weight)
    : id_(id), severity_(severity), text_(text), remedy_(remedy), weight_(weight) {
  if (!Table().emplace(id, this).second) throw std::logic_error("two findings are called " + std::string(id));
}

std::string Finding::Message(const std::vector<std::string>& words) const {
  auto word = words.begin();
  const auto filled = [&](std::string_view form) {
    std::string part;
    for (std::size_t slot = form.find(kSlot); slot != std::string_view::npos; slot = form.find(kSlot)) {
      if (word == words.end()) throw std::logic_error("too few words for finding " + std::string(id_));
      part += std::string(form.substr(0, slot)) + *word++;
      form.remove_prefix(slot + kSlot.size());
    }
    return part + std::string(form);
  };
  std::string message = filled(text_);
  // After "did you mean 'heave'?" the remedy goes on: "or give ...".
  if (!remedy_.empty()) message += (message.ends_with('?') ? " " : ": ") + filled(remedy_);
  if (word != words.end()) throw std::logic_error("too many words for finding " + std::string(id_));
  return message;
}

const std::map<std::string_view, const Finding*>& AllFindings() { return Table(); }

}  // namespace fourpost
