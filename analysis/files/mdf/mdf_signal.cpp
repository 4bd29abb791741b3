#include "analysis/files/mdf/mdf_signal.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/files/recording/findings.h"
#include "analysis/files/recording/inflated.h"
#include "analysis/files/recording/recording_fault.h"

namespace fourpost {
namespace {

/// Stored bytes that are read at once.
constexpr std::uint64_t kPiece = std::uint64_t{1} << 22;

/// Rows again, of bytes that stand column after column; what is no whole row stands behind them.
std::string Rows(const std::string& columns, std::uint64_t row) {
  const std::uint64_t rows = columns.size() / row;
  std::string bytes(columns);
  for (std::uint64_t c = 0; c < row; ++c)
    for (std::uint64_t r = 0; r < rows; ++r) bytes[r * row + c] = columns[c * rows + r];
  return bytes;
}

std::string Unpacked(const FileBytes& bytes, const MdfPiece& piece) {
  std::string records = Inflated(bytes.Read(piece.at, piece.stored, "packed data"), piece.bytes);
  if (records.size() != piece.bytes) throw RecordingFault(kRecordingInflate, {"MDF", std::to_string(piece.at)});
  return piece.row > 1 ? Rows(records, piece.row) : records;
}

/// Of the records of a group, in order.
class Records {
 public:
  Records(const MdfGroup& group, const MdfSignal& signal) : group_(group), signal_(signal) {
    values_.reserve(group.cycles);
  }

  void Take(std::string_view bytes) {
    const std::uint64_t size = group_.record_bytes;
    if (!rest_.empty()) {
      const std::uint64_t missing = std::min<std::uint64_t>(size - rest_.size(), bytes.size());
      rest_ += bytes.substr(0, missing);
      bytes.remove_prefix(missing);
      if (rest_.size() < size) return;
      TakeOne(rest_);
      rest_.clear();
    }
    for (; bytes.size() >= size; bytes.remove_prefix(size)) TakeOne(bytes.substr(0, size));
    rest_ = bytes;
  }

  std::vector<double> values() && { return std::move(values_); }

 private:
  void TakeOne(std::string_view record) {
    if (values_.size() < group_.cycles) values_.push_back(signal_.conversion.Of(signal_.field.In(record)));
  }

  const MdfGroup& group_;
  const MdfSignal& signal_;
  /// The beginning of a record.
  std::string rest_;
  std::vector<double> values_;
};

double InTable(const std::vector<double>& pairs, double raw, bool is_interpolated) {
  std::size_t above = 0;
  const std::size_t points = pairs.size() / 2;
  while (above < points && pairs[2 * above] < raw) ++above;
  if (above == 0) return pairs[1];
  if (above == points) return pairs[2 * points - 1];
  const double share = (raw - pairs[2 * above - 2]) / (pairs[2 * above] - pairs[2 * above - 2]);
  const double low = pairs[2 * above - 1];
  const double high = pairs[2 * above + 1];
  if (is_interpolated) return low + share * (high - low);
  // The nearer point, and of two the lower.
  return share > 0.5 ? high : low;
}

}  // namespace

bool MdfConversion::IsComplete() const {
  switch (kind) {
    case Kind::kNone: return true;
    case Kind::kLinear: return numbers.size() >= 2;
    case Kind::kRational: return numbers.size() >= 6;
    default: return numbers.size() >= 2 && numbers.size() % 2 == 0;
  }
}

double MdfConversion::Of(double raw) const {
  const std::vector<double>& p = numbers;
  switch (kind) {
    case Kind::kNone: return raw;
    case Kind::kLinear: return raw * p[1] + p[0];
    case Kind::kRational: return (p[0] * raw * raw + p[1] * raw + p[2]) / (p[3] * raw * raw + p[4] * raw + p[5]);
    case Kind::kInterpolated: return InTable(p, raw, true);
    case Kind::kTable: return InTable(p, raw, false);
  }
  return raw;
}

bool MdfField::IsWithin(std::uint64_t record_bytes) const {
  const bool is_float = kind == StoredNumber::Kind::kFloat;
  if (is_float ? bit != 0 || (bits != 32 && bits != 64) : bits == 0 || bit > 7 || bit + bits > 64) return false;
  const std::uint64_t size = (bit + bits + 7) / 8;
  const bool has_flag = !invalid_bit || *invalid_bit / 8 < record_bytes;
  return has_flag && byte <= record_bytes && size <= record_bytes - byte;
}

double MdfField::In(std::string_view record) const {
  if (invalid_bit && (static_cast<unsigned char>(record[*invalid_bit / 8]) >> *invalid_bit % 8 & 1) != 0)
    return std::numeric_limits<double>::quiet_NaN();
  const char* place = record.data() + byte;
  if (kind == StoredNumber::Kind::kFloat)
    return bits == 32 ? static_cast<double>(NumberAt<float>(place, is_big_endian))
                      : NumberAt<double>(place, is_big_endian);
  const unsigned size = (bit + bits + 7) / 8;
  std::uint64_t number = 0;
  for (unsigned i = 0; i < size; ++i) {
    const auto value = static_cast<unsigned char>(place[is_big_endian ? i : size - 1 - i]);
    number = number << 8 | value;
  }
  number >>= bit;
  if (bits == 64)
    return kind == StoredNumber::Kind::kSigned ? static_cast<double>(static_cast<std::int64_t>(number))
                                               : static_cast<double>(number);
  number &= (std::uint64_t{1} << bits) - 1;
  const bool is_negative = kind == StoredNumber::Kind::kSigned && (number >> (bits - 1) & 1) != 0;
  return is_negative ? -static_cast<double>((std::uint64_t{1} << bits) - number) : static_cast<double>(number);
}

std::vector<double> ReadSignal(const FileBytes& bytes, const MdfGroup& group, const MdfSignal& signal) {
  if (signal.field.bits == 0) {
    std::vector<double> values(group.cycles);
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = signal.conversion.Of(static_cast<double>(k));
    return values;
  }
  Records records(group, signal);
  for (const MdfPiece& piece : group.pieces) {
    if (piece.is_deflated) {
      records.Take(Unpacked(bytes, piece));
      continue;
    }
    for (std::uint64_t at = 0; at < piece.stored; at += kPiece)
      records.Take(bytes.Read(piece.at + at, std::min(kPiece, piece.stored - at), "the data of a group"));
  }
  return std::move(records).values();
}

}  // namespace fourpost
