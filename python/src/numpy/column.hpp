// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>

#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/moves/profile.hpp"

/// Numbers and arrays of NumPy as arguments and results.
namespace jounce::python {

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// An argument that is one number or an array of numbers.
struct Column {
  double value = 0;  ///< the number, if there is no array
  std::optional<Doubles> array = {};

  Column() = default;
  Column(double number) : value(number) {}

  [[nodiscard]] bool is_array() const { return array.has_value(); }
};

/// A state of motion whose members are numbers or arrays: jounce.State, or a position at rest.
struct StateColumns {
  Column position, velocity, acceleration;
};

/// Reads element i of a column that was broadcast to a common shape.
struct Reader {
  const double* data = nullptr;
  std::size_t step = 0;  ///< 0: one number for all elements

  double operator[](std::size_t i) const { return data[i * step]; }
};

/// The common shape of columns by the broadcasting rules of NumPy.
class Broadcast {
 public:
  using Shape = std::vector<py::ssize_t>;

  /// Throws ValueError if the shapes do not fit.
  explicit Broadcast(std::initializer_list<const Column*> columns);

  [[nodiscard]] bool is_scalar() const { return scalar_; }  ///< true if no column is an array
  [[nodiscard]] const Shape& shape() const { return shape_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Returns the elements of a column in this shape. The result is valid as long as this object and the column are.
  Reader read(const Column& column);

 private:
  bool scalar_ = true;
  Shape shape_;
  std::size_t size_ = 1;
  std::vector<Doubles> kept_;
};

/// A view of memory as a read-only array. It keeps `owner` alive. Nothing is copied.
py::array_t<double> view(std::span<const double> data, py::handle owner);

/// A new array with the values of a vector, whose memory it takes over.
py::array_t<double> taken(std::vector<double>&& values, const Broadcast::Shape& shape);
py::array_t<double> taken(std::vector<double>&& values);

/// Returns jounce.Motion or jounce.Transfer of four numbers or arrays.
template <class Over>
py::object point_of(py::object position, py::object first, py::object second, py::object third);
/// Returns jounce.Motion or jounce.Transfer of one place.
template <class Over>
py::object point_of(const Jet& jet) {
  return point_of<Over>(py::float_(jet[0]), py::float_(jet[1]), py::float_(jet[2]),
                        py::float_(jet[3]));
}

/// Returns jounce.State.
py::object state_of(const MotionState& state);

/// Evaluates `jet_at(i)` for each element without the GIL, and returns jounce.Motion or jounce.Transfer of arrays.
template <class Over, class JetAt>
py::object points_of(const Broadcast::Shape& shape, std::size_t size, const JetAt& jet_at) {
  std::array<py::array_t<double>, 4> columns{py::array_t<double>(shape), py::array_t<double>(shape),
                                             py::array_t<double>(shape),
                                             py::array_t<double>(shape)};
  std::array<double*, 4> out{};
  for (std::size_t k = 0; k < 4; ++k) out[k] = columns[k].mutable_data();
  {
    const py::gil_scoped_release release;
    for (std::size_t i = 0; i < size; ++i) {
      const Jet jet = jet_at(i);
      for (std::size_t k = 0; k < 4; ++k) out[k][i] = jet[k];
    }
  }
  return point_of<Over>(columns[0], columns[1], columns[2], columns[3]);
}

/// Evaluates `value_at(i)` for each element without the GIL, and returns an array.
template <class ValueAt>
py::array_t<double> values_of(const Broadcast::Shape& shape, std::size_t size,
                              const ValueAt& value_at) {
  py::array_t<double> values(shape);
  double* const out = values.mutable_data();
  const py::gil_scoped_release release;
  for (std::size_t i = 0; i < size; ++i) out[i] = value_at(i);
  return values;
}

/// True for an object of the class jounce.State.
bool is_state(py::handle object);

/// A class or function of the package jounce, by module and name.
py::object from_package(const char* module, const char* name);

}  // namespace jounce::python

namespace pybind11::detail {

template <>
struct type_caster<jounce::python::Column> {
  PYBIND11_TYPE_CASTER(jounce::python::Column, const_name("float | ndarray"));

  bool load(handle source, bool) {
    if (PyFloat_Check(source.ptr()) != 0 || PyLong_Check(source.ptr()) != 0) {
      value.value = PyFloat_AsDouble(source.ptr());
      if (value.value != -1 || PyErr_Occurred() == nullptr) return true;
      PyErr_Clear();
      return false;
    }
    if (source.is_none()) return false;
    const auto given = pybind11::array::ensure(source);
    if (!given || std::string_view("biufO").find(given.dtype().kind()) == std::string_view::npos)
      return false;  // text, times and complex numbers
    auto array = jounce::python::Doubles::ensure(given);
    if (!array) return false;
    if (array.ndim() == 0)
      value.value = *array.data();
    else
      value.array = std::move(array);
    return true;
  }

  static handle cast(const jounce::python::Column& column, return_value_policy, handle) {
    return column.is_array() ? object(*column.array).release() : float_(column.value).release();
  }
};

template <>
struct type_caster<jounce::python::StateColumns> {
  PYBIND11_TYPE_CASTER(jounce::python::StateColumns, const_name("jounce.State | float | ndarray"));

  bool load(handle source, bool convert);
};

}  // namespace pybind11::detail
