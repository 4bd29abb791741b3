#pragma once

#include <functional>
#include <list>
#include <mutex>
#include <utility>
#include <vector>

#include "vehicles/response/excitation.h"
#include "vehicles/response/harmonic_balance.h"

namespace fourpost {

/// What one vehicle at one set of values answers to stepped sines, for studies that differ in their channels alone. May
/// be shared by threads.
class KnownAnswers {
 public:
  /// `values`: of all parameters of the vehicle, SI.
  explicit KnownAnswers(std::vector<double> values) : values_(std::move(values)) {}

  /// `solve` where it is not known, or where other values are asked for, of which nothing is kept.
  PeriodicResponse Of(const std::vector<double>& values, const Excitation& excitation,
                      const std::function<PeriodicResponse()>& solve);

 private:
  const PeriodicResponse* Find(const Excitation& excitation);

  std::vector<double> values_;
  std::mutex mutex_;
  /// A list, since others are added while one is read.
  std::list<std::pair<Excitation, PeriodicResponse>> answers_;
};

}  // namespace fourpost
