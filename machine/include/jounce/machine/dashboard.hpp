// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/machine/watch.hpp"
#include "jounce/stream/security/key.hpp"
#include "jounce/stream/transport/transport.hpp"

/// The screen of `jounce monitor`, independent of any terminal: axes in, rows of text out.
///
///     Watch watch(*link, {.names = {"feeder"}});
///     View view{.width = 80, .height = 24, .now = steady_now()};
///     for (const Row& row : rows_of(watch.axes(), view)) ...
///     const Action action = press(view, watch.axes(), Key{'s'});     // asks first
namespace jounce::dashboard {

/// Tone of a text: its meaning, not a colour.
enum class Tone { plain, faint, strong, rests, moves, waits, wrong, chosen };

struct Span {
  std::string text;
  Tone tone = Tone::plain;
};
using Row = std::vector<Span>;

/// View of the operator.
struct View {
  int width = 80;
  int height = 24;
  bool ascii = false;  ///< no other characters
  /// By name, since others come and go: the axis in detail, which the keys are for; else the first.
  std::string chosen = {};
  bool asks = false;      ///< a stop waits for its confirmation
  std::string note = {};  ///< result of the last key
  Nanos now{};
  Nanos silence = std::chrono::seconds(3);  ///< from then on an axis is called silent
};

/// At most view.height rows of at most view.width columns: the axes, the chosen one in detail, keys.
std::vector<Row> rows_of(const std::vector<Watched>& axes, const View& view);

/// A key that was pressed: a character, or an arrow.
enum class Key : int { up = 256, down = 257 };

/// Requested action for view.chosen.
enum class Action { nothing, quit, hold, resume, stop };

/// A stop is asked for twice: `s`, then `y`; every other key but `q` takes it back.
Action press(View& view, const std::vector<Watched>& axes, Key key);

/// Sends the stop, the hold or the resume to an axis as an operator, and returns its answer in a few
/// words, for View::note. Throws TransportError.
std::string send(Transport& link, const std::string& axis, Action action,
                 const std::optional<wire::Key>& key);

}  // namespace jounce::dashboard
