#include "python/bindings/bindings.h"

namespace fourpost::python {
namespace {

const char* KindOf(const api::Error& error) {
  switch (error.kind()) {
    case api::Error::Kind::kInput: return "InputError";
    case api::Error::Kind::kSimulation: return "SimulationError";
    case api::Error::Kind::kOutput: return "OutputError";
  }
  return "Error";
}

/// Raises the error as its class in Python.
void Raise(const api::Error& error) {
  const py::object type = py::module_::import("fourpost.errors").attr(KindOf(error));
  PyErr_SetObject(type.ptr(), type(error.what(), FindingsOf(error.findings())).ptr());
}

}  // namespace

py::object FindingOf(const api::Finding& finding) {
  return py::module_::import("fourpost.errors")
      .attr("Finding")(finding.code, finding.is_error ? "error" : "warning", finding.file, finding.line,
                       finding.argument, finding.text);
}

py::list FindingsOf(const std::vector<api::Finding>& findings) {
  py::list list;
  for (const api::Finding& finding : findings) list.append(FindingOf(finding));
  return list;
}

void BindErrors(py::module_&) {
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const api::Error& error) {
      Raise(error);
    }
  });
}

}  // namespace fourpost::python
