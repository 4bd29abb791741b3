#pragma once

#include <string>
#include <vector>

#include <pybind11/complex.h>
#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <fourpost/diagnostics.h>
#include <fourpost/response.h>

// The public headers as the module `fourpost._core`: functions of plain arrays and names, one file a noun. What is
// pleasant to use is made of them in Python.
namespace fourpost::python {

namespace py = pybind11;

/// As fourpost.errors.Finding.
py::object FindingOf(const api::Finding& finding);
py::list FindingsOf(const std::vector<api::Finding>& findings);

/// "auto", "reduced", "full", "time_integration", and back. Throws api::Error.
api::Engine EngineOf(const std::string& name);
std::string NameOf(api::Engine engine);

void BindErrors(py::module_& module);
void BindVehicle(py::module_& module);
void BindResponse(py::module_& module);
void BindSimulate(py::module_& module);
void BindModes(py::module_& module);
void BindInspection(py::module_& module);
void BindStudy(py::module_& module);
void BindFit(py::module_& module);
void BindRun(py::module_& module);
void BindSearch(py::module_& module);

}  // namespace fourpost::python
