// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep_display.hpp"

#include <fmt/format.h>

#include "app/duration_text.hpp"
#include "engine/terminal.hpp"

namespace tolman::app {
namespace {

constexpr double kRedraw = 0.2;       // s between two drawings
constexpr std::size_t kColumns = 78;  // most characters of a run's name

}  // namespace

std::string jobsText(const experiment::JobsState& state) {
  std::string text = fmt::format("{} of {}", state.ended, state.all);
  if (state.failed > 0) text += fmt::format(", {} failed", state.failed);
  if (state.lost > 0) text += fmt::format(", {} lost tracking", state.lost);
  if (state.ended > 0 && state.ended < state.all) {
    const double left = state.seconds / static_cast<double>(state.ended) *
                        static_cast<double>(state.all - state.ended);
    text += ", " + durationText(left) + " left";
  }
  return text;
}

SweepDisplay::~SweepDisplay() { wipe(); }

void SweepDisplay::wipe() {
  for (; drawn_ > 0; --drawn_) out_ << "\x1b[1A\x1b[2K";
  out_.flush();
}

void SweepDisplay::onState(const experiment::JobsState& state) {
  if (!terminal_.interactive || terminal_.quiet || state.seconds - shown_s_ < kRedraw) return;
  shown_s_ = state.seconds;
  wipe();
  out_ << jobsText(state) << "\n";
  for (const std::string& name : state.running) {
    out_ << "  " << run::printable(name).substr(0, kColumns) << "\n";
  }
  drawn_ = 1 + state.running.size();
  out_.flush();
}

void SweepDisplay::onEnd(const experiment::PlannedRun& run, const experiment::PointOutcome& outcome,
                         const experiment::JobsState& state) {
  const bool failed = outcome.state == experiment::PointState::Failed;
  if (!failed && (terminal_.interactive || terminal_.quiet)) return;
  wipe();
  shown_s_ = -1;
  out_ << run::printable(fmt::format("{:<20} {:<7} {:7.1f} s  {}", jobsText(state),
                                     enumName(outcome.state), outcome.wall_s, run.name));
  if (failed) out_ << "\n    " << run::printable(outcome.message);
  out_ << "\n";
  out_.flush();
}

}  // namespace tolman::app
