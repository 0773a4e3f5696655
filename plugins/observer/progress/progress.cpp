// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <utility>

namespace tolman::progress {

namespace {

constexpr double kSecondsPerNs = 1e-9;

int terminalWidth() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

}  // namespace

Progress::Progress() : Progress(std::cerr, isatty(STDERR_FILENO) == 1, terminalWidth) {}

Progress::Progress(std::ostream& out, bool interactive, std::function<int()> width)
    : out_(out), width_(std::move(width)), interactive_(interactive) {}

Progress::~Progress() {
  if (drawn_ > 0) out_ << '\n' << std::flush;  // after a failure: its message starts a new line
}

Status Progress::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  clock_ = &context.clock;
  const char* no_colour = std::getenv("NO_COLOR");  // no-color.org: set and not empty
  colour_ = interactive_ && (no_colour == nullptr || *no_colour == '\0');
  return reset();
}

Status Progress::reset() {
  state_ = {};
  begin_ns_ = shown_ns_ = clock_->steadyNs();
  shown_frames_ = 0;
  first_frame_ = -1;
  if (drawn_ > 0) redraw("");
  return Status::ok();
}

Status Progress::begin(const RunInfo& run) {
  state_ = {};
  state_.total = run.source.frames;
  begin_ns_ = shown_ns_ = clock_->steadyNs();
  shown_frames_ = 0;
  first_frame_ = -1;
  if (interactive_ && !parameters_.quiet) redraw(barLine(state_, width_()));
  return Status::ok();
}

Status Progress::observe(const Snapshot& snapshot) {
  count(snapshot);
  const std::int64_t now = clock_->steadyNs();
  state_.seconds = static_cast<double>(now - begin_ns_) * kSecondsPerNs;
  constexpr std::int64_t kRedrawNs = 100'000'000;  // ten times a second
  if (parameters_.quiet) return Status::ok();
  const bool due = interactive_ ? now - shown_ns_ >= kRedrawNs : isLineDue();
  if (!due) return Status::ok();
  if (interactive_) {
    redraw(barLine(state_, width_()));
  } else {
    out_ << plainLine(state_) << '\n' << std::flush;
  }
  shown_ns_ = now;
  shown_frames_ = state_.frames;
  return Status::ok();
}

Status Progress::finish(const MapGraph& graph) {
  state_.seconds = static_cast<double>(clock_->steadyNs() - begin_ns_) * kSecondsPerNs;
  state_.experiences = static_cast<std::int64_t>(graph.experiences.size());
  state_.loop_links = std::count_if(graph.links.begin(), graph.links.end(), [&](const Link& link) {
    return link.kind == LinkKind::Loop && !graph.isRejected(link);
  });
  if (drawn_ > 0) redraw("");
  if (parameters_.quiet) return Status::ok();
  out_ << summaryLine(state_) << '\n' << std::flush;
  return Status::ok();
}

void Progress::count(const Snapshot& snapshot) {
  ++state_.frames;
  if (snapshot.frame != nullptr) {  // some frames may have been left out
    if (first_frame_ < 0) first_frame_ = snapshot.frame->frame;  // not 0 in later sessions
    const std::int64_t before = state_.frames;
    state_.frames = std::max(before, snapshot.frame->frame - first_frame_ + 1);
    state_.left_out += state_.frames - before;
  }
  if (snapshot.place != nullptr) {
    state_.templates = std::max(state_.templates, snapshot.place->template_id + 1);
  }
  if (snapshot.map != nullptr) state_.experiences = snapshot.map->experiences;
  if (snapshot.decision != nullptr && snapshot.decision->action == Action::CloseLoop) {
    ++state_.loop_decisions;
  }
}

bool Progress::isLineDue() const {
  const double silent = state_.seconds - static_cast<double>(shown_ns_ - begin_ns_) * kSecondsPerNs;
  if (parameters_.every_seconds > 0 && silent >= parameters_.every_seconds) return true;
  if (parameters_.every_percent <= 0 || state_.total <= 0) return false;
  // Write a line when the percentage has passed a multiple of every_percent since the last line.
  const auto multiple = [this](std::int64_t frames) {
    return std::int64_t(100.0 * static_cast<double>(frames) /
                        (static_cast<double>(state_.total) * parameters_.every_percent));
  };
  return multiple(state_.frames) > multiple(shown_frames_);
}

void Progress::redraw(const std::string& line) {
  // Blanks erase the rest of the old line; unlike control codes they work on every terminal.
  const std::size_t before = std::min(drawn_, static_cast<std::size_t>(std::max(width_() - 1, 0)));
  const std::string wipe(before > line.size() ? before - line.size() : 0, ' ');
  // A single write, so that a log line of another thread cannot come in between.
  out_ << "\r" + (colour_ ? coloured(line) : line) + wipe + (line.empty() ? "\r" : "")
       << std::flush;
  drawn_ = line.size();
}

}  // namespace tolman::progress
