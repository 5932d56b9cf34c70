// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/sent_program.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "jounce/executor/detail/group_plan.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/path/command_times.hpp"

namespace jounce {
namespace {

constexpr std::int32_t program_end = 2;
constexpr std::int32_t program_end_and_rewind = 30;
/// Length of the path of a group that rests: not 0, because a path divides by its length.
constexpr double resting_length = 1e-9;

bool moves(const Program& program, std::size_t command) {
  const Program::Kind kind = program.commands()[command].kind;
  if (kind == Program::Kind::line)
    return program.place_before(command) != program.place_before(command + 1);
  return kind != Program::Kind::dwell;
}

double dwell_of(const Program& program, std::size_t first, std::size_t last) {
  double time = 0;
  for (std::size_t k = first; k < last; ++k) {
    const Program::Command& command = program.commands()[k];
    if (command.kind == Program::Kind::dwell) time += program.numbers()[command.data];
  }
  return time;
}

/// A path without motion at these positions of the axes, for this time.
GroupProgram rest_at(const Point& axes, double duration, std::int32_t line,
                     const ExecutorGroup& group) {
  const std::size_t n = group.configs.size();
  const double time = std::max(duration, seconds(group.configs.front().period));
  std::vector<double> numbers(axes.begin(), axes.begin() + static_cast<std::ptrdiff_t>(n));
  numbers.resize(2 * n);  // a line without a step
  Plan::Given given;
  given.settings.resize(1);
  given.path_axes = n - group.followers;
  for (const AxisConfig& config : group.configs) given.limits.axes.push_back(config.limits);
  auto plan = std::make_shared<const Plan>(
      Path(n, {PathPiece{.length = resting_length, .line = line}}, std::move(numbers)),
      TimingLaw({LawInterval{.duration = time}}), std::vector<JunctionMark>{}, time,
      std::move(given));
  GroupProgram program{.plan = std::move(plan), .axes = {}};
  for (const AxisConfig& config : group.configs)
    program.axes.push_back({resolved(config), {.velocity = *config.limits.velocity}});
  program.parts = {ProgramPart{.axes = std::vector<Peaks>(n)}};
  return program;
}

/// The words at the end of a stage belong to its last part, those between two parts to the second one.
std::span<const ProgramWord> words_of(const LimitedProgram& sent, const SentStage& stage,
                                      std::size_t first, std::size_t last) {
  const auto all =
      std::span(sent.words).subspan(stage.first_word, stage.last_word - stage.first_word);
  const auto at = [&](std::size_t command) {
    return std::find_if(all.begin(), all.end(),
                        [&](const ProgramWord& word) { return word.command >= command; });
  };
  return {at(first), last == stage.last ? all.end() : at(last)};
}

/// Adds the words of a part of a program, at the instants at which the path comes to their commands.
/// `moving`: false: the part only dwells.
void add_words(GroupProgram& made, const Program& part, std::span<const ProgramWord> words,
               std::size_t first, bool moving) {
  std::vector<std::size_t> commands;
  for (const ProgramWord& word : words) commands.push_back(word.command - first);
  const std::vector<CommandStart> starts =
      moving ? command_starts(part, *made.plan, commands) : std::vector<CommandStart>(words.size());
  for (std::size_t k = 0; k < words.size(); ++k) {
    const double time = moving ? starts[k].time : dwell_of(part, 0, commands[k]);
    const std::int32_t number = words[k].number;
    if (words[k].kind == ProgramWord::Kind::output)
      made.switches.push_back({time, std::abs(number), number > 0});
    else
      made.m_words.push_back({time, number});
  }
}

void raise(Peaks& peaks, const Peaks& by) {
  peaks.velocity = std::max(peaks.velocity, by.velocity);
  peaks.acceleration = std::max(peaks.acceleration, by.acceleration);
  peaks.jerk = std::max(peaks.jerk, by.jerk);
}

void raise(ProgramPart& part, const ProgramPart& by) {
  raise(part.along, by.along);
  for (std::size_t k = 0; k < part.axes.size(); ++k) raise(part.axes[k], by.axes[k]);
}

/// A change of the rate may continue in the next window. So it acts as if one plan contained all
/// commands: its slope suits the peaks of `all`, and its rate those of the commands that remain.
void set_peaks(GroupProgram& program, const ProgramPart& all, const ProgramPart& remaining) {
  for (std::size_t k = 0; k < program.axes.size(); ++k) program.axes[k].peaks = all.axes[k];
  program.parts = {remaining};
}

}  // namespace

bool MWordHandshake::waits_at(const ProgramWord& word) const {
  if (word.kind != ProgramWord::Kind::m_word) return false;
  if (all) return word.number != program_end && word.number != program_end_and_rewind;
  return std::find(numbers.begin(), numbers.end(), word.number) != numbers.end();
}

std::size_t SentProgram::step_end(std::size_t first, std::size_t last) const {
  const Program& program = sent.program;
  while (first < last && !moves(program, first)) ++first;
  if (first < last) ++first;
  while (first < last && !moves(program, first)) ++first;
  return first;
}

std::size_t SentProgram::window_end(const SentStage& stage, std::size_t first) const {
  for (const WindowRest& rest : stage.windows)
    if (rest.last == stage.last || rest.last >= first + window.common) return rest.last;
  return stage.last;
}

std::shared_ptr<const GroupProgram> planned_part(const SentProgram& all, const SentStage& stage,
                                                 std::size_t first, std::size_t last,
                                                 const ExecutorGroup& group,
                                                 const std::atomic<bool>* canceled) {
  const Program& program = all.sent.program;
  const bool whole = first == 0 && last == program.commands().size();
  const Program some = whole ? Program(1) : program.part(first, last);
  const Program& part = whole ? program : some;
  bool moving = false;
  for (std::size_t k = first; k < last && !moving; ++k) moving = moves(program, k);
  GroupProgram made =
      moving ? *planned_program(part, all.sent.limits, group, canceled)
             : rest_at(axes_at(program.place_before(first), group), dwell_of(program, first, last),
                       first < last ? program.commands()[first].line : 0, group);
  add_words(made, part, words_of(all.sent, stage, first, last), first, moving);
  const auto rest = std::find_if(stage.windows.begin(), stage.windows.end(),
                                 [&](const WindowRest& one) { return one.last >= last; });
  if (rest != stage.windows.end()) set_peaks(made, stage.windows.front().peaks, rest->peaks);
  return std::make_shared<const GroupProgram>(std::move(made));
}

namespace {

/// Plans a stage window by window, and keeps the first plan.
void plan_windows(const SentProgram& all, SentStage& stage, const ExecutorGroup& group,
                  const std::atomic<bool>* canceled) {
  const auto [most, common] = all.window;
  std::shared_ptr<const GroupProgram> first_plan;
  std::vector<WindowRest> windows;
  for (std::size_t first = stage.first; windows.empty() || windows.back().last < stage.last;
       first = windows.back().last - common) {
    const std::size_t last = std::min(first + most, stage.last);
    const auto made = planned_part(all, stage, first, last, group, canceled);
    const Program part = all.sent.program.part(first, last);
    const std::size_t known = windows.empty() ? 0 : common;
    const CommandStart from = command_starts(part, *made->plan, std::span(&known, 1)).front();
    windows.push_back({.last = last,
                       .length = made->plan->path().length() - from.where,
                       .time = made->plan->duration() - from.time,
                       .peaks = made->parts.front()});
    if (!first_plan) first_plan = made;
  }
  WindowRest after{.peaks = {.axes = std::vector<Peaks>(group.configs.size())}};
  for (auto window = windows.rbegin(); window != windows.rend(); ++window) {
    std::swap(window->length, after.length);
    std::swap(window->time, after.time);
    after.length += window->length;
    after.time += window->time;
    raise(window->peaks, after.peaks);
    after.peaks = window->peaks;
  }
  GroupProgram begin = *first_plan;
  set_peaks(begin, windows.front().peaks, windows.front().peaks);
  stage.program = std::make_shared<const GroupProgram>(std::move(begin));
  stage.planned = windows.front().last;
  stage.windows = std::move(windows);
}

}  // namespace

std::shared_ptr<const SentProgram> sent_program(LimitedProgram sent, const ExecutorGroup& group,
                                                const std::atomic<bool>* canceled) {
  SentProgram made{.sent = std::move(sent), .window = group.window};
  const std::size_t end = made.sent.program.commands().size();
  SentStage stage;
  const auto close = [&](std::size_t last, std::size_t last_word) {
    stage.last = last;
    stage.last_word = last_word;
    made.stages.push_back(std::exchange(stage, {.first = last, .first_word = last_word + 1}));
  };
  const std::vector<ProgramWord>& words = made.sent.words;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (!group.m_words.waits_at(words[k])) continue;
    close(words[k].command, k);
    stage.m_word = words[k].number;
  }
  close(end, words.size());
  std::size_t kept = 0;  // commands of the plans that are kept
  for (SentStage& one : made.stages) {
    if (one.last - one.first > group.window.commands)
      plan_windows(made, one, group, canceled);
    else if (one.first < one.last || one.first_word < one.last_word)
      one.program = planned_part(made, one, one.first, one.planned = one.last, group, canceled);
    kept += one.planned - std::min(one.first, one.planned);
    const bool first = &one == &made.stages.front();
    if (!first && one.first < one.last && kept > group.window.commands) one.program.reset();
  }
  return std::make_shared<const SentProgram>(std::move(made));
}

std::shared_ptr<const SentProgram> sent_program(LimitedProgram sent, GroupProgram planned) {
  SentProgram made{.sent = std::move(sent)};
  const Program& program = made.sent.program;
  add_words(planned, program, made.sent.words, 0, true);
  made.stages.push_back({.last = program.commands().size(),
                         .last_word = made.sent.words.size(),
                         .program = std::make_shared<const GroupProgram>(std::move(planned)),
                         .planned = program.commands().size()});
  return std::make_shared<const SentProgram>(std::move(made));
}

std::shared_ptr<const GroupProgram> first_motion(const SentProgram& program, bool single_step,
                                                 const ExecutorGroup& group, std::size_t& last) {
  const SentStage& stage = program.stages.front();
  last = single_step ? program.step_end(0, stage.last) : program.window_end(stage, 0);
  if (last == stage.planned && stage.program) return stage.program;
  return planned_part(program, stage, 0, last, group);
}

}  // namespace jounce
