// SPDX-License-Identifier: BSD-3-Clause
// Observer `progress`: how far a run is, with counts of views, experiences and loops.
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

#include "base/progress_display.hpp"
#include "tolman/roles.hpp"

namespace tolman::progress {

class Progress final : public Observer {
 public:
  struct Parameters {
    bool quiet = false;

    static constexpr auto declaration() {
      return parameters(
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
  /// "12 templates, 8 experiences, 1 loop decision"
  std::string counts(std::int64_t loops, const char* loop) const;

  ProgressDisplay display_;
  bool quiet_ = false;
  const Clock* clock_ = nullptr;

  FrameCount frames_;  ///< left out: dropped in realtime, skipped, or without image
  std::int64_t templates_ = 0;
  std::int64_t experiences_ = 0;
  std::int64_t loop_decisions_ = 0;
  std::int64_t begin_ns_ = 0;
  std::int64_t first_frame_ = -1;  ///< of this session; -1 before it
};

}  // namespace tolman::progress
