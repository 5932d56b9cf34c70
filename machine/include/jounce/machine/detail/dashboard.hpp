// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/machine/watch.hpp"
#include "jounce/stream/security/key.hpp"
#include "jounce/stream/transport/transport.hpp"

/// The screen of `jounce monitor`, independent of any terminal: it converts states of axes to rows
/// of text.
///
///     Watch watch(*link, {.names = {"feeder"}});
///     View view{.width = 80, .height = 24, .now = steady_now()};
///     for (const Row& row : rows_of(watch.axes(), view)) ...
///     const Action action = press(view, watch.axes(), Key{'s'});     // asks first
namespace jounce::dashboard {

/// Meaning of a text. The terminal selects the color for it.
enum class Tone { plain, faint, strong, rests, moves, waits, wrong, chosen };

/// A text with one tone.
struct Span {
  std::string text = {};
  Tone tone = Tone::plain;
};
/// A row of the screen.
using Row = std::vector<Span>;

/// State of the screen.
struct View {
  int width = 80;      ///< columns of the screen
  int height = 24;     ///< rows of the screen
  bool ascii = false;  ///< true: use ASCII characters only
  /// Name of the axis whose details are shown and to which the keys apply. "" or an unknown name
  /// means the first axis.
  std::string chosen = {};
  bool asks = false;      ///< true: a stop waits for its confirmation
  std::string note = {};  ///< result of the last key
  Nanos now{};            ///< present time, by the clock of Watched::received
  /// An axis without a message for this time is shown as silent.
  Nanos silence = std::chrono::seconds(3);
};

/// Returns at most view.height rows of at most view.width columns: the axes, the details of the
/// chosen axis, the keys.
std::vector<Row> rows_of(const std::vector<Watched>& axes, const View& view);

/// A key that was pressed: the code of a character, or an arrow.
enum class Key : int { up = 256, down = 257 };

/// The action that a key requests, for the axis view.chosen.
enum class Action { nothing, quit, hold, resume, stop };

/// Processes a key and returns the requested action. A stop needs two keys, `s` and then `y`. Any
/// other key cancels it, except `q`, which quits.
Action press(View& view, const std::vector<Watched>& axes, Key key);

/// Sends a stop, hold or resume to an axis as an operator. Returns the answer of the axis in a few
/// words, for View::note. Throws TransportError.
std::string send(Transport& link, const std::string& axis, Action action,
                 const std::optional<wire::Key>& key);

}  // namespace jounce::dashboard
