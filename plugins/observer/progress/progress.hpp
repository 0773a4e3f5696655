// SPDX-License-Identifier: BSD-3-Clause
// Observer `progress`: one redrawn line on a terminal, otherwise a line at intervals.
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

#include "progress_text.hpp"
#include "tolman/roles.hpp"

namespace tolman::progress {

class Progress final : public Observer {
 public:
  struct Parameters {
    double every_percent = 10;
    double every_seconds = 5;
    bool quiet = false;

    static constexpr auto declaration() {
      return parameters(
          parameter("every_percent", &Parameters::every_percent)
              .range(0, 100)
              .unit("%")
              .doc("Without a terminal: a line each time this share is done; 0 for never."),
          parameter("every_seconds", &Parameters::every_seconds)
              .range(0, 86400)
              .unit("s")
              .doc("Without a terminal: longest time without a line; 0 for no limit."),
          parameter("quiet", &Parameters::quiet).doc("Show nothing; --quiet sets it."));
    }
  };

  /// Writes to stderr, as wide as its terminal is.
  Progress();
  /// For tests. `out` must outlive the object; `width` is called before each drawing.
  Progress(std::ostream& out, bool interactive, std::function<int()> width);
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  Status configure(const Context& context) override;
  Status reset() override;
  Status begin(const RunInfo& run) override;
  Status observe(const Snapshot& snapshot) override;
  Status finish(const MapGraph& graph) override;

 private:
  void count(const Snapshot& snapshot);
  bool isLineDue() const;
  void redraw(const std::string& line);

  std::ostream& out_;
  std::function<int()> width_;
  Parameters parameters_;
  const Clock* clock_ = nullptr;
  bool interactive_;  ///< `out_` is a terminal
  bool colour_ = false;

  ProgressState state_;
  std::int64_t begin_ns_ = 0;
  std::int64_t shown_ns_ = 0;      ///< ns, time of the last output
  std::int64_t shown_frames_ = 0;  ///< number of frames at the last output
  std::int64_t first_frame_ = -1;  ///< of this session; -1 before it
  std::size_t drawn_ = 0;          ///< characters of the line on the terminal
};

}  // namespace tolman::progress
