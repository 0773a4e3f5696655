// SPDX-License-Identifier: BSD-3-Clause
#include <oneapi/tbb/flow_graph.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/bounded_queue.hpp"
#include "engine/drive.hpp"
#include "engine/flow.hpp"
#include "engine/input_end.hpp"

namespace tolman::pipeline {
namespace {

using Steady = std::chrono::steady_clock;

/// Feeds frames at the pace of their stamps. Only here the wall clock affects results: it decides
/// which frames are left out. They are counted and recorded.
class PacedFeed {
 public:
  PacedFeed(Chain& chain, const config::PipelineSettings& options, const Cancellation& cancellation)
      : chain_(chain),
        options_(options),
        cancellation_(cancellation),
        queue_(static_cast<std::size_t>(options.queue), options.input_policy),
        flow_(graph_, chain, [this](const FrameRecords& records) { done(records); }) {}

  /// Latency of the run; call it after run().
  Latency latency() { return latencies_.result(clock_); }

  /// Returns how many frames were dropped.
  std::int64_t run() {
    const WaitForGraph at_end(graph_);
    std::thread feeder = startFeeder();
    chain_.guarded(Role::Source, [this] { graph_.wait_for_all(); });
    feeder.join();
    return dropped_;
  }

 private:
  std::thread startFeeder() {
    graph_.reserve_wait();
    try {
      return std::thread([this] {
        chain_.guarded(Role::Source, [this] { feed(); });
        graph_.release_wait();
      });
    } catch (...) {  // no thread
      graph_.release_wait();
      throw;
    }
  }
  void feed() {
    const auto start = Steady::now();
    std::optional<std::int64_t> first_ns;
    while (!chain_.failed() && !cancellation_.requested()) {
      auto records = std::make_shared<FrameRecords>();
      const Status status = next(records->frame);
      if (!status.isOk()) {
        if (!isEndOfInput(status, cancellation_)) chain_.failInput(status);
        break;
      }
      const std::int64_t stamp_ns = records->frame.stamp_ns;
      if (!first_ns) {
        first_ns = stamp_ns;
        chooseClock(stamp_ns);
      }
      const double ahead_ns = static_cast<double>(stamp_ns - *first_ns);
      const auto due =
          start + std::chrono::nanoseconds(static_cast<std::int64_t>(ahead_ns / options_.speed));
      waitUntil(due);
      records->exposed = clock_ == ExposureClock::Pace
                             ? std::chrono::nanoseconds(due.time_since_epoch())
                             : std::chrono::nanoseconds(stamp_ns) - ahead_of_steady_;
      if (const auto dropped = queue_.push(records)) reportDrop((*dropped)->frame.frame);
      pump();
    }
    drain();
  }

  void chooseClock(std::int64_t stamp_ns) {
    const std::chrono::nanoseconds steady = Steady::now().time_since_epoch();
    const std::chrono::nanoseconds system = std::chrono::system_clock::now().time_since_epoch();
    clock_ =
        exposureClock(chain_.stages().source.isEndless(), stamp_ns, steady.count(), system.count());
    if (clock_ == ExposureClock::System) ahead_of_steady_ = system - steady;
  }

  Status next(Frame& frame) {
    const StageActivity::Mark mark(chain_.stageActivity(), Role::Source);
    return chain_.stages().source.next(frame);
  }

  /// Sleeps in short pieces, so that a cancellation takes effect within 50 ms.
  void waitUntil(Steady::time_point when) const {
    while (!cancellation_.requested() && Steady::now() < when) {
      std::this_thread::sleep_until(std::min(when, Steady::now() + std::chrono::milliseconds(50)));
    }
  }

  /// Returns when all queued frames have entered the graph.
  void drain() {
    while (!queue_.empty()) {
      pump();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  void pump() {
    const std::lock_guard lock(pump_mutex_);
    while (in_flight_ < options_.queue) {
      auto records = queue_.pop();
      if (!records) return;
      ++in_flight_;
      const bool late = 2 * chain_.placeBacklog() >= options_.queue;  // at least half of it waits
      chain_.admit(**records);
      (*records)->leave_out_place =
          late && options_.place_policy == config::PlacePolicy::DropNewest;
      flow_.entry().try_put(*records);
    }
  }

  void done(const FrameRecords& records) {
    {
      const std::lock_guard lock(pump_mutex_);
      --in_flight_;
      if (records.answered) latencies_.add(records.posed.time_since_epoch() - records.exposed);
    }
    pump();
  }

  void reportDrop(std::int64_t frame) {
    ++dropped_;
    chain_.listener().onEvent({frame, LogLevel::Warning, "pipeline",
                               "frame dropped: the stages are slower than the data"});
  }

  Chain& chain_;
  const config::PipelineSettings& options_;
  const Cancellation& cancellation_;
  BoundedQueue<FrameRecordsPtr> queue_;
  tbb::flow::graph graph_;
  Flow flow_;
  std::mutex pump_mutex_;
  int in_flight_ = 0;
  LatencyMeter latencies_;
  ExposureClock clock_ = ExposureClock::Pace;   // used by the feeder thread; likewise the next
  std::chrono::nanoseconds ahead_of_steady_{};  // stamps minus steady clock
  std::int64_t dropped_ = 0;                    // used by the feeder thread until run() ends
};

}  // namespace

Latency runRealtime(Chain& chain, const config::PipelineSettings& options,
                    const Cancellation& cancellation) {
  PacedFeed feed(chain, options, cancellation);
  chain.counters().dropped = feed.run();
  return feed.latency();
}

}  // namespace tolman::pipeline
