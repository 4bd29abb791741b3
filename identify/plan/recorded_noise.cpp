#include "identify/plan/recorded_noise.h"

#include <cmath>
#include <limits>
#include <optional>
#include <system_error>

#include "analysis/files/csv.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

/// Mean of squares.
struct Squares {
  double sum = 0;
  double count = 0;

  double Root() const { return count > 0 ? std::sqrt(sum / count) : std::numeric_limits<double>::quiet_NaN(); }
};

}  // namespace

std::vector<double> RecordedNoise(const std::filesystem::path& run, const Vehicle& vehicle) {
  std::vector<Squares> squares(vehicle.sensors.size());
  std::error_code failure;
  Diagnostics ignored;
  std::optional<CsvTable> table;
  if (std::filesystem::is_regular_file(run / "response.csv", failure)) table = ReadCsv(run / "response.csv", ignored);
  if (table) {
    const auto channel = table->FindColumn("channel");
    const auto frequency = table->FindColumn("frequency_Hz");
    const auto amplitude = table->FindColumn("post_amplitude_m");
    const auto deviation = table->FindColumn("gain_sd");
    for (std::size_t row = 0; channel && frequency && amplitude && deviation && row < table->rows(); ++row) {
      const std::optional<double> f = table->Number(row, *frequency);
      const std::optional<double> a = table->Number(row, *amplitude);
      const std::optional<double> sd = table->Number(row, *deviation);
      if (!f || !a || !sd || !(*sd > 0)) continue;
      for (std::size_t s = 0; s < squares.size(); ++s) {
        if (vehicle.sensors[s].name != table->Text(row, *channel)) continue;
        const double noise = *sd * *a * std::abs(ReferencePerMetre(vehicle.sensors[s].type, *f));
        squares[s].sum += noise * noise;
        ++squares[s].count;
      }
    }
  }
  std::vector<double> noise;
  for (const Squares& one : squares) noise.push_back(one.Root());
  return noise;
}

}  // namespace fourpost
