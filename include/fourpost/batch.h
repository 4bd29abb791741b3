#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <fourpost/response.h>
#include <fourpost/vehicle.h>

namespace fourpost::api {

/// Values of some parameters, one car a row; all others have the vehicle's.
struct ParameterTable {
  std::vector<std::string> parameters;
  /// SI; a column for each of `parameters`.
  Eigen::MatrixXd values;
};

/// The response of a row, or why it has none.
struct RowResponse {
  std::optional<Response> response;
  std::string why;
};

struct BatchOptions {
  /// kReduced takes the geometry of the vehicle once for all rows.
  Engine engine = Engine::kReduced;
  /// 0: one per processor. No influence on the result.
  int threads = 0;
  /// True leaves the rest of the rows without a response; asked often, from several threads at once.
  std::function<bool()> stop = {};
};

/// The steady responses of many cars, one per row: those of Respond() at these values, to the last bit. Throws Error of
/// kInput for names, values and an excitation that cannot be used; a row whose car has no response says so alone.
std::vector<RowResponse> RespondAt(const Vehicle& vehicle, const ParameterTable& table, const SteppedSine& excitation,
                                   const BatchOptions& options = {});

}  // namespace fourpost::api
