#include "vehicles/tags/xml_scanner.h"

#include <algorithm>
#include <array>
#include <optional>

namespace fourpost {
namespace {

constexpr std::string_view kXmlBlanks = " \t\r\n";

/// Text between such marks holds no tags.
struct Passage {
  std::string_view begin;
  std::string_view end;
};
constexpr std::array<Passage, 5> kPassages = {
    {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}, {"</", ">"}}};

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<TagPlaces> Scan() {
    std::vector<TagPlaces> tags;
    for (at_ = text_.find('<'); at_ < text_.size(); at_ = text_.find('<', at_))
      if (!SkipPassage()) tags.push_back(ReadTag());
    return tags;
  }

 private:
  void SkipBehind(std::string_view mark) { at_ = std::min(text_.size(), text_.find(mark, at_)) + mark.size(); }

  bool SkipPassage() {
    for (const Passage& passage : kPassages) {
      if (!text_.substr(at_).starts_with(passage.begin)) continue;
      at_ += passage.begin.size();
      SkipBehind(passage.end);
      return true;
    }
    return false;
  }

  TagPlaces ReadTag() {
    TagPlaces places;
    at_ = std::min(text_.size(), text_.find_first_of(" \t\r\n/>", at_));
    places.name_end = at_;
    while (std::optional<AttributePlace> place = ReadAttribute()) places.attributes.push_back(*place);
    return places;
  }

  /// Nothing at the end of the tag.
  std::optional<AttributePlace> ReadAttribute() {
    at_ = text_.find_first_not_of(kXmlBlanks, at_);
    if (at_ >= text_.size() || text_[at_] == '>' || text_[at_] == '/') return std::nullopt;
    const std::size_t equals = text_.find('=', at_);
    if (equals == std::string_view::npos) return std::nullopt;
    AttributePlace place;
    place.name = text_.substr(at_, std::min(equals, text_.find_first_of(kXmlBlanks, at_)) - at_);
    at_ = std::min(text_.find_first_of("\"'", equals), text_.size() - 1);
    place.quote = text_[at_];
    place.begin = at_ + 1;
    place.end = std::min(text_.find(place.quote, place.begin), text_.size());
    at_ = place.end + 1;
    return place;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<TagPlaces> ScanTags(std::string_view text) { return Scanner(text).Scan(); }

}  // namespace fourpost
