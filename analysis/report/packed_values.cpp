#include "analysis/report/packed_values.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <zlib.h>

#include "analysis/text/base64.h"

namespace fourpost {
namespace {

constexpr double kMost = 32767;
constexpr int kNone = -32768;

bool IsEven(const std::vector<double>& values, double step) {
  if (values.size() < 2 || !std::isfinite(step) || step == 0) return false;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(std::abs(values[i] - values.front() - static_cast<double>(i) * step) <= 1e-3 * std::abs(step))) return false;
  return true;
}

double LargestOf(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

std::string Deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib could not pack numbers of a page");
  packed.resize(size);
  return packed;
}

}  // namespace

nlohmann::ordered_json PackedValues(const std::vector<double>& values) {
  const std::size_t rows = values.size();
  const double step = rows > 1 ? (values.back() - values.front()) / static_cast<double>(rows - 1) : 0;
  if (IsEven(values, step)) return {{"rows", rows}, {"first", values.front()}, {"step", step}};
  const double largest = LargestOf(values);
  const double unit = largest > 0 ? largest / kMost : 1;
  std::string bytes(2 * rows, '\0');
  unsigned before = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const auto steps =
        static_cast<unsigned>(std::isfinite(values[i]) ? static_cast<int>(std::lround(values[i] / unit)) : kNone);
    const unsigned difference = steps - before;
    before = steps;
    bytes[i] = static_cast<char>(difference & 0xffu);
    bytes[rows + i] = static_cast<char>(difference >> 8 & 0xffu);
  }
  return {{"rows", rows}, {"scale", unit}, {"packed", Base64(Deflated(bytes))}};
}

}  // namespace fourpost
