// SPDX-License-Identifier: BSD-3-Clause
// The findings of all stages of a run (Context::findings): recorded one by one, printed once per
// kind with their number, and judged by the key `on_findings`.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "base/record_rows.hpp"
#include "config/settings.hpp"
#include "tolman/context.hpp"

namespace tolman::engine {

/// The text with `#` for its numbers, which differ within one kind of warnings.
std::string withoutNumbers(const std::string& text);

/// Callable from any thread.
class Findings {
 public:
  explicit Findings(config::FindingPolicy policy = config::FindingPolicy::Continue)
      : policy_(policy) {}

  void add(const std::string& stage, Finding finding);
  /// After a call at `frame` (-1: configure) that answered `status`: the status, or the first error
  /// that was found since the last call of this function, if errors stop the run.
  Status judge(const Status& status, std::int64_t frame);

  /// One kind of findings: those of one stage that differ in numbers and places alone.
  struct Kind {
    record::RecordedFinding first;
    std::int64_t count = 0;
    std::int64_t printed = 0;  ///< of them, those that a line counted

    LogLevel level() const;
    /// "WHERE: MESSAGE; REMEDY (and N more)".
    std::string text() const;
  };
  /// What to print now: the kinds that were never printed.
  std::vector<Kind> takeNewKinds() { return takeKinds(true); }
  /// What to print at the end: the kinds with more findings than were printed.
  std::vector<Kind> takeGrownKinds() { return takeKinds(false); }
  /// The findings that were not taken yet; during a run only those whose frame is known.
  std::vector<record::RecordedFinding> take(bool at_end = true);

 private:
  std::vector<Kind> takeKinds(bool are_new);
  std::mutex mutex_;
  config::FindingPolicy policy_;
  std::vector<record::RecordedFinding> untaken_;
  std::size_t addressed_ = 0;                 ///< of `untaken_`: their frame is known
  std::vector<Kind> kinds_;                   ///< in the order of their first finding
  std::map<std::string, std::size_t> index_;  ///< of `kinds_`, by stage, severity and text
  std::size_t judged_ = 0;                    ///< of `kinds_`
};

/// The collector of one stage.
class StageFindings : public FindingCollector {
 public:
  StageFindings(Findings& all, std::string stage) : all_(all), stage_(std::move(stage)) {}
  void add(Finding finding) override { all_.add(stage_, std::move(finding)); }

 private:
  Findings& all_;
  std::string stage_;
};

}  // namespace tolman::engine
