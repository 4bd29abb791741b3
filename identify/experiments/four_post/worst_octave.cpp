#include "identify/experiments/four_post/worst_octave.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include "identify/experiments/four_post/four_post_residuals.h"

namespace fourpost {
namespace {

/// Squares of residuals, two at each frequency.
struct OctaveSquares {
  double squares = 0;
  int frequencies = 0;

  double Misfit() const { return std::sqrt(squares / (2 * frequencies)); }
};

/// A frequency on the border belongs to the octave above, whatever the last digit; the last of the band to that below.
int OctaveAt(double frequency_Hz, const FrequencyBand& band) {
  constexpr double kRounding = 1e-6;
  const bool is_last = frequency_Hz >= band.upper_Hz * (1 - kRounding);
  return static_cast<int>(std::floor(std::log2(frequency_Hz * (1 + (is_last ? -2 : 1) * kRounding))));
}

std::map<int, OctaveSquares> ByOctave(const MeasuredRun& run, const MeasuredChannel& channel,
                                      const FrequencyResponse& modelled, const ModelError& model_error,
                                      const FrequencyBand& band) {
  std::map<int, OctaveSquares> octaves;
  for (std::size_t i = 0; i < channel.response.size(); ++i) {
    const double square = SquaredDeviation(run, channel, modelled, model_error, i);
    if (!std::isfinite(square)) continue;
    OctaveSquares& octave = octaves[OctaveAt(run.excitation.frequency_Hz[i], band)];
    octave.squares += square;
    ++octave.frequencies;
  }
  return octaves;
}

}  // namespace

std::optional<WorstOctave> WorstOctaveOf(const std::string& channel, const std::vector<MeasuredRun>& runs,
                                         const std::vector<FrequencyResponse>& modelled, const ModelError& model_error,
                                         const FrequencyBand& band) {
  constexpr int kEnough = 3;
  std::optional<WorstOctave> worst;
  bool has_enough = false;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (const MeasuredChannel& measured : runs[r].channels) {
      if (measured.name != channel) continue;
      for (const auto& [octave, sums] : ByOctave(runs[r], measured, modelled[r], model_error, band)) {
        const bool is_enough = sums.frequencies >= kEnough;
        const bool is_worse = !worst || sums.Misfit() > worst->misfit;
        if (is_enough == has_enough ? !is_worse : has_enough) continue;
        has_enough = is_enough;
        worst = {runs[r].name, std::max(std::exp2(octave), band.lower_Hz),
                 std::min(std::exp2(octave + 1), band.upper_Hz), sums.Misfit()};
      }
    }
  return worst;
}

}  // namespace fourpost
