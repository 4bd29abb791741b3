#pragma once

#include <string>

namespace fourpost {

/// A note in which each line of a text is a sentence, HTML.
std::string SentencesHtml(const std::string& text);

}  // namespace fourpost
