#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "analysis/text/diagnostics.h"

namespace fourpost {

enum class CoveredQuantity { kBumpSpeed, kReboundSpeed, kSpringTravel, kTyreLoad, kPostFrequency, kPostAmplitude };

/// How far recordings took an element of the vehicle, SI.
struct CoveredRange {
  CoveredQuantity quantity = CoveredQuantity::kBumpSpeed;
  /// Damper, spring or tyre; "posts" of frequency and amplitude.
  std::string element;
  double lower = 0;
  double upper = 0;
};

/// Ranges that a fit has covered, or that a prediction needs: one per quantity and element.
class CoveredRanges {
 public:
  /// Widens what is there; numbers that are not finite are left out.
  void Add(CoveredQuantity quantity, const std::string& element, double lower, double upper);
  void Add(const CoveredRanges& others);

  const std::vector<CoveredRange>& all() const { return all_; }
  const CoveredRange* Find(CoveredQuantity quantity, const std::string& element) const;

 private:
  std::vector<CoveredRange> all_;
};

/// `covered` of result.json, and back; nothing of a run without it.
nlohmann::ordered_json CoveredJson(const CoveredRanges& ranges);
CoveredRanges ReadCovered(const std::filesystem::path& result);

/// Warns where a prediction leaves what the fit has covered, one finding per kind of quantity: speeds, frequencies and
/// amplitudes by more than a tenth of the end of the range, travels and loads by more than a tenth of the range.
/// Elements that the fit says nothing of are left out.
void WarnOfLeaving(const CoveredRanges& fit, const CoveredRanges& prediction, const Place& place,
                   Diagnostics& findings);

}  // namespace fourpost
