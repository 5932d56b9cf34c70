// SPDX-License-Identifier: Apache-2.0
#include <system_error>

#include "jounce/base/input_errors.hpp"
#include "jounce/stream/transport/transport.hpp"

#include "python/src/bind.hpp"
#include "python/src/numpy/column.hpp"

namespace jounce::python {
namespace {

py::object exception_of(const InputError& error) {
  return from_package("_errors", "InputError")(error.what(), error.document(), error.line(),
                                               error.column(), error.key(), error.value(),
                                               error.rule());
}

void raise(const py::object& exception) {
  PyErr_SetObject(py::type::handle_of(exception).ptr(), exception.ptr());
}

void raise(const InputError& error) {
  py::object first = exception_of(error);
  py::list all;
  all.append(first);
  const std::vector<InputError> errors = all_errors(error);
  for (std::size_t i = 1; i < errors.size(); ++i) all.append(exception_of(errors[i]));
  first.attr("errors") = py::tuple(all);
  raise(first);
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    raise(error);
  } catch (const TransportError& error) {
    PyErr_SetString(PyExc_ConnectionError, error.what());
  } catch (const std::system_error& error) {
    raise(py::reinterpret_borrow<py::object>(PyExc_OSError)(error.code().value(), error.what()));
  }
}

}  // namespace

void bind_errors(py::module_&) {
  py::register_exception_translator(translate);
}

}  // namespace jounce::python
