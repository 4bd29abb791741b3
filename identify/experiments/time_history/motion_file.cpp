#include "identify/experiments/time_history/motion_file.h"

#include <algorithm>
#include <cmath>

#include "analysis/files/csv.h"
#include "analysis/files/csv_writer.h"
#include "identify/experiments/time_history/findings.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// What a screen shows.
constexpr double kFrames_Hz = 60;
/// Some hundred kB of a page.
constexpr double kMostNumbers = 60000;
/// A micrometre or less of what moves by metres.
constexpr double kDigits = 1e7;

std::vector<std::string> Names(const Vehicle& vehicle, Index coordinates) {
  std::vector<std::string> names = {"recording", "time_s"};
  for (const Post& post : vehicle.posts) names.push_back("post_" + post.name + "_m");
  for (Index i = 0; i < coordinates; ++i) names.push_back("coordinate_" + std::to_string(i + 1));
  return names;
}

double ToFewDigits(double value) { return std::round(value * kDigits) / kDigits; }

/// Rows [first, last) of the table.
RecordedHistory HistoryOf(const CsvTable& table, std::size_t first, std::size_t last, std::size_t posts,
                          Diagnostics& faults) {
  const auto rows = static_cast<Index>(last - first);
  Eigen::MatrixXd numbers(rows, static_cast<Index>(table.columns()) - 1);
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < numbers.cols(); ++c)
      numbers(r, c) = table.Number(first + static_cast<std::size_t>(r), static_cast<std::size_t>(c) + 1).value_or(NAN);
  const Eigen::VectorXd time = numbers.col(0);
  RecordedHistory history{.name = table.Text(first, 0)};
  history.motion.start_s = time[0];
  history.motion.rate_Hz = static_cast<double>(rows - 1) / (time[rows - 1] - time[0]);
  const auto post_count = static_cast<Index>(posts);
  history.motion.posts = numbers.middleCols(1, post_count);
  history.motion.coordinates = numbers.rightCols(numbers.cols() - 1 - post_count);
  const auto even = Eigen::VectorXd::LinSpaced(rows, time[0], time[rows - 1]);
  // Times are written in full; a tenth of a frame is none that was taken out.
  const bool is_even = rows > 1 && history.motion.rate_Hz > 0 && std::isfinite(history.motion.rate_Hz) &&
                       ((time - even).cwiseAbs().maxCoeff() * history.motion.rate_Hz < 0.1);
  if (!is_even || !numbers.allFinite()) faults.Report(kMotionUneven, {table.file(), table.line(first)}, {history.name});
  return history;
}

}  // namespace

Index FrameStride(const MeasuredHistory& history, Index columns) {
  const double by_rate = history.rate_Hz / kFrames_Hz;
  const double by_size = static_cast<double>(history.count * columns) / kMostNumbers;
  // A rate that is a hair above has no stride of two.
  return std::max<Index>(1, std::lround(std::ceil(std::max(by_rate, by_size) - 1e-9)));
}

std::string MotionCsv(const Vehicle& vehicle, const std::vector<RecordedHistory>& histories) {
  CsvWriter csv(Names(vehicle, histories.empty() ? 0 : histories.front().motion.coordinates.cols()));
  for (const auto& [name, motion] : histories)
    for (Index k = 0; k < motion.posts.rows(); ++k) {
      csv.Add(name).Add(ToFewDigits(motion.start_s + static_cast<double>(k) / motion.rate_Hz));
      for (Index p = 0; p < motion.posts.cols(); ++p) csv.Add(ToFewDigits(motion.posts(k, p)));
      for (Index s = 0; s < motion.coordinates.cols(); ++s) csv.Add(ToFewDigits(motion.coordinates(k, s)));
    }
  return csv.text();
}

std::vector<RecordedHistory> ReadMotionCsv(const std::string& text, const std::string& file, const Vehicle& vehicle) {
  Diagnostics faults;
  const std::optional<CsvTable> table = ParseCsv(text, file, faults);
  if (!table) throw FaultyInput(faults);
  const std::size_t before = 2 + vehicle.posts.size();
  if (table->columns() < before ||
      table->names() != Names(vehicle, static_cast<Index>(table->columns()) - static_cast<Index>(before)))
    Refuse(kMotionColumns, {file, 1});
  std::vector<RecordedHistory> histories;
  for (std::size_t first = 0; first < table->rows();) {
    std::size_t last = first + 1;
    while (last < table->rows() && table->Text(last, 0) == table->Text(first, 0)) ++last;
    histories.push_back(HistoryOf(*table, first, last, vehicle.posts.size(), faults));
    first = last;
  }
  if (faults.HasErrors()) throw FaultyInput(faults);
  return histories;
}

}  // namespace fourpost
