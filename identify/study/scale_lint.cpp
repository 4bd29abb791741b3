#include "identify/study/scale_lint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/text/units.h"
#include "identify/study/findings.h"

namespace fourpost {
namespace {

bool HasMass(const Parameter& parameter) { return parameter.dimension.kilogram != 0; }

/// Any of its data or priors has it.
bool HasScale(const LoadedStudy& study) {
  const Experiments& experiments = study.study.experiments;
  return std::any_of(experiments.begin(), experiments.end(),
                     [](const Experiment& experiment) { return experiment.MeasuresForce(); }) ||
         std::any_of(study.free.begin(), study.free.end(), [&](std::size_t index) {
           const Parameter& parameter = study.vehicle.parameters[index];
           return parameter.prior_sd && HasMass(parameter);
         });
}

/// Places in Vehicle::parameters of what a common factor of the free ones rests on, as far as parameters hold it.
std::vector<std::size_t> HeldOf(const LoadedStudy& study) {
  std::vector<std::size_t> held;
  for (std::size_t i = 0; i < study.vehicle.parameters.size(); ++i) {
    const bool is_free = std::find(study.free.begin(), study.free.end(), i) != study.free.end();
    if (!is_free && HasMass(study.vehicle.parameters[i])) held.push_back(i);
  }
  return held;
}

/// How the residuals change where parameters are scaled.
class ScaleEffect {
 public:
  explicit ScaleEffect(const LoadedStudy& study) : values_(study.vehicle.ParameterValues()) {
    const Subject subject = study.MakeSubject();
    for (const Experiment& experiment : study.study.experiments)
      if (std::optional<ResidualBlock> block = experiment.UnpreparedResiduals(subject))
        blocks_.push_back(*std::move(block));
    here_ = Residuals(values_);
  }

  /// Nothing where the model cannot be evaluated.
  std::optional<Eigen::VectorXd> Of(const std::vector<std::size_t>& parameters) const {
    std::vector<double> values = values_;
    for (const std::size_t i : parameters) values[i] *= 1 + kStep;
    const std::optional<Eigen::VectorXd> there = Residuals(values);
    if (!here_ || !there) return std::nullopt;
    return (*there - *here_) / kStep;
  }

 private:
  static constexpr double kStep = 0.01;

  std::optional<Eigen::VectorXd> Residuals(const std::vector<double>& values) const {
    std::vector<double> all;
    try {
      for (const ResidualBlock& block : blocks_) {
        const Evaluation part = block.evaluate(values, {});
        if (!part.ok() || !part.residuals.allFinite()) return std::nullopt;
        all.insert(all.end(), part.residuals.begin(), part.residuals.end());
      }
    } catch (const std::runtime_error&) {
      return std::nullopt;
    }
    return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
  }

  std::vector<double> values_;
  std::vector<ResidualBlock> blocks_;
  std::optional<Eigen::VectorXd> here_;
};

/// Places of the held parameters, the one that sets the scale most first, without those of negligible effect: what a
/// change of each takes of the free ones' common factor to make up for it. All of them where the model cannot be
/// evaluated.
std::vector<std::size_t> SettingTheScale(const LoadedStudy& study) {
  constexpr double kLeast = 0.01;
  std::vector<std::size_t> scaled;
  for (const std::size_t index : study.free)
    if (HasMass(study.vehicle.parameters[index])) scaled.push_back(index);
  const ScaleEffect effect(study);
  const std::optional<Eigen::VectorXd> of_free = effect.Of(scaled);
  std::vector<std::pair<double, std::size_t>> weights;
  for (const std::size_t index : HeldOf(study)) {
    const std::optional<Eigen::VectorXd> of_this = effect.Of({index});
    const double weight = of_free && of_this ? std::abs(of_free->dot(*of_this)) / of_free->squaredNorm()
                                             : std::numeric_limits<double>::infinity();
    // Also where nothing changes with the free ones.
    if (!(weight < kLeast)) weights.emplace_back(weight, index);
  }
  std::stable_sort(weights.begin(), weights.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::size_t> places;
  for (const auto& [weight, index] : weights) places.push_back(index);
  return places;
}

/// "m_wheel, I_body and 3 more"; empty for none.
std::string Listed(const Vehicle& vehicle, const std::vector<std::size_t>& places) {
  constexpr std::size_t kMost = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, places.size()); ++i)
    text += (i == 0 ? "" : ", ") + vehicle.parameters[places[i]].name;
  return places.size() > kMost ? text + " and " + std::to_string(places.size() - kMost) + " more" : text;
}

/// Whether intervals allow for all of it, see HeldParameters.
bool HaveRanges(const Vehicle& vehicle, const std::vector<std::size_t>& places) {
  return !places.empty() && std::all_of(places.begin(), places.end(), [&](std::size_t place) {
    const Parameter& held = vehicle.parameters[place];
    return held.lower < held.upper && held.lower <= held.value && held.value <= held.upper;
  });
}

}  // namespace

void LintScale(const LoadedStudy& study, Diagnostics& diagnostics) {
  const bool is_scaled = std::any_of(study.free.begin(), study.free.end(),
                                     [&](std::size_t index) { return HasMass(study.vehicle.parameters[index]); });
  if (!is_scaled || HasScale(study)) return;
  const std::vector<std::size_t> held = SettingTheScale(study);
  diagnostics.Report(kScaleNotMeasured, {study.study.file.string(), study.study.free_line},
                     {held.empty() ? "numbers of the vehicle file, if any" : Listed(study.vehicle, held),
                      HaveRanges(study.vehicle, held) ? "and intervals are as wide as its range or 'prior_sd' says"
                                                      : "which no standard deviation includes"});
}

}  // namespace fourpost
