// SPDX-License-Identifier: Apache-2.0
#include "executor/src/record/run_record.hpp"

#include <utility>

#include "jounce/executor/detail/record.hpp"
#include "jounce/executor/detail/recorder.hpp"

namespace jounce::executor_detail {
namespace {

RecordedMaster recorded(const MachineMaster& master, std::size_t number) {
  RecordedMaster recorded{.master = number, .name = master.name, .unit = master.unit};
  if (const auto* heard = dynamic_cast<const ExternalMaster*>(master.source.get())) {
    recorded.made = RecordedMaster::Made::samples;
    recorded.tracker = heard->spec();
  } else if (const auto* read = dynamic_cast<const EncoderMaster*>(master.source.get())) {
    recorded.made = RecordedMaster::Made::readings;
    recorded.tracker = read->spec();
  }
  return recorded;
}

std::vector<RecordedAxis> recorded_axes(const std::vector<ExecutorOptions>& axes) {
  std::vector<RecordedAxis> all;
  for (const auto& axis : axes)
    all.push_back({.axis = all.size(),
                   .name = axis.receiver.executor,
                   .units = axis.units,
                   .config = resolved(axis.axis),
                   // A record has no path of a group, only its timing law.
                   .switches = !recordable(axis.compare) || axis.compare.plane.has_value() ||
                               (axis.group && axis.compare.list),
                   .outputs = axis.switches,
                   .compare = axis.compare});
  return all;
}

}  // namespace

std::vector<RecordedMaster> recorded_masters(const std::vector<MachineMaster>& masters,
                                             const std::vector<ExecutorOptions>& axes) {
  std::vector<RecordedMaster> all;
  for (const auto& master : masters) all.push_back(recorded(master, all.size()));
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i].follow.what == Follow::What::master)
      all[axes[i].follow.index].followers |= std::uint64_t{1} << i;
  return all;
}

RunRecord record_of(const RunOptions& run, const std::vector<ExecutorOptions>& axes) {
  RecorderOptions options = run.record;
  if (!options.log && !options.black_box) return {};
  if (!options.notify) options.notify = axes.front().notify;
  RunRecord record{.buffer = std::make_unique<RecordBuffer>()};
  record.recorder = std::make_unique<Recorder>(std::move(options), recorded_axes(axes),
                                               *record.buffer, recorded_masters(run.masters, axes));
  return record;
}

}  // namespace jounce::executor_detail
