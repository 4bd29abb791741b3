#include "identify/experiments/known_answers.h"

namespace fourpost {
namespace {

bool IsSame(const Excitation& a, const Excitation& b) {
  return a.frequency_Hz == b.frequency_Hz && a.amplitude_m == b.amplitude_m && a.shape == b.shape;
}

}  // namespace

const PeriodicResponse* KnownAnswers::Find(const Excitation& excitation) {
  const std::lock_guard lock(mutex_);
  for (const auto& [asked, answer] : answers_)
    if (IsSame(asked, excitation)) return &answer;
  return nullptr;
}

PeriodicResponse KnownAnswers::Of(const std::vector<double>& values, const Excitation& excitation,
                                  const std::function<PeriodicResponse()>& solve) {
  if (values != values_) return solve();
  if (const PeriodicResponse* known = Find(excitation)) return *known;
  // Two threads may solve the same, and find the same.
  PeriodicResponse answer = solve();
  const std::lock_guard lock(mutex_);
  answers_.emplace_back(excitation, answer);
  return answer;
}

}  // namespace fourpost
