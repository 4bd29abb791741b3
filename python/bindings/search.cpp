#include <fourpost/search.h>

#include "python/bindings/bindings.h"
#include "python/bindings/calls.h"

namespace fourpost::python {
namespace {

/// Name, lower, upper, precision, whether discrete.
using Axis = std::tuple<std::string, double, double, double, bool>;

py::tuple Minimise(const std::vector<Axis>& axes, const py::function& residuals, const std::string& method,
                   std::uint64_t seed, std::int64_t evaluations, const std::optional<double>& target) {
  std::vector<api::Axis> own;
  for (const auto& [name, lower, upper, precision, is_discrete] : axes)
    own.push_back({name, lower, upper, precision, is_discrete});
  const api::Minimum minimum = Computed([&](const Stop& stop) {
    const api::SearchOptions options{method, seed, evaluations, target, 1, stop};
    const auto call = [&](const Eigen::VectorXd& values) -> Eigen::VectorXd {
      if (stop()) throw std::runtime_error("interrupted");
      const py::gil_scoped_acquire locked;
      try {
        return residuals(values).cast<Eigen::VectorXd>();
      } catch (py::error_already_set& error) {
        throw std::runtime_error(error.what());
      }
    };
    return api::Minimise(own, call, options);
  });
  return py::make_tuple(minimum.values, minimum.cost, minimum.evaluations, minimum.reason);
}

}  // namespace

void BindSearch(py::module_& module) { module.def("minimise", &Minimise); }

}  // namespace fourpost::python
