#include "vehicles/tags/xml_limits.h"

#include <algorithm>
#include <string>
#include <system_error>

#include "vehicles/tags/findings.h"

namespace fourpost {
namespace {

Found TooLarge() { return {&kXmlFileTooLarge, {std::to_string(kMostXmlBytes >> 20) + " MiB"}}; }

bool BeginsName(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' ||
         static_cast<unsigned char>(c) > 127;
}

int LineAt(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
}

/// Goes from one '<' to the next. All functions give what is wrong at the current place.
class LimitScan {
 public:
  explicit LimitScan(std::string_view text) : text_(text) {}

  Found Scan() {
    Found fault;
    while (!fault && (at_ = text_.find('<', at_)) != std::string_view::npos) fault = PassMarkup();
    return fault;
  }

  int Line() const { return LineAt(text_, at_); }

 private:
  Found PassMarkup() {
    const std::string_view rest = text_.substr(at_);
    if (rest.starts_with("<!--")) return PassBehind("-->", 4);
    if (rest.starts_with("<![CDATA[")) return PassBehind("]]>", 9);
    if (rest.starts_with("<!")) return {&kXmlDocumentType};
    if (rest.starts_with("<?")) return PassInstruction();
    if (rest.starts_with("</")) return PassEndTag();
    if (rest.size() > 1 && BeginsName(rest[1])) return PassStartTag();
    return {&kXmlStrayBracket};
  }

  Found PassBehind(std::string_view mark, std::size_t from) {
    const std::size_t found = text_.find(mark, at_ + from);
    at_ = found == std::string_view::npos ? text_.size() : found + mark.size();
    return {};
  }

  Found PassInstruction() {
    if (text_.find('<', at_ + 1) < text_.find("?>", at_)) return {&kXmlInstruction};
    return PassBehind("?>", 2);
  }

  Found PassEndTag() {
    if (depth_ > 0) --depth_;
    return PassTag();
  }

  Found PassStartTag() {
    if (++elements_ > kMostXmlElements) return {&kXmlTags, {std::to_string(kMostXmlElements)}};
    if (++depth_ > kMostXmlDepth) return {&kXmlDepth, {std::to_string(kMostXmlDepth)}};
    Found fault = PassTag();
    if (text_.substr(0, at_).ends_with("/>")) --depth_;
    return fault;
  }

  /// To the next of these behind the current place; false at the end.
  bool GoTo(const char* marks) {
    at_ = std::min(text_.find_first_of(marks, at_ + 1), text_.size());
    return at_ < text_.size();
  }

  /// Goes behind the tag's '>', which does not count in quotes; of a tag without one, to the next '<' or the end: the
  /// parser reports that.
  Found PassTag() {
    std::size_t values = 0;
    while (GoTo("<>\"'") && text_[at_] != '<') {
      if (text_[at_] == '>') return PassBehind(">", 0);
      if (++values > kMostXmlAttributes) return {&kXmlAttributes, {std::to_string(kMostXmlAttributes)}};
      const std::size_t end = std::min(text_.find(text_[at_], at_ + 1), text_.size());
      if (text_.substr(at_, end - at_).find('<') != std::string_view::npos) return {&kXmlOpenQuote};
      at_ = end;
    }
    return {};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  std::size_t elements_ = 0;
};

}  // namespace

bool HasLegalSize(const std::filesystem::path& file, FileFaults& faults) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size <= kMostXmlBytes) return true;
  faults.Report(TooLarge(), 0);
  return false;
}

bool IsWithinXmlLimits(std::string_view text, FileFaults& faults) {
  if (text.size() > kMostXmlBytes) {
    faults.Report(TooLarge(), 0);
    return false;
  }
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    faults.Report(kXmlNul, LineAt(text, nul));
    return false;
  }
  LimitScan scan(text);
  const Found fault = scan.Scan();
  if (fault) faults.Report(fault, scan.Line());
  return !fault;
}

}  // namespace fourpost
