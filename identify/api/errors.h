#pragma once

#include <string>
#include <vector>

#include <fourpost/diagnostics.h>

#include "analysis/files/output_folder.h"
#include "analysis/text/diagnostics.h"
#include "vehicles/multibody/simulation_error.h"

namespace fourpost::api {

std::vector<Finding> FindingsOf(const Diagnostics& diagnostics);

/// Throws Error of kInput for a name that is none of `known`; `noun`: "sensor".
[[noreturn]] void RefuseName(const std::string& noun, const std::string& name, const std::vector<std::string>& known);

/// Calls; what the library's own code throws becomes an Error.
template <typename Call>
auto Guarded(const Call& call) {
  try {
    return call();
  } catch (const FaultyInput& error) {
    throw Error(Error::Kind::kInput, error.what(), FindingsOf(error.diagnostics()));
  } catch (const OutputError& error) {
    throw Error(Error::Kind::kOutput, error.what(), FindingsOf(error.diagnostics()));
  } catch (const SimulationError& error) {
    throw Error(Error::Kind::kSimulation, error.what(), {});
  }
}

}  // namespace fourpost::api
