// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "jounce/base/input_errors.hpp"
#include "jounce/stream/transport/transport.hpp"

#include "python/src/advice.hpp"
#include "python/src/bind.hpp"
#include "python/src/numpy/column.hpp"

namespace jounce::python {
namespace {

/// Options of the command line in messages of the library, and the arguments of Python. Longer options come before
/// their beginnings.
constexpr std::array arguments{
    std::pair{"`jounce convert --decimal-comma`", "load(..., decimal_comma=True)"},
    std::pair{"--decimal-comma", "decimal_comma=True"},
    std::pair{"--position-resolution", "p_step"},
    std::pair{"--velocity-resolution", "v_step"},
    std::pair{"--resolution", "x_step"},
    std::pair{"--velocity-tolerance", "velocity_tolerance"},
    std::pair{"--tolerance", "tolerance"},
    std::pair{"--position-unit", "position_unit"},
    std::pair{"--master-unit", "x_unit"},
    std::pair{"--machine", "machine"},
    std::pair{"--master", "master"},
    std::pair{"--periodic", "periodic=True"},
    std::pair{"--patience", "timeout"},
    std::pair{"--against", "against"},
    std::pair{"--allow-loss", "allow_loss=True"},
    std::pair{"--continuity", "continuity"},
    std::pair{"--controller", "controller"},
    std::pair{"--intervals", "intervals"},
    std::pair{"--limit", "limits"},
    std::pair{"--most", "most"},
    std::pair{"--rule", "rule"},
    std::pair{"--axis", "axis"},
    std::pair{"--live", "live=True"}};

/// The error with its key, value and rule in the words of Python.
InputError in_python(const InputError& error) {
  return InputError(with_arguments(error.key()), error.value(), with_arguments(error.rule()))
      .at(error.document(), error.line(), error.column());
}

py::object exception_of(const InputError& given) {
  const InputError error = in_python(given);
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

std::string with_arguments(std::string message) {
  // An option within backquotes belongs to a command that the message quotes.
  const auto is_quoted = [&](std::size_t at) {
    return std::count(message.begin(), message.begin() + static_cast<std::ptrdiff_t>(at), '`') %
               2 !=
           0;
  };
  for (const auto& [option, argument] : arguments) {
    const std::string_view wanted = option;
    for (std::size_t at = message.find(wanted); at != std::string::npos;
         at = message.find(wanted, at + 1))
      if (!is_quoted(at)) message.replace(at, wanted.size(), argument);
  }
  return message;
}

void bind_errors(py::module_&) {
  py::register_exception_translator(translate);
}

}  // namespace jounce::python
