#include <fourpost/units.h>
#include <fourpost/version.h>

#include "python/bindings/bindings.h"

namespace {

/// True in a module that was built without assertions, which must not be: Simbody's headers see NDEBUG.
constexpr bool kHasAssertions =
#ifdef NDEBUG
    false;
#else
    true;
#endif

}  // namespace

PYBIND11_MODULE(_core, module) {
  namespace python = fourpost::python;
  static_assert(kHasAssertions, "built with NDEBUG");
  python::BindErrors(module);
  python::BindVehicle(module);
  python::BindResponse(module);
  python::BindSimulate(module);
  python::BindModes(module);
  python::BindInspection(module);
  python::BindStudy(module);
  python::BindFit(module);
  python::BindRun(module);
  python::BindSearch(module);
  module.def("to_si", &fourpost::api::ToSi);
  module.def("in_unit", &fourpost::api::InUnit);
  module.def("si_unit_of", &fourpost::api::SiUnitOf);
  module.def("version", &fourpost::api::Version);
}
