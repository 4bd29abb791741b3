#pragma once

#include <span>
#include <stdexcept>
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

/// Throws Error of kSimulation.
[[noreturn]] void EndSimulation(const SimulationError& error);

/// Throws Error of kInput for a value that the library's own code refuses, in its words.
[[noreturn]] void RefuseArgument(const std::string& why);

/// Throws FaultyInput unless all numbers of `what` are finite.
void RequireFinite(const std::string& what, std::span<const double> numbers);

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
    EndSimulation(error);
  } catch (const std::invalid_argument& error) {
    RefuseArgument(error.what());
  }
}

}  // namespace fourpost::api
