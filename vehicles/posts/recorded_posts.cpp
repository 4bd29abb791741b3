#include "vehicles/posts/recorded_posts.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "analysis/csv.h"
#include "analysis/nearest.h"
#include "analysis/number.h"
#include "analysis/units.h"
#include "vehicles/posts/post_motions.h"

namespace fourpost {
namespace {

/// Long against a car's body modes.
constexpr double kLead_s = 2;
/// So many gaps are told one by one.
constexpr int kMostFindings = 5;

/// Reads one file; remembers whether all was well.
class RecordReader {
 public:
  RecordReader(const CsvTable& table, Diagnostics& diagnostics) : table_(table), diagnostics_(diagnostics) {}

  bool good() const { return good_; }

  /// SI; empty where the column is not there.
  std::vector<double> Column(const std::vector<std::string>& names, const Dimension& dimension, const char* what) {
    for (const std::string& name : names)
      if (const std::optional<std::size_t> column = table_.FindColumn(name)) return Read(*column, dimension, what);
    Fault(1, "column '" + names[0] + "', " + what + ", is missing" + DidYouMean(names[0], table_.names()));
    return {};
  }

  /// Step of evenly spaced times.
  double Step(const std::vector<double>& times) {
    if (times.size() < 4) {
      Fault(0, "has " + std::to_string(times.size()) + " samples; it takes four at least");
      return 0;
    }
    const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    int found = 0;
    for (std::size_t k = 1; k < times.size() && found < kMostFindings; ++k) {
      const double here = times[k] - times[k - 1];
      // Half a step is more than any rounding of times, and less than a sample that is lost.
      if (here > 0.5 * step && here < 1.5 * step) continue;
      ++found;
      Fault(table_.line(k), "time goes from " + FormatNumber(times[k - 1]) + " s to " + FormatNumber(times[k]) +
                                " s, on average by " + FormatNumber(std::round(1e9 * step) * 1e-9) +
                                " s: samples must be evenly spaced; fill the gap or cut the record there");
    }
    return step;
  }

 private:
  void Fault(int line, const std::string& message) {
    diagnostics_.Error(table_.file(), line, message);
    good_ = false;
  }

  std::vector<double> Read(std::size_t column, const Dimension& dimension, const char* what) {
    const std::string quoted = "column '" + table_.names()[column] + "'";
    const std::string& text = table_.units()[column];
    const std::optional<Unit> unit = ParseUnit(text);
    if (!unit || unit->dimension != dimension)
      Fault(2, quoted + ", " + what + ", has '" + text + "' for its unit; it takes a " + DimensionName(dimension) +
                   " such as '" + (dimension == kLength ? "mm" : SiUnit(dimension)) + "' in the second line");
    std::vector<double> values(table_.rows());
    int found = 0;
    for (std::size_t row = 0; row < table_.rows() && found < kMostFindings; ++row) {
      const std::optional<double> number = table_.Number(row, column);
      if (number && std::isfinite(*number)) {
        values[row] = *number * (unit ? unit->si : 1);
        continue;
      }
      ++found;
      Fault(table_.line(row),
            quoted + " has " +
                (table_.Text(row, column).empty() ? std::string("no number") : "'" + table_.Text(row, column) + "'") +
                " here; fill the gap or cut the record there");
    }
    return values;
  }

  const CsvTable& table_;
  Diagnostics& diagnostics_;
  bool good_ = true;
};

/// Lead-in and record as one spline: from rest by the polynomial of least order that meets height and velocity with no
/// acceleration at both ends.
UniformSpline WithLead(const std::vector<double>& heights, double start, double step, std::size_t lead) {
  const std::vector<double> backward(heights.rbegin(), heights.rend());
  const double slope = SlopeAtStart(heights, step);
  const double duration = step * static_cast<double>(lead);
  std::vector<double> all;
  for (std::size_t k = 0; k < lead; ++k) {
    const double u = static_cast<double>(k) / static_cast<double>(lead);
    const double cube = u * u * u;
    all.push_back(heights[0] * cube * (10 - 15 * u + 6 * u * u) + slope * duration * cube * (-4 + 7 * u - 3 * u * u));
  }
  all.insert(all.end(), heights.begin(), heights.end());
  return {start - duration, step, std::move(all), 0, -SlopeAtStart(backward, step)};
}

}  // namespace

std::optional<RecordedPosts> ReadRecordedPosts(const std::filesystem::path& file, const Vehicle& vehicle,
                                               Diagnostics& diagnostics) {
  const std::optional<CsvTable> table = ReadCsv(file, diagnostics, CsvHeader::kNamesAndUnits);
  if (!table) return std::nullopt;
  RecordReader reader(*table, diagnostics);
  const std::vector<double> times = reader.Column({"time"}, kTime, "the time of each sample");
  std::vector<std::vector<double>> heights;
  for (const Post& post : vehicle.posts)
    heights.push_back(reader.Column({post.name, "post_" + post.name}, kLength, "the height of a post"));
  const double step = reader.good() ? reader.Step(times) : 0;
  if (!reader.good()) return std::nullopt;
  const auto lead = static_cast<std::size_t>(std::ceil(kLead_s / step));
  std::vector<DelayedTrack> tracks;
  for (const std::vector<double>& post : heights) tracks.push_back({WithLead(post, times.front(), step, lead), 0});
  return RecordedPosts{FollowTracks(std::move(tracks)), times.front(), times.back(), step,
                       step * static_cast<double>(lead)};
}

}  // namespace fourpost
