#pragma once

#include <complex>
#include <span>
#include <vector>

namespace fourpost {

/// A channel's response at one frequency, from a sweep or a random motion.
struct LocalChannel {
  /// Per unit of the reference.
  std::complex<double> response;
  /// Of it, real and imaginary part together.
  double variance = 0;
  /// Of reference and channel, next to this frequency: 1 where the channel follows linearly and without noise.
  double coherence = 0;
};

struct LocalResponse {
  double frequency_Hz = 0;
  /// Independent averages: complex spectral lines minus unknowns.
  double averages = 0;
  /// Of the reference, over its spectral density [unit^2/Hz], one-sided.
  double reference_density = 0;
  std::vector<LocalChannel> channels;
};

/// Responses of channels to a reference that moves in any way, at given frequencies, by the local polynomial method
/// (Pintelon and Schoukens, System Identification: A Frequency Domain Approach, 2nd ed., chapter 7): in the spectrum of
/// a segment, over lines r = -n..n about a frequency,
///   Y(r) = (H + h1 r + h2 r^2) X(r) + t0 + t1 r + t2 r^2 + noise,
/// where t, of each segment its own, is what a segment's ends leak, which Welch's windows only dampen, and H, h1, h2
/// are common to all segments. Solved by least squares; the variance follows from what is left. H is the estimator H1:
/// noise of the channel does no harm. That of the reference, as NoiseFloor() finds it, is subtracted from the
/// reference's own spectrum, where it would lower H. H2 = H / coherence, Hv = H / sqrt(coherence).
///
/// Lines are six on both sides at least, and all within 2.5 % of the frequency. Segments have 240 periods of it, cut to
/// the record, and one length from one to four hertz, four to sixteen and so on. Channels have the reference's length.
/// Throws std::invalid_argument for fewer than 64 samples, and for frequencies at which 13 lines do not fit below half
/// the rate.
std::vector<LocalResponse> LocalResponses(std::span<const double> reference,
                                          std::span<const std::span<const double>> channels, double rate_Hz,
                                          std::span<const double> frequencies_Hz);

}  // namespace fourpost
