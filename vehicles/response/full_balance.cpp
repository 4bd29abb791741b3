#include "vehicles/response/full_balance.h"

#include "analysis/text/count_check.h"
#include "analysis/text/option_check.h"
#include "vehicles/response/full_cycle.h"
#include "vehicles/response/response_recorder.h"

namespace fourpost {
namespace {

void CheckFit(const Vehicle& vehicle, const CondensedModel& model, const Excitation& excitation) {
  excitation.Validate(vehicle.posts.size());
  const auto count = [](Eigen::Index n) { return static_cast<std::size_t>(n); };
  RequireCount("SolveFullBalance: model", "posts", vehicle.posts.size(), count(model.post_stiffness.cols()));
  RequireCount("SolveFullBalance: model", "sensors", vehicle.sensors.size(), count(model.on_position.rows()));
}

/// Leaves the posts at rest, also after an exception.
struct PostsAtRestAfterwards {
  Multibody& multibody;
  ~PostsAtRestAfterwards() { multibody.SetPostMotion(nullptr); }
};

}  // namespace

void FullBalanceOptions::Validate() const {
  RequireOption(harmonics >= 2, "harmonics", harmonics, "at least 2");
  RequireOption(samples % 4 == 0 && samples > 2 * harmonics, "samples", samples,
                "a multiple of 4 and more than twice the harmonics");
  RequireOption(fine_samples % 8 == 0 && fine_samples > 2 * fine_harmonics, "fine_samples", fine_samples,
                "a multiple of 8 and more than twice fine_harmonics");
  RequireOption(tolerance > 0, "tolerance", tolerance, "positive");
  RequireOption(max_iterations >= 1, "max_iterations", max_iterations, "at least 1");
  RequireOption(history >= 0, "history", history, "at least 0");
}

PeriodicResponse SolveFullBalance(Multibody& multibody, const CondensedModel& model, const Excitation& excitation,
                                  const FullBalanceOptions& options,
                                  const std::function<void(std::size_t done)>& progress) {
  options.Validate();
  const Vehicle& vehicle = multibody.vehicle();
  CheckFit(vehicle, model, excitation);
  const PostsAtRestAfterwards at_rest{multibody};
  FullCycle cycle(multibody, model, excitation.shape, options);
  ResponseRecorder recorder(vehicle.sensors, excitation);
  PeriodicResponse out;
  for (std::size_t i = 0; i < excitation.frequency_Hz.size(); ++i) {
    if (progress) progress(i);
    if (!cycle.Solve(excitation.frequency_Hz[i], excitation.amplitude_m[i]))
      out.unconverged_Hz.push_back(excitation.frequency_Hz[i]);
    recorder.Record(i, cycle.Sensors());
  }
  out.response = recorder.Take();
  return out;
}

}  // namespace fourpost
