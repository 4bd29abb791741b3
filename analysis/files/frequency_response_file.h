#pragma once

#include <filesystem>
#include <optional>

#include "analysis/signals/frequency_response.h"
#include "analysis/text/diagnostics.h"

namespace fourpost {

/// Reads a stepped sine from text or a MAT file, see RecordedTable: one row per frequency and channel, the frequencies
/// of a channel increasing; or the frequency responses of a universal file, see SteppedSineOf(). `amplitude_m` is that
/// of the reference post where the file has no column of it.
///
/// Columns: frequency_Hz, post_amplitude_m, channel, gain, phase_deg; and, if wanted, gain_sd, phase_sd_deg, mean,
/// mean_sd, second_harmonic, unit. The response is gain * exp(i phase) per metre of the reference post; of an
/// accelerometer it is per acceleration of that post, a pure number. `unit` is that of the channel, so of its mean and
/// second harmonic, and, but for accelerometers, of its gain times metres: a length, a force, an acceleration, or an
/// angular velocity in rad/s or deg/s. Without that column it is m/s^2 for names that begin with "a_", m for "s_" and N
/// for "F_". Everything is converted to SI, angular velocities to rad/s.
///
/// A blank or NaN stands for what was not measured: sd, mean and second harmonic may be blank, each for all rows of a
/// channel. Reports all of: what ReadRecordedTable reports, missing or unknown columns, a fit's response.csv, a gain,
/// phase, frequency or amplitude that is missing or not a number, any of them but the phase not above zero, a negative
/// sd or second harmonic, frequencies that do not increase, two amplitudes at one frequency, a channel missing or twice
/// at one frequency, a unit that is unknown, changes, or does not follow from the name. Nothing when there was one.
std::optional<FrequencyResponse> ReadFrequencyResponse(const std::filesystem::path& file, Diagnostics& diagnostics,
                                                       std::optional<double> amplitude_m = std::nullopt);

}  // namespace fourpost
