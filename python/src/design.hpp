// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <pybind11/pybind11.h>

#include "jounce/design/input.hpp"

namespace jounce::python {

namespace py = pybind11;

/// One axis of a spec, or a table: an Input with the name of its file.
struct Design {
  Input input;
  std::string path;
};

/// Returns the Input of an argument: a Design, or the path of a file with one axis.
Input input_of_argument(const py::object& source);

/// The spec of a design. Throws InputError for a table.
const Spec& spec_of(const Input& input, const char* what);

/// Returns json.loads(text).
py::object from_json(const std::string& text);

/// Observes long work that runs without the GIL: it calls a function of Python, and detects Ctrl-C.
///
///     Watch watch(callback);
///     { py::gil_scoped_release release; work(std::ref(watch)); }
///     watch.rethrow();
class Watch {
 public:
  /// `callback`: called with (done, step), or None.
  explicit Watch(py::object callback) : callback_(std::move(callback)) {}

  /// Returns false if the work must stop: after Ctrl-C, after an exception in the callback, and if the callback returns
  /// False. Called without the GIL; at most 50 times per second, it takes the GIL.
  bool operator()(double done, const std::string& step);

  /// Throws the exception of the callback, or KeyboardInterrupt. Called with the GIL.
  void rethrow() const;

 private:
  py::object callback_;
  std::exception_ptr thrown_;
  std::optional<std::int64_t> last_;  ///< time of the last call, ns
  bool goes_on_ = true;
};

}  // namespace jounce::python
