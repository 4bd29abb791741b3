#pragma once

#include <span>
#include <vector>

namespace fourpost {

/// A signal without most of its white noise, so that its slope can be taken: the one that minimises the squared
/// distance from the samples plus a weight times its squared fourth differences (Whittaker 1923,
/// doi:10.1017/S0013091500077853). No delay. The weight is a tenth of the one by which each sample is predicted best
/// from all others: generalised cross-validation (Craven and Wahba 1979, doi:10.1007/BF01404567), which is best for the
/// signal and too much for its slope. Of the fastest motion in a sweep it takes less than two thousandths, for noise of
/// up to a twentieth of that motion. A signal comes back as it is where this finds no noise, where what it finds is
/// more than a tenth of the signal (motion at three samples a period), and if it has fewer than 64 samples.
std::vector<double> WithoutNoise(std::span<const double> signal);

}  // namespace fourpost
