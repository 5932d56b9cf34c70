#include "jounce/executor/log.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <concepts>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

void append(std::string& line, const char* text) {
  line += text;
}

template <class Number>
requires std::integral<Number> || std::floating_point<Number>
void append(std::string& line, Number value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  line.append(text.data(), end);
}

/// "+1@0.000412 -3@0.00077": track 1 went on, 3 off, so many s after the tick before.
void append(std::string& line, const SwitchStep& switches) {
  append(line, switches.outputs);
  line += ',';
  const char* separator = "";
  for (const auto& [time, track, on] : switches.edges()) {
    append(line, separator);
    line += on ? '+' : '-';
    append(line, track);
    line += '@';
    append(line, time);
    separator = " ";
  }
}

template <class First, class... Others>
void join(std::string& line, const First& first, const Others&... others) {
  line.clear();
  append(line, first);
  ((line += ',', append(line, others)), ...);
  line += '\n';
}

}  // namespace

TickLog::TickLog(std::filesystem::path path, const Units& units)
    : path_(std::move(path)),
      temporary_(path_.string() + "." + std::to_string(getpid()) + ".part"),
      file_(temporary_, std::ios::binary | std::ios::trunc) {
  if (std::filesystem::exists(path_) && !std::filesystem::is_regular_file(path_)) {
    file_.close();
    std::filesystem::remove(temporary_);
    throw InputError("log", path_.string(),
                     "must be a regular file: it is written under another name and renamed");
  }
  const std::string m = " [" + units.x;
  const std::string u = " [" + units.position;
  file_ << "tick,time [s],state,master" << m << "],master_velocity" << m << "/s],position" << u
        << "],velocity" << u << "/s],acceleration" << u << "/s^2],job,fault,outputs,edges [s]\n";
  require_good();
}

TickLog::~TickLog() {
  if (!file_.is_open()) return;
  file_.close();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void TickLog::add(const Tick& tick) {
  join(line_, tick.tick, tick.time, name(tick.state), tick.master, tick.master_velocity,
       tick.position, tick.velocity, tick.acceleration, tick.job, name(tick.fault), tick.switches);
  file_ << line_;
}

void TickLog::close() {
  file_.flush();
  require_good();
  file_.close();
  std::filesystem::rename(temporary_, path_);
}

void TickLog::require_good() {
  if (!file_)
    throw std::system_error(errno, std::generic_category(), "cannot write " + temporary_.string());
}

}  // namespace jounce
