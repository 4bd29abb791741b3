#include "identify/suggest/augmented_study.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "analysis/process/deadline.h"
#include "vehicles/reader/vehicle_file.h"

namespace fourpost {

using Eigen::Index;

std::string FirstErrorOf(const Diagnostics& diagnostics) {
  for (const Diagnostic& item : diagnostics.items())
    if (item.severity == Severity::kError) return item.message;
  return "";
}

Vehicle WithValuesOf(const Vehicle& studied, Vehicle extended) {
  for (Parameter& parameter : extended.parameters)
    for (const Parameter& known : studied.parameters)
      if (known.name == parameter.name) parameter.value = known.value;
  return extended;
}

AugmentedStudy::AugmentedStudy(const LoadedStudy& study, const Addition& addition, bool integrates,
                               std::shared_ptr<KnownAnswers> answers)
    : study_(study), addition_(addition), answers_(std::move(answers)) {
  if (addition.study) return;
  vehicle_ = study.vehicle;
  if (!addition.vehicle.empty()) {
    Diagnostics findings;
    std::optional<Vehicle> vehicle = ReadVehicleText(addition.vehicle, study.vehicle.file, findings);
    if (!vehicle) throw FaultyInput(findings);
    vehicle_ = WithValuesOf(study.vehicle, *std::move(vehicle));
  }
  for (const std::size_t i : study.free) free_.push_back(PlaceOf(study.vehicle.parameters[i].name));
  for (const std::string& name : addition.parameters) {
    free_.push_back(PlaceOf(name));
    // A prior would add a residual; what the data say alone is the question.
    vehicle_.parameters[free_.back()].prior_sd.reset();
    vehicle_.parameters[free_.back()].like.reset();
  }
  Subject subject(vehicle_, free_, study.study.file, study.study.search.deadline_s);
  if (!integrates) subject.LeaveOutIntegration();
  std::vector<ResidualBlock> blocks;
  for (const Experiment& experiment : study.study.experiments)
    if (std::optional<ResidualBlock> block = experiment.Residuals(subject)) blocks.push_back(*std::move(block));
  // A damper on its bench has no equilibrium to condense the vehicle about.
  if (std::any_of(blocks.begin(), blocks.end(), [](const ResidualBlock& block) { return bool(block.toward); }))
    condensed_ = subject.Condensed();
  // Priors are those of the study: of new parameters nothing is known.
  objective_.emplace(vehicle_, free_, std::move(blocks));
}

std::optional<Eigen::VectorXd> AugmentedStudy::At(double amount, const Eigen::VectorXd& values) const {
  if (addition_.study) return OfStudy(amount, values);
  return With(Added(amount), values);
}

std::optional<OtherVehicle> AugmentedStudy::VehicleAt(double amount, const Eigen::VectorXd& values) const {
  if (!condensed_) return std::nullopt;
  return OtherVehicle{condensed_, objective_->AllParameters(Extended(Added(amount), values))};
}

Eigen::VectorXd AugmentedStudy::Added(double amount) const {
  const std::vector<double> added = addition_.values ? addition_.values(amount) : std::vector<double>();
  return Eigen::Map<const Eigen::VectorXd>(added.data(), std::ssize(added));
}

Eigen::VectorXd AugmentedStudy::Extended(const Eigen::VectorXd& added, const Eigen::VectorXd& values) {
  Eigen::VectorXd all(values.size() + added.size());
  all << values, added;
  return all;
}

std::optional<Eigen::VectorXd> AugmentedStudy::With(const Eigen::VectorXd& added, const Eigen::VectorXd& values) const {
  return Evaluated(*objective_, Extended(added, values));
}

FitVariables AugmentedStudy::AddedVariables() const { return FitVariables(Lattice(AddedAxes())); }

Eigen::VectorXd AugmentedStudy::AddedAt(double amount) const {
  const std::vector<LatticeAxis> axes = AddedAxes();
  Eigen::VectorXd within = Added(amount);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    double& value = within[static_cast<Index>(i)];
    value = std::clamp(value, axes[i].lower, axes[i].upper);
  }
  return within;
}

std::vector<LatticeAxis> AugmentedStudy::AddedAxes() const {
  const Problem problem = objective_->MakeProblem();
  const std::vector<LatticeAxis>& axes = problem.lattice.axes();
  return {axes.end() - std::ssize(addition_.parameters), axes.end()};
}

std::size_t AugmentedStudy::PlaceOf(const std::string& name) const {
  for (std::size_t i = 0; i < vehicle_.parameters.size(); ++i)
    if (vehicle_.parameters[i].name == name) return i;
  throw std::logic_error("AugmentedStudy: no parameter " + name);
}

std::optional<Eigen::VectorXd> AugmentedStudy::Evaluated(const VehicleObjective& objective,
                                                         const Eigen::VectorXd& values) const {
  try {
    const Evaluation evaluation = objective.Evaluate(values, Deadline::In(study_.study.search.deadline_s));
    if (evaluation.ok() && evaluation.residuals.allFinite()) return evaluation.residuals;
    failure_ = evaluation.ok() ? "residuals are not finite" : evaluation.detail;
  } catch (const TimedOut& late) {
    failure_ = late.what();
  } catch (const std::invalid_argument& unfit) {
    // Process noise is stated for each coordinate, and a part of its own has more.
    failure_ = unfit.what();
  }
  return std::nullopt;
}

std::optional<Eigen::VectorXd> AugmentedStudy::OfStudy(double amount, const Eigen::VectorXd& values) const {
  const std::string text = addition_.study(amount);
  if (text.empty()) {
    failure_ =
        "its channel is not listed under `channels`, or what is stated there cannot be extended: list it on one line, "
        "as in `a_body: {channel: NAME}`";
    return std::nullopt;
  }
  Diagnostics findings;
  std::optional<Study> study = ReadStudyText(text, study_.study.file, findings);
  if (!study) {
    failure_ = FirstErrorOf(findings);
    return std::nullopt;
  }
  LoadedStudy loaded{.study = *std::move(study), .vehicle = study_.vehicle, .free = study_.free};
  Subject subject = loaded.MakeSubject();
  subject.Remember(answers_);
  auto fitted = study_.study.experiments.begin();
  for (Experiment& experiment : loaded.study.experiments) {
    experiment.LeaveOutValidation();
    experiment.Load(subject, findings);
    experiment.CorrectAs(*fitted);
    ++fitted;
  }
  if (findings.HasErrors()) {
    failure_ = FirstErrorOf(findings);
    return std::nullopt;
  }
  loaded.Prepare();
  const VehicleObjective objective = loaded.MakeObjective(subject);
  structure_ = JoinedStructure(objective.blocks());
  return Evaluated(objective, values);
}

}  // namespace fourpost
