// SPDX-License-Identifier: BSD-3-Clause
// Progress of a sweep on stderr: on a terminal a table that is redrawn, otherwise a line for each
// run that has ended.
#pragma once

#include <ostream>

#include "app/progress_line.hpp"
#include "experiment/local_jobs.hpp"

namespace tolman::app {

class SweepDisplay : public experiment::JobsListener {
 public:
  SweepDisplay(std::ostream& out, Terminal terminal) : out_(out), terminal_(terminal) {}
  /// Erases the table.
  ~SweepDisplay() override;
  SweepDisplay(const SweepDisplay&) = delete;
  SweepDisplay& operator=(const SweepDisplay&) = delete;

  void onState(const experiment::JobsState& state) override;
  void onEnd(const experiment::PlannedRun& run, const experiment::PointOutcome& outcome,
             const experiment::JobsState& state) override;

 private:
  void wipe();

  std::ostream& out_;
  Terminal terminal_;
  std::size_t drawn_ = 0;  ///< lines of the table on the terminal
  double shown_s_ = -1;    ///< time of the last drawing
};

/// "37 of 300, 2 failed, 1:05 left"
std::string jobsText(const experiment::JobsState& state);

}  // namespace tolman::app
