#include <fourpost/response.h>

#include <algorithm>

#include "analysis/text/units.h"
#include "identify/api/engine_names.h"
#include "identify/api/errors.h"
#include "identify/api/findings.h"
#include "identify/api/inside.h"
#include "identify/api/responses.h"
#include "identify/search/parallel.h"
#include "vehicles/condensed/condensed_vehicle.h"
#include "vehicles/requests/findings.h"
#include "vehicles/requests/parameter_setting.h"
#include "vehicles/requests/solve_sweep.h"
#include "vehicles/response/harmonic_balance.h"
#include "vehicles/response/hysteresis.h"
#include "vehicles/ride/stability.h"

namespace fourpost::api {
namespace {

/// Places in Vehicle::parameters. Throws FaultyInput.
std::vector<std::size_t> ColumnsOf(const fourpost::Vehicle& vehicle, const ParameterTable& table) {
  std::vector<std::string> known;
  for (const fourpost::Parameter& parameter : vehicle.parameters) known.push_back(parameter.name);
  std::vector<std::size_t> columns;
  for (const std::string& name : table.parameters) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) RefuseName("parameter", name, known);
    columns.push_back(static_cast<std::size_t>(found - known.begin()));
  }
  if (static_cast<std::size_t>(table.values.cols()) != columns.size())
    Refuse(kTableShape, {}, {std::to_string(table.values.cols()), std::to_string(columns.size())});
  RequireFinite("the table of values", {table.values.data(), static_cast<std::size_t>(table.values.size())});
  return columns;
}

/// The responses of rows, each by whichever thread is free.
class BatchSolver {
 public:
  BatchSolver(const fourpost::Vehicle& vehicle, const ParameterTable& table, const Excitation& excitation,
              const BatchOptions& options)
      : vehicle_(vehicle),
        table_(table),
        columns_(ColumnsOf(vehicle, table)),
        excitation_(excitation),
        options_(options) {
    if (options.engine == Engine::kReduced && table.values.rows() > 0) reduced_.emplace(vehicle);
  }

  RowResponse Row(Eigen::Index row) const {
    try {
      fourpost::Vehicle car = vehicle_;
      SetRow(row, car);
      if (reduced_)
        if (std::optional<Response> response = Balanced(car)) return {.response = std::move(response), .why = {}};
      return {.response = Solved(car), .why = {}};
    } catch (const FaultyInput& fault) {
      return {.response = {}, .why = fault.what()};
    } catch (const SimulationError& failure) {
      return {.response = {}, .why = failure.what()};
    } catch (const std::invalid_argument& values) {  // that do not go together
      return {.response = {}, .why = values.what()};
    }
  }

 private:
  /// As Vehicle::Set() refuses values.
  void SetRow(Eigen::Index row, fourpost::Vehicle& car) const {
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      fourpost::Parameter& parameter = car.parameters[columns_[c]];
      const double value = table_.values(row, static_cast<Eigen::Index>(c));
      if (const std::string side = MissedSideOfZero(parameter, value); !side.empty())
        Refuse(kSettingSign, {}, {parameter.name, FormatQuantity(value, parameter.unit), side});
      parameter.value = value;
    }
  }

  /// What SteadySolver answers where the balance is all that it needs; nothing elsewhere.
  std::optional<Response> Balanced(const fourpost::Vehicle& car) const {
    const CondensedModel model = reduced_->At(car.ParameterValues());
    if (HasHysteresis(model)) return std::nullopt;
    if (const std::optional<Growth> growth = GrowthOf(car, model)) Refuse(kUnstable, {car.file}, {growth->Text()});
    const PeriodicResponse found = SolveHarmonicBalance(model, car.sensors, excitation_);
    if (!found.unconverged_Hz.empty()) return std::nullopt;
    return ResponseOf(found.response, fourpost::Engine::kReduced);
  }

  Response Solved(const fourpost::Vehicle& car) const {
    SteadySolver solver(car);
    RequireStable(car, solver);
    const std::optional<SteadyResponse> answer =
        SolveSweep(solver, "posts", excitation_, OwnEngine(options_.engine), {}, {.stop = options_.stop});
    if (!answer) throw SimulationError(kCallStopped);
    return ResponseOf(*answer);
  }

  const fourpost::Vehicle& vehicle_;
  const ParameterTable& table_;
  std::vector<std::size_t> columns_;
  const Excitation& excitation_;
  const BatchOptions& options_;
  std::optional<CondensedVehicle> reduced_;
};

}  // namespace

std::vector<RowResponse> RespondAt(const Vehicle& vehicle, const ParameterTable& table, const SteppedSine& excitation,
                                   const BatchOptions& options) {
  return Guarded([&] {
    const fourpost::Vehicle& own = Inside::Of(vehicle);
    const Excitation posts = ExcitationOf(own, excitation);
    posts.Validate(own.posts.size());
    const BatchSolver solver(own, table, posts, options);
    std::vector<RowResponse> rows(static_cast<std::size_t>(table.values.rows()));
    ForEachInParallel(rows.size(), ThreadCount(options.threads), [&](std::size_t i) {
      if (options.stop && options.stop()) rows[i].why = Found{&kCallStopped}.Text();
      else rows[i] = solver.Row(static_cast<Eigen::Index>(i));
    });
    return rows;
  });
}

}  // namespace fourpost::api
