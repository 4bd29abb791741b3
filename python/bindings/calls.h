#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <future>

#include <pybind11/pybind11.h>

namespace fourpost::python {

/// True asks a computation to end.
using Stop = std::function<bool()>;

/// What `work(stop)` returns, computed by a thread of its own. This one releases the interpreter's lock and takes it
/// ten times a second, to call `show` and to look for Ctrl-C. An exception of either ends the work, which keeps what it
/// has, and is then raised in place of the result.
template <typename Work>
auto Computed(const Work& work, const std::function<void()>& show = {}) {
  namespace py = pybind11;
  std::atomic<bool> is_stopped = false;
  std::exception_ptr raised;
  auto result = std::async(std::launch::async, [&] { return work(Stop([&] { return is_stopped.load(); })); });
  const auto is_ready = [&] {
    const py::gil_scoped_release unlocked;
    return result.wait_for(std::chrono::milliseconds(100)) == std::future_status::ready;
  };
  const auto look = [&] {
    try {
      if (show) show();
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    } catch (...) {
      raised = std::current_exception();
      is_stopped = true;
    }
  };
  while (!is_ready())
    if (!is_stopped) look();
  if (!is_stopped) look();
  if (!raised) return result.get();
  try {
    result.get();
  } catch (...) {  // it was stopped
  }
  std::rethrow_exception(raised);
}

}  // namespace fourpost::python
