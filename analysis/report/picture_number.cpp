#include "analysis/report/picture_number.h"

#include <array>
#include <charconv>
#include <cmath>

namespace fourpost {

nlohmann::ordered_json PictureNumber(double value) {
  if (!std::isfinite(value)) return nullptr;
  std::array<char, 32> text;
  const char* end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr;
  double rounded = 0;
  std::from_chars(text.data(), end, rounded);
  if (rounded == std::round(rounded) && std::abs(rounded) < 1e9) return static_cast<std::int64_t>(rounded);
  return rounded;
}

nlohmann::ordered_json PictureNumbers(const std::vector<double>& values) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const double value : values) list.push_back(PictureNumber(value));
  return list;
}

}  // namespace fourpost
