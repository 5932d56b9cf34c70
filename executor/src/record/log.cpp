// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/log.hpp"

#include <algorithm>
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

/// "+1@0.000412 -3@0.00077": track 1 switched on, 3 off, at these times (s) after the previous
/// tick.
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

/// "1+@0.00058=12.5": an edge of the input 1, this time (s) before the tick, at this position.
void append(std::string& line, const ProbeStep& probe) {
  const char* separator = "";
  for (const Capture& capture : probe.captures()) {
    append(line, separator);
    append(line, static_cast<int>(capture.input));
    line += capture.rising ? "+@" : "-@";
    append(line, capture.age);
    line += '=';
    append(line, capture.position());
    separator = " ";
  }
}

/// "pass3@0.00042=170000": the third pass ended, this time (s) before the tick, with the master at
/// this position. "table1@...": the table in this bank begins.
void append(std::string& line, const ProfileStep& profile) {
  const char* separator = "";
  for (const ProfileEvent& event : profile.events()) {
    append(line, separator);
    line += event.kind == ProfileEvent::Kind::begin ? "table" : "pass";
    append(line, event.number);
    line += '@';
    append(line, std::max(0.0, -event.t));
    line += '=';
    append(line, event.master);
    separator = " ";
  }
}

template <class First, class... Others>
void join(std::string& line, const First& first, const Others&... others) {
  append(line, first);
  ((line += ',', append(line, others)), ...);
}

}  // namespace

TickLog::TickLog(std::filesystem::path path, const Units& units, const LogColumns& more)
    : path_(std::move(path)),
      temporary_(path_.string() + "." + std::to_string(getpid()) + ".part"),
      file_(temporary_, std::ios::binary | std::ios::trunc),
      more_(more) {
  if (std::filesystem::exists(path_) && !std::filesystem::is_regular_file(path_)) {
    file_.close();
    std::filesystem::remove(temporary_);
    throw InputError("log", path_.string(),
                     "must be a regular file: the log gets this name when it is complete");
  }
  const auto of_master = [&](const char* per) {
    return units.x.empty() ? "" : " [" + units.x + per + "]";
  };
  const std::string m = " [" + units.x;
  const std::string u = " [" + units.position;
  file_ << "tick,time [s],state";
  if (more.master) file_ << ",master" << of_master("") << ",master_velocity" << of_master("/s");
  file_ << ",position" << u << "],velocity" << u << "/s],acceleration" << u
        << "/s^2],job,fault,outputs,edges [s],held,homed";
  if (more.path) file_ << ",path_time [s]";
  if (more.probes) file_ << ",captures [s=" << units.position << "]";
  if (more.profile) file_ << ",profile [s=" << units.x << "]";
  if (more.registration)
    file_ << ",deviation" << m << "],correction"
          << (*more.registration == CorrectionOf::master ? m : u) << "],marks,missed,strays";
  if (more.compensation)
    file_ << ",compensated,compensation" << u << "],drive_position" << u << "]";
  if (more.feedback) file_ << ",actual" << u << "],following_error" << u << "]";
  if (more.torque) file_ << ",torque [rated]";
  file_ << '\n';
  file_.flush();
  if (file_) return;
  const int why = errno;
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
  throw std::system_error(why, std::generic_category(), "cannot write " + temporary_.string());
}

TickLog::~TickLog() {
  if (!file_.is_open()) return;
  file_.close();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void TickLog::add(const Tick& tick) {
  if (!truncated_.empty()) return;
  line_.clear();
  join(line_, tick.tick, tick.time, name(tick.state));
  if (more_.master) join(line_, "", tick.master, tick.master_velocity);
  join(line_, "", tick.position, tick.velocity, tick.acceleration, tick.job, name(tick.fault),
       tick.switches, tick.held ? 1 : 0, tick.homed ? 1 : 0);
  if (more_.path) join(line_, "", tick.path_time);
  if (more_.probes) join(line_, "", tick.probe);
  if (more_.profile) join(line_, "", tick.profile);
  const RegistrationReading& marks = tick.registration;
  if (more_.registration)
    join(line_, "", marks.deviation, marks.correction, marks.marks, marks.missed, marks.strays);
  if (more_.compensation)
    join(line_, "", tick.compensated ? 1 : 0, tick.correction[0],
         tick.position + tick.correction[0] - tick.offset);
  if (more_.feedback) join(line_, "", tick.actual_position, tick.following_error);
  if (more_.torque) join(line_, "", tick.torque);
  line_ += '\n';
  file_ << line_;
  look();
}

void TickLog::close() {
  file_.flush();
  look();
  file_.close();
  if (!truncated_.empty()) keep_whole_lines();
  const char* const suffix = truncated_.empty() ? "" : ".truncated";
  std::filesystem::rename(temporary_, path_.string() + suffix);
}

void TickLog::look() {
  if (!file_ && truncated_.empty())
    truncated_ = errno != 0 ? std::generic_category().message(errno) : "it cannot be written";
}

/// The buffer at the time of the full disk may have been written in part.
void TickLog::keep_whole_lines() {
  constexpr std::uintmax_t most = 8192;  // bytes, more than a line has
  const std::uintmax_t size = std::filesystem::file_size(temporary_);
  const std::uintmax_t from = size - std::min(size, most);
  std::string tail(size - from, '\0');
  std::ifstream in(temporary_, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(from));
  in.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  std::filesystem::resize_file(temporary_, from + tail.rfind('\n') + 1);
}

}  // namespace jounce
