#pragma once

#include <optional>
#include <vector>

#include "analysis/files/tdms/tdms_segment.h"

namespace fourpost {

/// How raw values become those of a channel, by its properties NI_Scale[n]_*: scales one behind the other, linear ones
/// and polynomials.
class TdmsScaling {
 public:
  /// Nothing for a scale of another type.
  static std::optional<TdmsScaling> Of(const TdmsProperties& properties);

  void Apply(std::vector<double>& values) const;

 private:
  /// Coefficients by rising powers.
  std::vector<std::vector<double>> polynomials_;
};

/// 0 and "" where there is none, or of another type.
double NumberOf(const TdmsProperties& properties, const std::string& name);
std::string TextOf(const TdmsProperties& properties, const std::string& name);

}  // namespace fourpost
