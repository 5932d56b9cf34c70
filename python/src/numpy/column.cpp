// SPDX-License-Identifier: Apache-2.0
#include "python/src/numpy/column.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <string>

namespace jounce::python {

Broadcast::Broadcast(std::initializer_list<const Column*> columns) {
  kept_.reserve(columns.size());
  for (const Column* column : columns) {
    if (!column->is_array()) continue;
    scalar_ = false;
    const Doubles& array = *column->array;
    const std::size_t axes = static_cast<std::size_t>(array.ndim());
    if (axes > shape_.size()) shape_.insert(shape_.begin(), axes - shape_.size(), 1);
    for (std::size_t k = 0; k < axes; ++k) {
      py::ssize_t& mine = shape_[shape_.size() - axes + k];
      const py::ssize_t its = array.shape(static_cast<py::ssize_t>(k));
      if (mine != its && mine != 1 && its != 1)
        throw py::value_error("arrays of the sizes " + std::to_string(mine) + " and " +
                              std::to_string(its) + " cannot be broadcast to one shape");
      if (mine == 1) mine = its;
    }
  }
  for (const py::ssize_t n : shape_) size_ *= static_cast<std::size_t>(n);
}

Reader Broadcast::read(const Column& column) {
  if (!column.is_array()) return {&column.value, 0};
  const Doubles& array = *column.array;
  const bool same = static_cast<std::size_t>(array.ndim()) == shape_.size() &&
                    std::equal(shape_.begin(), shape_.end(), array.shape());
  if (same) return {array.data(), 1};
  py::tuple wanted(shape_.size());
  for (std::size_t k = 0; k < shape_.size(); ++k) wanted[k] = shape_[k];
  kept_.emplace_back(py::module_::import("numpy").attr("broadcast_to")(array, wanted));
  return {kept_.back().data(), 1};
}

py::array_t<double> view(std::span<const double> data, py::handle owner) {
  py::array_t<double> array(static_cast<py::ssize_t>(data.size()), data.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::array_t<double> taken(std::vector<double>&& values, const Broadcast::Shape& shape) {
  auto owned = std::make_unique<std::vector<double>>(std::move(values));
  const double* data = owned->data();
  const py::capsule owner(owned.release(),
                          [](void* p) { delete static_cast<std::vector<double>*>(p); });
  return py::array_t<double>(shape, data, owner);
}

py::array_t<double> taken(std::vector<double>&& values) {
  const auto size = static_cast<py::ssize_t>(values.size());
  return taken(std::move(values), {size});
}

py::object from_package(const char* module, const char* name) {
  return py::module_::import((std::string("jounce.") + module).c_str()).attr(name);
}

namespace {

/// The classes of the package that results and arguments have. They live as long as the interpreter.
py::handle kept_class(const char* name) {
  static auto* const classes = new std::map<std::string, py::object>;
  auto& found = (*classes)[name];
  if (!found) found = from_package("_values", name);
  return found;
}

}  // namespace

template <>
py::object point_of<OverTime>(py::object position, py::object first, py::object second,
                              py::object third) {
  return kept_class("Motion")(std::move(position), std::move(first), std::move(second),
                              std::move(third));
}

template <>
py::object point_of<OverMaster>(py::object position, py::object first, py::object second,
                                py::object third) {
  return kept_class("Transfer")(std::move(position), std::move(first), std::move(second),
                                std::move(third));
}

py::object state_of(const MotionState& state) {
  return kept_class("State")(state.position, state.velocity, state.acceleration);
}

bool is_state(py::handle object) {
  return py::isinstance(object, kept_class("State"));
}

}  // namespace jounce::python

namespace pybind11::detail {

bool type_caster<jounce::python::StateColumns>::load(handle source, bool convert) {
  make_caster<jounce::python::Column> part;
  if (!PyTuple_Check(source.ptr()) || !jounce::python::is_state(source)) {
    if (!part.load(source, convert)) return false;
    value.position = cast_op<jounce::python::Column>(part);
    return true;
  }
  jounce::python::Column* const parts[] = {&value.position, &value.velocity, &value.acceleration};
  for (ssize_t k = 0; k < 3; ++k) {
    make_caster<jounce::python::Column> each;
    if (!each.load(PyTuple_GET_ITEM(source.ptr(), k), convert)) return false;
    *parts[k] = cast_op<jounce::python::Column>(each);
  }
  return true;
}

}  // namespace pybind11::detail
