// SPDX-License-Identifier: Apache-2.0
#include <chrono>

#include "python/src/design.hpp"

namespace jounce::python {

bool Watch::operator()(double done, const std::string& step) {
  using namespace std::chrono_literals;
  const std::int64_t now =
      std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
  if (!goes_on_ || (last_ && now - *last_ < std::chrono::nanoseconds(20ms).count()))
    return goes_on_;
  last_ = now;
  const py::gil_scoped_acquire acquire;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!callback_.is_none()) goes_on_ = !callback_(done, step).is(py::bool_(false));
  } catch (...) {
    thrown_ = std::current_exception();
    goes_on_ = false;
  }
  return goes_on_;
}

void Watch::rethrow() const {
  if (thrown_) std::rethrow_exception(thrown_);
}

}  // namespace jounce::python
