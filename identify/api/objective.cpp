#include <fourpost/objective.h>

#include <cstdlib>
#include <limits>
#include <system_error>

#include "analysis/files/output_folder.h"
#include "identify/api/errors.h"
#include "identify/api/findings.h"
#include "identify/refine/difference_jacobian.h"
#include "identify/residuals/vehicle_objective.h"
#include "identify/run/study_fit.h"
#include "identify/search/archive.h"
#include "identify/study/loaded_study.h"

namespace fourpost::api {
namespace {

/// A folder that is there as long as the object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code failure;
    std::string name = (std::filesystem::temp_directory_path(failure) / "fourpost-XXXXXX").string();
    if (failure || mkdtemp(name.data()) == nullptr)
      throw OutputError("no temporary folder can be created: set TMPDIR to one that can be written to");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code failure;
    std::filesystem::remove_all(path_, failure);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// All that it needs of its files it has read afterwards.
LoadedStudy LoadedFrom(const Study& study) {
  if (study.file()) return LoadSoundStudy(study.Write({}));
  const ScratchFolder folder;
  return LoadSoundStudy(study.Write(folder.path() / kInputsFolder));
}

std::vector<Eigen::VectorXd> RowsOf(const Eigen::MatrixXd& values) {
  std::vector<Eigen::VectorXd> rows;
  for (Eigen::Index i = 0; i < values.rows(); ++i) rows.emplace_back(values.row(i).transpose());
  return rows;
}

}  // namespace

struct Objective::Inner {
  explicit Inner(LoadedStudy study)
      : loaded(Prepared(std::move(study))),
        objective(loaded.MakeObjective()),
        problem(objective.MakeProblem()),
        refine(FitOptionsOf(loaded.study, objective).refine) {
    problem.deadline_s = loaded.study.search.deadline_s;
  }

  static LoadedStudy Prepared(LoadedStudy study) {
    study.Prepare();
    return study;
  }

  void RequireColumns(Eigen::Index count) const {
    if (static_cast<std::size_t>(count) != loaded.free.size())
      Refuse(kTableShape, {}, {std::to_string(count), std::to_string(loaded.free.size())});
  }

  std::vector<Evaluation> EvaluateRows(const Eigen::MatrixXd& values, int threads,
                                       const std::function<bool()>& stop) const {
    RequireColumns(values.cols());
    RequireFinite("the table of values", {values.data(), static_cast<std::size_t>(values.size())});
    Archive archive(problem, threads);
    if (stop) archive.StopBatches(stop);
    try {
      return archive.EvaluateValues(RowsOf(values));
    } catch (const BatchStopped&) {
      throw SimulationError(kCallStopped);
    }
  }

  Evaluation EvaluateOne(const Eigen::VectorXd& values) const {
    Evaluation evaluation = EvaluateRows(values.transpose(), 1, {}).front();
    if (!evaluation.ok())
      throw SimulationError(kEvaluationFailed, {std::string(FailureName(evaluation.failure)) +
                                                (evaluation.detail.empty() ? "" : ": " + evaluation.detail)});
    return evaluation;
  }

  LoadedStudy loaded;
  VehicleObjective objective;
  /// Refers to `objective`.
  Problem problem;
  RefineOptions refine;
};

Objective::Objective(const Study& study)
    : inner_(Guarded([&] { return std::make_shared<const Inner>(LoadedFrom(study)); })) {}

std::vector<Parameter> Objective::parameters() const {
  std::vector<Parameter> parameters;
  for (const std::size_t index : inner_->loaded.free) {
    const fourpost::Parameter& one = inner_->loaded.vehicle.parameters[index];
    parameters.push_back({one.name, one.value, one.lower, one.upper, one.unit});
  }
  return parameters;
}

Eigen::Index Objective::residual_count() const { return inner_->objective.residual_count(); }

Eigen::VectorXd Objective::Residuals(const Eigen::VectorXd& values) const {
  return Guarded([&] { return inner_->EvaluateOne(values).residuals; });
}

Eigen::MatrixXd Objective::Jacobian(const Eigen::VectorXd& values, const std::function<bool()>& stop) const {
  return Guarded([&] {
    const Evaluation here = inner_->EvaluateOne(values);
    const FitVariables variables(inner_->problem.lattice);
    Eigen::VectorXd x;
    try {
      x = variables.FromValues(values);
    } catch (const std::invalid_argument& outside) {
      Refuse(kValueOutOfRange, {}, {outside.what()});
    }
    Archive archive(inner_->problem, 1);
    if (stop) archive.StopBatches(stop);
    std::optional<Eigen::MatrixXd> jacobian;
    try {
      jacobian = DifferenceJacobian(archive, variables, x, here.residuals,
                                    inner_->refine.DifferenceStep(inner_->problem), inner_->refine.differences);
    } catch (const BatchStopped&) {
      throw SimulationError(kCallStopped);
    }
    if (!jacobian) throw SimulationError(kEvaluationFailed, {"beside them"});
    return Eigen::MatrixXd(*jacobian * variables.Slopes(values).cwiseInverse().asDiagonal());
  });
}

Eigen::MatrixXd Objective::ResidualsAt(const Eigen::MatrixXd& values, int threads,
                                       const std::function<bool()>& stop) const {
  return Guarded([&] {
    const std::vector<Evaluation> rows = inner_->EvaluateRows(values, threads, stop);
    Eigen::MatrixXd residuals(values.rows(), residual_count());
    for (Eigen::Index i = 0; i < residuals.rows(); ++i) {
      const Evaluation& row = rows[static_cast<std::size_t>(i)];
      if (row.ok()) residuals.row(i) = row.residuals.transpose();
      else residuals.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return residuals;
  });
}

Eigen::VectorXd Objective::CostsAt(const Eigen::MatrixXd& values, int threads,
                                   const std::function<bool()>& stop) const {
  return Guarded([&] {
    const std::vector<Evaluation> rows = inner_->EvaluateRows(values, threads, stop);
    Eigen::VectorXd costs(values.rows());
    for (Eigen::Index i = 0; i < costs.size(); ++i) {
      const Evaluation& row = rows[static_cast<std::size_t>(i)];
      costs[i] = row.ok() ? inner_->refine.loss.Cost(row.residuals) : std::numeric_limits<double>::quiet_NaN();
    }
    return costs;
  });
}

}  // namespace fourpost::api
