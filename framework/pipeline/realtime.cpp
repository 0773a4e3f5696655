// SPDX-License-Identifier: BSD-3-Clause
#include <oneapi/tbb/flow_graph.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <thread>

#include "pipeline/bounded_queue.hpp"
#include "pipeline/drive.hpp"
#include "pipeline/flow.hpp"

namespace tolman::pipeline {
namespace {

using Steady = std::chrono::steady_clock;

/// Feeds frames at the pace of their stamps. Nowhere else does the wall clock influence a result;
/// what it decides here (which frames are left out) is counted and recorded.
class PacedFeed {
 public:
  PacedFeed(Chain& chain, const config::PipelineSettings& options, const Cancellation& cancellation)
      : chain_(chain),
        options_(options),
        cancellation_(cancellation),
        queue_(static_cast<std::size_t>(options.queue), options.input_policy),
        flow_(graph_, chain, [this](const FrameRecords& records) { done(records); }) {}

  /// Returns how many frames were dropped.
  std::int64_t run() {
    graph_.reserve_wait();
    std::thread feeder([this] {
      feed();
      graph_.release_wait();
    });
    graph_.wait_for_all();
    feeder.join();
    return dropped_;
  }

 private:
  void feed() {
    const auto start = Steady::now();
    std::optional<std::int64_t> first_ns;
    while (!chain_.failed() && !cancellation_.requested()) {
      auto records = std::make_shared<FrameRecords>();
      const Status status = next(records->frame);
      if (!status.isOk()) {
        if (status.code() != StatusCode::EndOfStream) chain_.failInput(status);
        break;
      }
      if (!first_ns) first_ns = records->frame.stamp_ns;
      const double ahead_ns = static_cast<double>(records->frame.stamp_ns - *first_ns);
      waitUntil(start +
                std::chrono::nanoseconds(static_cast<std::int64_t>(ahead_ns / options_.speed)));
      if (const auto dropped = queue_.push(records)) reportDrop((*dropped)->frame.frame);
      pump();
    }
    drain();
  }

  Status next(Frame& frame) {
    const Activity::Mark mark(chain_.activity(), Role::Source);
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
      const bool late = 2 * chain_.placeBacklog() >= options_.queue;  // half of it waits
      chain_.admit(**records);
      (*records)->leave_out_place =
          late && options_.place_policy == config::PlacePolicy::DropNewest;
      flow_.entry().try_put(*records);
    }
  }

  void done(const FrameRecords&) {
    {
      const std::lock_guard lock(pump_mutex_);
      --in_flight_;
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
  std::int64_t dropped_ = 0;  // of the feeder thread until run() ends
};

}  // namespace

void runRealtime(Chain& chain, const config::PipelineSettings& options,
                 const Cancellation& cancellation) {
  PacedFeed feed(chain, options, cancellation);
  chain.counters().dropped = feed.run();
}

}  // namespace tolman::pipeline
