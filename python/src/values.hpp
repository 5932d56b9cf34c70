// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace jounce::python {

namespace py = pybind11;

/// Gives a class the operations of a value: ==, hash() and pickle. `state` returns the tuple of the members of a value;
/// `make` returns the value of such a tuple.
template <class T, class State, class Make>
void add_value(py::class_<T>& c, const State& state, const Make& make) {
  c.def(
       "__eq__",
       [state](const T& self, const py::object& other) {
         return py::isinstance<T>(other) && state(self).equal(state(other.cast<const T&>()));
       },
       py::arg("other"), "True if all members are equal.")
      .def(
          "__hash__", [state](const T& self) { return py::hash(state(self)); },
          "Returns the hash of the members.")
      .def(py::pickle([state](const T& self) -> py::tuple { return state(self); },
                      [make](const py::tuple& members) -> T { return make(members); }));
}

}  // namespace jounce::python
