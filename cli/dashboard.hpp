#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "jounce/stream/message.hpp"
#include "jounce/stream/transport.hpp"

/// What the screen of `jounce monitor` shows, apart from any terminal: statuses in, rows of text out.
///
///     std::vector<Watched> axes;
///     hear(axes, message->executor, *status, steady_now());
///     View view{.width = 80, .height = 24, .now = steady_now()};
///     for (const Row& row : dashboard(axes, view)) ...
///     const Wish wish = press(view, axes, Key{'s'});     // asks first
namespace jounce::cli {

/// An axis as it was heard.
struct Watched {
  static constexpr std::size_t traced = 240;  ///< positions that are kept
  static constexpr std::size_t most_masters =
      64;  ///< likewise: without a key anybody makes some up

  std::string name;
  std::optional<wire::Status> status = std::nullopt;  ///< the newest; none: not heard yet
  Nanos heard{};                                      ///< when, on the monitor's clock
  std::deque<double> trace = {};                      ///< positions every 100 ms, the newest last
  Nanos traced_at{};                                  ///< when the newest of them was heard
  std::vector<wire::MasterStatus> masters = {};       ///< what it says of each, by name
};

/// Takes a status in; an axis that is new comes to its place by name.
void hear(std::vector<Watched>& axes, const std::string& name, const wire::Status& status,
          Nanos now);

/// What an axis says of a master; before its first status nothing happens. Of too many, the one that
/// was seen in the earliest cycle goes.
void hear(std::vector<Watched>& axes, const std::string& name, const wire::MasterStatus& master);

/// A master in a few words: where it is, how fast, how old; or that it is lost.
std::string said_of(const wire::MasterStatus& master, bool ascii);

/// "log, black box": the files that could not be written, from wire::Status::unwritten.
std::string unwritten_of(std::uint8_t files);

/// How a text looks: what it means, not a colour.
enum class Tone { plain, faint, strong, rests, moves, waits, wrong, chosen };

struct Span {
  std::string text;
  Tone tone = Tone::plain;
};
using Row = std::vector<Span>;

/// What the operator looks at.
struct View {
  int width = 80;
  int height = 24;
  bool ascii = false;  ///< no other characters
  /// By name, since others come and go: the axis in detail, which the keys are for; else the first.
  std::string chosen = {};
  bool asks = false;      ///< a stop waits for its confirmation
  std::string note = {};  ///< what became of the last key
  Nanos now{};
  Nanos silence = std::chrono::seconds(3);  ///< from then on an axis is called silent
};

/// At most view.height rows of at most view.width columns: the axes, the chosen one in detail, keys.
std::vector<Row> dashboard(const std::vector<Watched>& axes, const View& view);

/// A key that was pressed: a character, or an arrow.
enum class Key : int { up = 256, down = 257 };

/// What it asks for, of view.chosen.
enum class Wish { nothing, quit, hold, resume, stop };

/// A stop is asked for twice: `s`, then `y`; every other key but `q` takes it back.
Wish press(View& view, const std::vector<Watched>& axes, Key key);

/// Of the values, one character each, from the lowest to the highest one of them; where there are more than
/// `width`, the last ones.
std::string sparkline(const std::deque<double>& values, std::size_t width, bool ascii);

}  // namespace jounce::cli
