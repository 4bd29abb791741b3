#include "identify/run/run_draws.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/text/text_table.h"
#include "identify/fit/first_order_step.h"
#include "identify/refine/fit_variables.h"
#include "identify/run/findings.h"
#include "identify/run/run_spread.h"
#include "identify/run/study_fit.h"
#include "identify/study/loaded_study.h"

namespace fourpost {
namespace {

using Eigen::Index;

/// Of all parameters; those that are not judged stay at their fitted values.
Eigen::VectorXd ValuesAt(const ParameterSpread& parameters, const Eigen::VectorXd& judged) {
  const FitVariables variables(parameters.lattice);
  Eigen::VectorXd x = variables.FromValues(parameters.values);
  x(parameters.judged) = judged;
  Eigen::VectorXd values = parameters.values;
  values(parameters.judged) = variables.ToValues(x)(parameters.judged);
  return values;
}

/// The fitted study again: what its cost is, and how it rises.
class FittedCost {
 public:
  /// Throws FaultyInput where the study does not belong to the run.
  FittedCost(const DrawRequest& request, const RunSpread& run, const WorkHooks& hooks)
      : run_(run),
        variables_(run.parameters.lattice),
        loaded_(LoadSoundStudy(request.study)),
        objective_(Corrected(hooks)),
        options_(FitOptionsOf(loaded_.study, objective_).refine),
        archive_(objective_.MakeProblem(), request.threads) {
    archive_.TellProgress([this, &hooks](std::int64_t of_batch) {
      hooks.Show("draws: " + std::to_string(archive_.counts().paid + of_batch) + " evaluations");
    });
    if (hooks.stop) archive_.StopBatches(hooks.stop);
    // As the fit, which ended by residuals of an exact integration.
    RefineResult ended{.values = run_.parameters.values,
                       .residuals = archive_.EvaluateValues({run_.parameters.values}).front().residuals};
    if (ended.residuals.size() > 0)
      if (const std::optional<Eigen::VectorXd> finer = FinerResiduals(objective_, ended))
        archive_.ShiftResiduals(*finer - ended.residuals);
    RequireCost(request.study);
  }

  std::int64_t evaluations() const { return archive_.counts().paid; }

  std::vector<double> Costs(const std::vector<Eigen::VectorXd>& judged) {
    std::vector<Eigen::VectorXd> batch;
    for (const Eigen::VectorXd& x : judged) batch.push_back(ValuesAt(run_.parameters, x));
    std::vector<double> costs;
    for (const Evaluation& evaluation : archive_.EvaluateValues(batch))
      costs.push_back(evaluation.ok() ? options_.loss.Cost(evaluation.residuals) : std::nan(""));
    return costs;
  }

  /// Nothing where the model has no derivatives.
  std::optional<PosteriorOptimum> OptimumAt(const Eigen::VectorXd& values, bool is_corrected) {
    const Eigen::VectorXd x = variables_.FromValues(values);
    const Evaluation here = archive_.EvaluateValues({values}).front();
    if (!here.ok()) return std::nullopt;
    const std::optional<Eigen::MatrixXd> all = DifferenceJacobian(
        archive_, variables_, x, here.residuals, options_.DifferenceStep(archive_.problem()), Differences::kAutomatic);
    if (!all) return std::nullopt;
    const Eigen::MatrixXd jacobian = (*all)(Eigen::all, run_.parameters.judged);
    PosteriorOptimum optimum{.centre = x(run_.parameters.judged), .cost = options_.loss.Cost(here.residuals)};
    optimum.hessian = jacobian.transpose() * options_.loss.Curvatures(here.residuals).asDiagonal() * jacobian;
    const Eigen::VectorXd pulls = options_.loss.Weights(here.residuals).cwiseProduct(here.residuals);
    optimum.slope = Eigen::VectorXd::Zero(jacobian.cols());
    if (is_corrected) optimum.slope = 2 * jacobian.transpose() * pulls;
    return optimum;
  }

 private:
  /// As the fit ended, with what the full geometry adds.
  VehicleObjective Corrected(const WorkHooks& hooks) {
    RequireParameters();
    loaded_.Prepare(hooks);
    if (!loaded_.CorrectAt(run_.parameters.values, hooks)) throw BatchStopped();
    return loaded_.MakeObjective();
  }

  void RequireParameters() const {
    const std::vector<LatticeAxis>& axes = run_.parameters.lattice.axes();
    bool are_same = loaded_.free.size() == axes.size();
    for (std::size_t i = 0; are_same && i < axes.size(); ++i)
      are_same = loaded_.vehicle.parameters[loaded_.free[i]].name == axes[i].name;
    if (!are_same) Refuse(kDrawsOtherParameters, {loaded_.study.file.string()});
  }

  void RequireCost(const std::filesystem::path& study) {
    constexpr double kDifference = 0.01;
    const Evaluation here = archive_.EvaluateValues({run_.parameters.values}).front();
    const double cost = here.ok() ? options_.loss.Cost(here.residuals) : std::nan("");
    if (!(std::abs(cost - run_.cost) <= kDifference * run_.cost + 1e-9))
      Refuse(kDrawsOtherCost, {study.string()}, {Rounded(cost, 6), Rounded(run_.cost, 6)});
  }

  const RunSpread& run_;
  FitVariables variables_;
  LoadedStudy loaded_;
  VehicleObjective objective_;
  RefineOptions options_;
  Archive archive_;
};

/// Shares of normal distributions that ranges cut off, where they are not small.
std::string CutOff(const RunSpread& run, const Eigen::MatrixXd& covariance) {
  constexpr double kSmall = 0.1;
  const FitVariables variables(run.parameters.lattice);
  const Eigen::VectorXd x = variables.FromValues(run.parameters.values);
  const auto below = [](double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; };
  std::string text;
  for (std::size_t i = 0; i < run.parameters.judged.size(); ++i) {
    const Index j = run.parameters.judged[i];
    const double sd = std::sqrt(covariance(static_cast<Index>(i), static_cast<Index>(i)));
    const double cut = below((variables.lower()[j] - x[j]) / sd) + below((x[j] - variables.upper()[j]) / sd);
    if (cut < kSmall) continue;
    text += (text.empty() ? "" : ", ") + run.parameters.lattice.axes()[static_cast<std::size_t>(j)].name + " " +
            Rounded(100 * cut, 2) + " %";
  }
  return text;
}

class RunDrawer {
 public:
  RunDrawer(const DrawRequest& request, const WorkHooks& hooks)
      : request_(request),
        hooks_(hooks),
        run_(ReadRunSpread(request.run)),
        variables_(run_.parameters.lattice),
        covariance_(request.noise_only ? run_.parameters.noise : run_.parameters.AboutMoved()) {}

  RunDraws Run() {
    if (request_.noise_only && request_.study.empty()) Refuse(kDrawsWithoutStudy, Place::Option("--noise-only"));
    const std::vector<EndedStart> others =
        OtherOptima(run_.others, run_.parameters, run_.cost, run_.inflation, covariance_);
    if (!others.empty() && request_.study.empty())
      draws_.findings.Report(
          kOptimaLeftOut, {request_.run.string()},
          {others.size() == 1 ? "another optimum is" : std::to_string(others.size()) + " more optima are"});
    std::optional<FittedCost> cost;
    if (request_.noise_only || (!others.empty() && !request_.study.empty())) cost.emplace(request_, run_, hooks_);
    const std::vector<PosteriorOptimum> optima = Optima(others, cost);
    const std::vector<Index>& judged = run_.parameters.judged;
    const Posterior posterior(optima, covariance_, variables_.lower()(judged), variables_.upper()(judged));
    PosteriorDrawOptions options = {.count = request_.count,
                                    .seed = request_.seed,
                                    .max_evaluations = request_.max_evaluations,
                                    .stop = hooks_.stop};
    if (!request_.noise_only) options.moved = run_.parameters.moved;
    const auto costs_of = [&](const std::vector<Eigen::VectorXd>& points) { return cost->Costs(points); };
    const PosteriorDraws draws =
        request_.noise_only ? DrawByCost(posterior, costs_of, options) : DrawNormals(posterior, options);
    Describe(optima, posterior, draws);
    if (cost) draws_.evaluations = cost->evaluations();
    FindLimits(draws);
    return std::move(draws_);
  }

 private:
  std::vector<PosteriorOptimum> Optima(const std::vector<EndedStart>& others, std::optional<FittedCost>& cost) const {
    const Eigen::VectorXd x = variables_.FromValues(run_.parameters.values);
    if (!cost) return {{.centre = x(run_.parameters.judged), .cost = run_.cost, .hessian = {}, .slope = {}}};
    std::vector<PosteriorOptimum> optima;
    if (auto best = cost->OptimumAt(run_.parameters.values, run_.is_corrected)) optima.push_back(*std::move(best));
    else Refuse(kDrawsWithoutDerivatives, {request_.study.string()});
    for (const EndedStart& other : others)
      if (auto optimum = cost->OptimumAt(other.values, false)) optima.push_back(*std::move(optimum));
    return optima;
  }

  void Describe(const std::vector<PosteriorOptimum>& optima, const Posterior& posterior, const PosteriorDraws& draws) {
    const std::vector<LatticeAxis>& axes = run_.parameters.lattice.axes();
    for (const LatticeAxis& axis : axes) draws_.names.push_back(axis.name);
    draws_.units = run_.units;
    draws_.fitted = run_.parameters.values;
    draws_.confidence = run_.confidence;
    draws_.method = draws.method;
    draws_.effective = draws.effective;
    draws_.generations = draws.generations;
    draws_.accepted = draws.accepted;
    draws_.remembered = draws.remembered;
    draws_.values.resize(static_cast<Index>(draws.points.size()), run_.parameters.values.size());
    for (std::size_t i = 0; i < draws.points.size(); ++i)
      draws_.values.row(static_cast<Index>(i)) = ValuesAt(run_.parameters, draws.points[i]).transpose();
    for (std::size_t k = 0; k < optima.size(); ++k)
      draws_.optima.push_back({optima[k].cost, posterior.shares()[k], ValuesAt(run_.parameters, optima[k].centre)});
    draws_.held = run_.Held();
  }

  void FindLimits(const PosteriorDraws& draws) {
    const Place place{request_.run.string()};
    Diagnostics& findings = draws_.findings;
    if (!draws_.held.empty()) findings.Report(kDrawsHeld, place, {run_.HeldText()});
    if (const std::string cut = CutOff(run_, covariance_); !cut.empty()) findings.Report(kDrawsCutOff, place, {cut});
    if (draws.method != DrawMethod::kEnsemble) return;
    findings.Report(kDrawsNotNormal, place, {std::to_string(request_.count), Rounded(draws.effective, 2)});
    if (draws.remembered > kMostRemembered)
      findings.Report(kDrawsNotMixed, Place::Option("--evaluations"),
                      {std::to_string(draws.generations), Rounded(draws.remembered, 2)});
  }

  const DrawRequest& request_;
  const WorkHooks& hooks_;
  RunSpread run_;
  FitVariables variables_;
  Eigen::MatrixXd covariance_;
  RunDraws draws_;
};

}  // namespace

std::optional<RunDraws> DrawFromRun(const DrawRequest& request, const WorkHooks& hooks) {
  try {
    return RunDrawer(request, hooks).Run();
  } catch (const BatchStopped&) {
    return std::nullopt;
  }
}

}  // namespace fourpost
