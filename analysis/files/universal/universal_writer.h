#pragma once

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "analysis/files/recording/recording.h"

namespace fourpost {

/// A universal file with data set 151 and a binary data set 58b of double precision (IEEE 754, little endian) per
/// channel, which reads back bit for bit; channels may have rates or times of their own. Start and step have the five
/// decimals that the format gives them: samples whose step needs more are written with their times. Throws
/// std::invalid_argument without channels, for a channel without values or without times.
std::string UniversalBytes(const Recording& recording);

/// A channel's response to a reference, as values in `unit` per unit of the reference.
struct UniversalResponse {
  std::string name;
  std::string unit;
  std::vector<std::complex<double>> values;
};

/// The same of frequency responses at these frequencies, whose reference is the displacement of `reference` in m.
/// Throws std::invalid_argument without responses, and for one of another length than the frequencies.
std::string UniversalBytes(std::span<const double> frequency_Hz, const std::string& reference,
                           std::span<const UniversalResponse> responses);

}  // namespace fourpost
