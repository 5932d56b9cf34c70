// SPDX-License-Identifier: Apache-2.0
// Many moves at once: one loop in C++, without the GIL.
#include <limits>
#include <optional>

#include <pybind11/stl.h>

#include "jounce/base/detail/parallel.hpp"
#include "jounce/profiles/moves/batch.hpp"
#include "jounce/profiles/moves/explain.hpp"

#include "python/src/moves.hpp"
#include "python/src/readers.hpp"
#include "python/src/report.hpp"
#include "python/src/words.hpp"

namespace jounce::python {

using namespace py::literals;

Moves::Moves(Broadcast::Shape shape, std::size_t size, ProfileOf profile)
    : shape_(std::move(shape)),
      size_(size),
      profile_(std::move(profile)),
      status_(std::make_unique_for_overwrite<MoveStatus[]>(size)),
      durations_(std::make_unique_for_overwrite<double[]>(size)) {}

void Moves::set(std::size_t i, MoveStatus status, double duration) {
  status_[i] = status;
  durations_[i] = status == MoveStatus::ok ? duration : std::numeric_limits<double>::quiet_NaN();
}

std::size_t threads_of(std::optional<py::ssize_t> threads) {
  if (threads && *threads < 1)
    throw InputError("threads", std::to_string(*threads),
                     "must be at least 1, or None for one thread on each core");
  return static_cast<std::size_t>(threads.value_or(0));
}

void in_parts(std::size_t size, std::size_t threads,
              const std::function<void(std::size_t, std::size_t)>& body) {
  constexpr std::size_t part = 16384;
  if (size <= 2 * part) return body(0, size);
  on_all_cores((size + part - 1) / part,
               [&](std::size_t k) { body(k * part, std::min(size, (k + 1) * part)); }, {}, threads);
}

namespace {

/// The arguments of many moves, as copies: the caller may change its arrays. A profile is solved again when it is used,
/// which takes less time than to store all of them.
class MoveInputs {
 public:
  MoveInputs(MoveReaders readers, std::optional<Reader> duration, std::size_t size)
      : readers_(readers), duration_(duration) {
    for (Reader* reader : readers_.all()) keep(*reader, size);
    if (duration_) keep(*duration_, size);
  }

  [[nodiscard]] MoveResult move(std::size_t i) const {
    return duration_
               ? move_to(readers_.from(i), readers_.to(i), readers_.bounds(i), (*duration_)[i])
               : move_to(readers_.from(i), readers_.to(i), readers_.bounds(i));
  }

 private:
  void keep(Reader& reader, std::size_t size) {
    const std::size_t count = reader.step == 0 ? 1 : size;
    kept_.emplace_back(reader.data, reader.data + count);
    reader.data = kept_.back().data();
  }

  std::vector<std::vector<double>> kept_;
  MoveReaders readers_;
  std::optional<Reader> duration_;
};

Moves many(Broadcast& all, const MoveReaders& readers, const std::optional<Column>& duration,
           std::size_t threads) {
  const auto wanted = duration ? std::optional(all.read(*duration)) : std::nullopt;
  const py::gil_scoped_release release;
  const auto inputs = std::make_shared<const MoveInputs>(readers, wanted, all.size());
  Moves moves(all.shape(), all.size(), [inputs](std::size_t i) { return inputs->move(i).profile; });
  in_parts(all.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const MoveResult move = inputs->move(i);
      moves.set(i, move.status, move.profile.duration());
    }
  });
  return moves;
}

py::object move(const StateColumns& start, const StateColumns& target, const BoundsColumns& bounds,
                const std::optional<Column>& duration, std::optional<py::ssize_t> threads) {
  const std::size_t most = threads_of(threads);
  Broadcast all = broadcast_moves(start, target, bounds, duration.value_or(Column{}));
  if (!all.is_scalar())
    return py::cast(many(all, MoveReaders(all, start, target, bounds), duration, most));
  const MotionState from = one(start, "start"), to = one(target, "target");
  const Bounds b = bounds.one();
  const MoveResult made = duration ? move_to(from, to, b, duration->value) : move_to(from, to, b);
  if (!made)
    raise_move_error(made.status, duration ? explain(made.status, from, to, b, duration->value)
                                           : explain(made.status, from, to, b));
  return py::cast(made.profile);
}

std::string shape_text(const Broadcast::Shape& shape) {
  return py::cast<std::string>(py::repr(py::tuple(py::cast(shape))));
}

/// The index of an element in the order of memory. Throws IndexError like an array of NumPy.
std::size_t flat_index(const Broadcast::Shape& shape, const py::object& index) {
  const py::tuple parts =
      py::isinstance<py::tuple>(index) ? py::tuple(index) : py::make_tuple(index);
  if (parts.size() != shape.size())
    throw py::index_error("the moves have " + std::to_string(shape.size()) +
                          " axes, and the index has " + std::to_string(parts.size()));
  for (const py::handle& part : parts)
    if (PyIndex_Check(part.ptr()) == 0)
      throw py::type_error("the index of a move must be one integer for each axis of the shape " +
                           shape_text(shape));
  py::ssize_t flat = 0;
  for (std::size_t k = 0; k < shape.size(); ++k) {
    py::ssize_t i = py::cast<py::ssize_t>(parts[k]);
    if (i < 0) i += shape[k];
    if (i < 0 || i >= shape[k])
      throw py::index_error("index " + py::cast<std::string>(py::str(parts[k])) +
                            " is out of range for the size " + std::to_string(shape[k]));
    flat = flat * shape[k] + i;
  }
  return static_cast<std::size_t>(flat);
}

Profile element(const Moves& moves, const py::object& index) {
  const std::size_t i = flat_index(moves.shape(), index);
  if (moves.status(i) != MoveStatus::ok)
    raise_move_error(moves.status(i), explain(moves.status(i)));
  return moves.profile(i);
}

/// An iterator over moves with one axis. For several axes, moves[0] throws IndexError, so the iterator of Python would
/// end at once.
py::object each_move(const py::object& self) {
  const Broadcast::Shape& shape = self.cast<const Moves&>().shape();
  if (shape.size() != 1)
    throw py::type_error("moves of the shape " + shape_text(shape) +
                         " have no order: use an index with one integer for each axis");
  return py::reinterpret_steal<py::object>(PySeqIter_New(self.ptr()));
}

py::object motions_at(const Moves& moves, const Column& t) {
  Column index;  // the moves as a column of their indices, so that NumPy's rules apply to the times
  std::vector<double> numbers(moves.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<double>(i);
  index.array = Doubles(taken(std::move(numbers), moves.shape()));
  Broadcast all({&index, &t});
  const Reader which = all.read(index), times = all.read(t);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return points_of<OverTime>(all.shape(), all.size(), [&](std::size_t i) {
    const auto k = static_cast<std::size_t>(which[i]);
    if (moves.status(k) != MoveStatus::ok) return Jet{nan, nan, nan, nan};
    return jet_at(moves.profile(k), times[i]);
  });
}

py::object least_durations(const Column& distance, const Column& velocity,
                           const Column& acceleration, const Column& jerk, const Column& entry,
                           const Column& exit) {
  Broadcast all({&distance, &velocity, &acceleration, &jerk, &entry, &exit});
  const std::size_t size = all.size();
  const auto span = [&](const Column& column) {
    const Reader reader = all.read(column);
    return std::span<const double>(reader.data, reader.step == 0 ? 1 : size);
  };
  const MoveColumns columns{span(distance), span(entry),        span(exit),
                            span(velocity), span(acceleration), span(jerk)};
  py::array_t<double> seconds(all.shape());
  {
    const std::span<double> out(seconds.mutable_data(), size);
    const py::gil_scoped_release release;
    minimum_durations(columns, out);
  }
  if (all.is_scalar()) return py::float_(*seconds.data());
  return seconds;
}

}  // namespace

void bind_batches(py::module_& m) {
  py::class_<Moves>(m, "Moves", R"(Many moves, in the shape of the arrays from which they were made.

A move that does not exist has the duration NaN, and `moves[i]` raises MoveError. A
profile is solved again when it is used, so that many moves need little memory.)")
      .def_property_readonly(
          "duration",
          [](const py::object& self) -> py::object {
            const auto& moves = self.cast<const Moves&>();
            return view(moves.durations(), self).attr("reshape")(moves.shape());
          },
          "Durations, s; NaN where no move exists. A read-only view without a copy.")
      .def_property_readonly(
          "ok",
          [](const Moves& moves) {
            py::array_t<bool> ok(moves.shape());
            for (std::size_t i = 0; i < moves.size(); ++i)
              ok.mutable_data()[i] = moves.status(i) == MoveStatus::ok;
            return ok;
          },
          "True where the move exists.")
      .def_property_readonly(
          "shape", [](const Moves& moves) { return py::tuple(py::cast(moves.shape())); },
          "Shape of the arrays.")
      .def("__len__", [](const Moves& moves) { return moves.shape().front(); })
      .def("__getitem__", element, "index"_a,
           "Returns one Move. Raises MoveError if it does not exist.")
      .def("__iter__", each_move, "Iterates over moves with one axis.")
      .def("at", motions_at, "t"_a,
           R"(Returns the motion of each move at t (s), as a Motion of arrays.

t is one number, or an array that is broadcast with the shape of the moves. NaN where no move exists.)")
      .def("__repr__", [](const Moves& moves) {
        std::size_t ok = 0;
        for (std::size_t i = 0; i < moves.size(); ++i)
          ok += moves.status(i) == MoveStatus::ok ? 1 : 0;
        return shown("Moves",
                     {{"shape", shape_text(moves.shape())}, {"exist", std::to_string(ok)}});
      });
  m.def("move_to", move, "start"_a, "target"_a, "bounds"_a, py::kw_only(),
        "duration"_a = py::none(), "threads"_a = py::none(),
        R"(Returns the time-optimal move between two states that keeps the bounds.

start, target: State, or a position (u) at rest. With `duration` (s), the move takes this time, to rounding. If all
arguments are numbers, the result is a Move; MoveError is raised if no move exists. If any argument is an array, the
arrays are broadcast and the result is Moves: one loop without the GIL. `threads`: greatest number of threads for many
moves; None: one for each core.

A start outside the bounds returns inside them. The target must be inside.)");
  m.def(
      "minimum_durations", least_durations, "distance"_a, py::kw_only(), "velocity"_a,
      "acceleration"_a, "jerk"_a = Bounds::none, "entry"_a = 0.0, "exit"_a = 0.0,
      R"(Returns the least durations (s) of moves over distances (u), by vector instructions, without the GIL.

Each argument is a number or an array. entry, exit: velocities at the ends (u/s); the acceleration is 0 there.
NaN where
no move exists. Agrees with move_to() to 12 digits.)");
}

}  // namespace jounce::python
