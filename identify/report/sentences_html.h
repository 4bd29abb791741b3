#pragma once

#include <string>

namespace fourpost {

/// A note in which each line of a text is a sentence, HTML.
std::string SentencesHtml(const std::string& text);

/// A text in which what stands between backticks is code, HTML; one that has no partner stays.
std::string CodeHtml(const std::string& text);

}  // namespace fourpost
