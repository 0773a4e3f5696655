// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <utility>

namespace tolman::progress {
namespace {

std::string counted(std::int64_t number, const std::string& what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

}  // namespace

Progress::Progress() : Progress(std::cerr, isatty(STDERR_FILENO) == 1, terminalWidth) {}

Progress::Progress(std::ostream& out, bool interactive, std::function<int()> width)
    : display_(out, interactive, std::move(width)) {}

Progress::~Progress() {
  display_.line().keep();  // a failure's message starts a new line
}

Status Progress::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  quiet_ = bound.value().quiet;
  clock_ = &context.clock;
  return reset();
}

Status Progress::reset() {
  frames_ = {};
  templates_ = experiences_ = loop_decisions_ = 0;
  first_frame_ = -1;
  begin_ns_ = clock_->steadyNs();
  display_.begin(begin_ns_);
  return Status::ok();
}

Status Progress::begin(const RunInfo& run) {
  static_cast<void>(reset());
  frames_.total = run.source.frames;
  return Status::ok();
}

Status Progress::observe(const Snapshot& snapshot) {
  count(snapshot);
  const std::int64_t now = clock_->steadyNs();
  frames_.seconds = static_cast<double>(now - begin_ns_) * 1e-9;
  if (quiet_ || !display_.isDue(frames_, now)) return Status::ok();
  display_.show(frameText(frames_) + ", " + counts(loop_decisions_, "loop decision"), frames_, now);
  return Status::ok();
}

Status Progress::finish(const MapGraph& graph) {
  frames_.seconds = static_cast<double>(clock_->steadyNs() - begin_ns_) * 1e-9;
  experiences_ = static_cast<std::int64_t>(graph.experiences.size());
  const auto loops = std::ranges::count_if(graph.links, [&](const Link& link) {
    return link.kind == LinkKind::Loop && !graph.isRejected(link);
  });
  if (quiet_) return Status::ok();
  std::string text = counted(frames_.done - frames_.left_out, "frame");
  if (frames_.left_out > 0) {
    text += " processed and " + std::to_string(frames_.left_out) + " left out";
  }
  display_.line().add(text + " in " + durationText(frames_.seconds) + ", " + speedText(frames_) +
                      ", " + counts(loops, "loop link"));
  return Status::ok();
}

std::string Progress::counts(std::int64_t loops, const char* loop) const {
  return counted(templates_, "template") + ", " + counted(experiences_, "experience") + ", " +
         counted(loops, loop);
}

void Progress::count(const Snapshot& snapshot) {
  ++frames_.done;
  if (snapshot.frame != nullptr) {  // some frames may have been left out
    if (first_frame_ < 0) first_frame_ = snapshot.frame->frame;  // not 0 in later sessions
    const std::int64_t before = frames_.done;
    frames_.done = std::max(before, snapshot.frame->frame - first_frame_ + 1);
    frames_.left_out += frames_.done - before;
  }
  if (snapshot.place != nullptr) {
    templates_ = std::max(templates_, snapshot.place->template_id + 1);
  }
  if (snapshot.map != nullptr) experiences_ = snapshot.map->experiences;
  if (snapshot.decision != nullptr && snapshot.decision->action == Action::CloseLoop) {
    ++loop_decisions_;
  }
}

}  // namespace tolman::progress
