#include "identify/study_file/result_reader.h"

#include <limits>
#include <optional>
#include <system_error>

#include "analysis/files/text_file.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

using Json = nlohmann::json;

Json ParseResult(const std::string& text) {
  constexpr int kDeepest = 30;
  if (text.size() > kLargestResult) return Json(Json::value_t::discarded);
  bool is_deep = false;
  const auto look = [&](int depth, Json::parse_event_t, Json&) {
    is_deep |= depth > kDeepest;
    return !is_deep;
  };
  Json result = Json::parse(text, look, false);
  return is_deep ? Json(Json::value_t::discarded) : result;
}

Json ReadResultFile(const std::filesystem::path& file) {
  std::error_code failure;
  if (std::filesystem::file_size(file, failure) > kLargestResult || failure) return Json(Json::value_t::discarded);
  Diagnostics ignored;
  const std::optional<std::string> text = ReadTextFile(file, ignored);
  return text ? ParseResult(*text) : Json(Json::value_t::discarded);
}

double NumberAt(const Json& object, const std::string& key) {
  if (!object.is_object()) return std::numeric_limits<double>::quiet_NaN();
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string TextAt(const Json& object, const std::string& key) {
  if (!object.is_object()) return "";
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

std::vector<Json> ListAt(const Json& object, const std::string& key) {
  if (!object.is_object()) return {};
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? found->get<std::vector<Json>>() : std::vector<Json>();
}

}  // namespace fourpost
