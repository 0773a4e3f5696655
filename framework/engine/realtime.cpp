// SPDX-License-Identifier: BSD-3-Clause
#include <oneapi/tbb/flow_graph.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/drive.hpp"
#include "engine/flow.hpp"

namespace tolman::engine {
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
        flow_(graph_, chain, [this](const FrameRecords& records) { done(records); }) {}

  /// Returns the latency of the run.
  Latency run() {
    graph_.reserve_wait();
    std::thread feeder;
    try {
      feeder = std::thread([this] {
        chain_.guarded(Role::Source, [this] { feed(); });
        graph_.release_wait();
      });
    } catch (...) {  // no thread
      graph_.release_wait();
      throw;
    }
    graph_.wait_for_all();
    feeder.join();
    chain_.counters().dropped = dropped_;
    return latency();
  }

 private:
  void feed() {
    const auto start = Steady::now();
    std::optional<std::int64_t> first_ns;
    while (!chain_.failed() && !cancellation_.requested()) {
      auto records = std::make_shared<FrameRecords>();
      const Status status = chain_.readFrame(*records);
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
      enqueue(records);
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

  /// Sleeps in short pieces, so that a cancellation takes effect within 50 ms.
  void waitUntil(Steady::time_point when) const {
    while (!cancellation_.requested() && Steady::now() < when) {
      std::this_thread::sleep_until(std::min(when, Steady::now() + std::chrono::milliseconds(50)));
    }
  }

  /// A full queue drops its oldest frame or the new one, or makes the source wait.
  void enqueue(const FrameRecordsPtr& records) {
    const auto capacity = static_cast<std::size_t>(options_.queue);
    std::unique_lock lock(pump_mutex_);
    if (options_.input_policy == config::QueuePolicy::Block) {
      room_.wait(lock, [&] { return queue_.size() < capacity; });
    }
    FrameRecordsPtr dropped;
    if (queue_.size() < capacity || options_.input_policy == config::QueuePolicy::DropOldest) {
      queue_.push_back(records);
    } else {
      dropped = records;
    }
    if (queue_.size() > capacity) {
      dropped = queue_.front();
      queue_.pop_front();
    }
    lock.unlock();
    if (dropped) reportDrop(dropped->frame.frame);
  }

  /// Returns when all queued frames have entered the graph.
  void drain() {
    std::unique_lock lock(pump_mutex_);
    room_.wait(lock, [&] { return queue_.empty(); });
  }

  void pump() {
    const std::lock_guard lock(pump_mutex_);
    while (in_flight_ < options_.queue && !queue_.empty()) {
      const FrameRecordsPtr records = queue_.front();
      queue_.pop_front();
      room_.notify_all();
      ++in_flight_;
      const bool late = 2 * chain_.placeBacklog() >= options_.queue;  // at least half of it waits
      chain_.admit(*records);
      records->leave_out_place = late && options_.place_policy == config::PlacePolicy::DropNewest;
      flow_.entry().try_put(records);
    }
  }

  void done(const FrameRecords& records) {
    {
      const std::lock_guard lock(pump_mutex_);
      --in_flight_;
      if (records.answered) {
        const std::chrono::duration<float, std::milli> took =
            records.posed.time_since_epoch() - records.exposed;
        latencies_ms_.push_back(took.count());
      }
    }
    pump();
  }

  Latency latency() {
    if (latencies_ms_.empty()) return {};
    const auto percentile = [&](std::size_t percent) {
      const std::size_t rank = (latencies_ms_.size() * percent + 99) / 100;
      const auto at = latencies_ms_.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
      std::nth_element(latencies_ms_.begin(), at, latencies_ms_.end());
      return static_cast<double>(*at);
    };
    const auto frames = static_cast<std::int64_t>(latencies_ms_.size());
    return {frames, percentile(50), percentile(99), clock_};
  }

  void reportDrop(std::int64_t frame) {
    ++dropped_;
    chain_.listener().onEvent({frame, LogLevel::Warning, "pipeline",
                               "frame dropped: the stages are slower than the data"});
  }

  Chain& chain_;
  const config::PipelineSettings& options_;
  const Cancellation& cancellation_;
  tbb::flow::graph graph_;
  Flow flow_;
  std::mutex pump_mutex_;  // guards the next four
  std::condition_variable room_;
  std::deque<FrameRecordsPtr> queue_;
  int in_flight_ = 0;
  std::vector<float> latencies_ms_;
  ExposureClock clock_ = ExposureClock::Pace;   // used by the feeder thread; likewise the next
  std::chrono::nanoseconds ahead_of_steady_{};  // stamps minus steady clock
  std::int64_t dropped_ = 0;                    // used by the feeder thread until run() ends
};

}  // namespace

ExposureClock exposureClock(bool is_endless, std::int64_t stamp_ns, std::int64_t monotonic_ns,
                            std::int64_t system_ns) {
  constexpr std::int64_t kRecent = 5'000'000'000;  // ns
  const auto recent = [&](std::int64_t now) { return stamp_ns <= now && now - stamp_ns < kRecent; };
  if (is_endless && recent(monotonic_ns)) return ExposureClock::Monotonic;
  return is_endless && recent(system_ns) ? ExposureClock::System : ExposureClock::Pace;
}

Latency runRealtime(Chain& chain, const config::PipelineSettings& options,
                    const Cancellation& cancellation) {
  return PacedFeed(chain, options, cancellation).run();
}

}  // namespace tolman::engine
