// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

/// The screen of `jounce monitor`, independent of any terminal: statuses in, rows of text out.
///
///     std::vector<Watched> axes;
///     hear(axes, message->executor, *status, steady_now());
///     View view{.width = 80, .height = 24, .now = steady_now()};
///     for (const Row& row : dashboard(axes, view)) ...
///     const Wish wish = press(view, axes, Key{'s'});     // asks first
namespace jounce::cli {

/// An axis by its messages.
struct Watched {
  static constexpr std::size_t traced = 240;  ///< positions that are kept
  static constexpr std::size_t most_masters =
      64;  ///< likewise: without a key, any sender can invent some

  std::string name;
  std::optional<wire::Status> status = std::nullopt;  ///< the newest; none: no message yet
  Nanos heard{};                                      ///< when, on the monitor's clock
  std::deque<double> trace = {};                      ///< positions every 100 ms, the newest last
  Nanos traced_at{};                                  ///< arrival of the newest of them
  std::vector<wire::MasterStatus> masters = {};       ///< state of each, by name
};

/// Takes a status in; an axis that is new comes to its place by name.
void hear(std::vector<Watched>& axes, const std::string& name, const wire::Status& status,
          Nanos now);

/// State of a master in an axis; without effect before its first status. If there are too many, the one that
/// was seen in the earliest cycle goes.
void hear(std::vector<Watched>& axes, const std::string& name, const wire::MasterStatus& master);

/// A master in a few words: where it is, how fast, how old; or that it is lost.
std::string said_of(const wire::MasterStatus& master, bool ascii);

/// "log, black box": the files that could not be written, from wire::Status::unwritten.
std::string unwritten_of(std::uint8_t files);

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
std::vector<Row> dashboard(const std::vector<Watched>& axes, const View& view);

/// A key that was pressed: a character, or an arrow.
enum class Key : int { up = 256, down = 257 };

/// Requested action for view.chosen.
enum class Wish { nothing, quit, hold, resume, stop };

/// A stop is asked for twice: `s`, then `y`; every other key but `q` takes it back.
Wish press(View& view, const std::vector<Watched>& axes, Key key);

/// One character for each value, scaled from the lowest to the highest one; if there are more than
/// `width`, the last ones.
std::string sparkline(const std::deque<double>& values, std::size_t width, bool ascii);

}  // namespace jounce::cli
