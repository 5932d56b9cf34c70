// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/terminal.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string_view>

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace jounce::dashboard {
namespace {

volatile std::sig_atomic_t ended = 0;

void write_all(std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = write(STDOUT_FILENO, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

/// SGR of ECMA-48; the sixteen colors that every theme has made readable.
const char* look(Tone tone) {
  switch (tone) {
    case Tone::plain:
      return "\x1b[0m";
    case Tone::faint:
      return "\x1b[0;2m";
    case Tone::strong:
      return "\x1b[0;1m";
    case Tone::rests:
      return "\x1b[0;34m";
    case Tone::moves:
      return "\x1b[0;32m";
    case Tone::waits:
      return "\x1b[0;33m";
    case Tone::wrong:
      return "\x1b[0;1;31m";
    case Tone::chosen:
      return "\x1b[0;1;7m";
  }
  return "";
}

/// Takes a key off what was typed. An arrow is ESC [ A or ESC O A; other sequences are skipped.
Key taken(std::string& typed) {
  const bool sequence =
      typed.size() >= 3 && typed[0] == '\x1b' && (typed[1] == '[' || typed[1] == 'O');
  if (!sequence) {
    const auto c = static_cast<unsigned char>(typed.front());
    typed.erase(0, 1);
    return c == 3 ? Key{'q'} : Key{c};
  }
  std::size_t end = 2;
  while (end + 1 < typed.size() && (typed[end] < '@' || typed[end] > '~')) ++end;
  const char last = typed[end];
  typed.erase(0, end + 1);
  return last == 'A' ? Key::up : last == 'B' ? Key::down : Key{0};
}

}  // namespace

bool is_screen() {
  const char* const term = std::getenv("TERM");
  const bool able = term != nullptr && *term != '\0' && std::string_view(term) != "dumb";
  return able && isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
}

bool is_utf8() {
  for (const char* const variable : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* const value = std::getenv(variable);
    if (value == nullptr || *value == '\0') continue;
    const std::string_view locale = value;
    return locale.find("UTF-8") != locale.npos || locale.find("utf8") != locale.npos;
  }
  return false;
}

std::string drawn(const std::vector<Row>& rows) {
  std::string text = "\x1b[H";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0) text += "\r\n";
    for (const Span& span : rows[i]) text += look(span.tone) + span.text;
    text += "\x1b[0m\x1b[K";
  }
  return text + "\x1b[J";
}

Terminal::Terminal() {
  tcgetattr(STDIN_FILENO, &before_);
  termios raw = before_;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  ended = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, [](int) { ended = 1; });
  write_all("\x1b[?1049h\x1b[?25l");
}

Terminal::~Terminal() {
  write_all("\x1b[?25h\x1b[?1049l");
  tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
}

void Terminal::measure(View& view) const {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return;
  view.width = size.ws_col;
  view.height = size.ws_row;
}

void Terminal::show(const std::vector<Row>& rows) {
  std::string text = drawn(rows);
  if (text == shown_) return;
  write_all(text);
  shown_ = std::move(text);
}

std::optional<Key> Terminal::key() {
  if (ended != 0) return Key{'q'};
  if (typed_.empty()) {
    pollfd descriptor{STDIN_FILENO, POLLIN, 0};
    if (poll(&descriptor, 1, 0) <= 0) return std::nullopt;
    std::array<char, 64> bytes{};
    const ssize_t n = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (n <= 0) return Key{'q'};
    typed_.assign(bytes.data(), static_cast<std::size_t>(n));
  }
  return taken(typed_);
}

bool show_axes(Watch& watch, Transport& link, View view, const std::optional<wire::Key>& key,
               const std::function<bool()>& goes_on) {
  constexpr Nanos turn = std::chrono::milliseconds(50);
  Terminal terminal;
  while (goes_on()) {
    view.now = steady_now();
    terminal.measure(view);
    terminal.show(rows_of(watch.axes(), view));
    watch.run(turn);
    while (const auto pressed = terminal.key()) {
      const Action action = press(view, watch.axes(), *pressed);
      if (action == Action::quit) return true;
      if (action != Action::nothing) view.note = send(link, view.chosen, action, key);
    }
    // One that falls silent later is shown as such: it may come back.
    if (!watch.has_received() && !watch.silent(view.silence).empty()) return false;
  }
  return true;
}

}  // namespace jounce::dashboard
