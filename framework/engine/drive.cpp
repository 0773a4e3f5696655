// SPDX-License-Identifier: BSD-3-Clause
#include <oneapi/tbb/flow_graph.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/chain.hpp"

namespace tolman::engine {
namespace {

namespace flow = tbb::flow;
using Steady = std::chrono::steady_clock;

/// The work of a node of the flow.
auto node(Chain& chain, Role role, void (Chain::*work)(FrameRecords&)) {
  return [&chain, role, work](const FrameRecordsPtr& records) {
    chain.guarded(role, [&] { (chain.*work)(*records); });
    return records;
  };
}

/// The stages as a oneTBB flow graph: odometry and place recognition side by side (or one after the
/// other, where place recognition needs the motion), then cells and map, then recorder and
/// observers. Each node processes one frame at a time, in the order of arrival. A serial node may
/// still emit its outputs out of order (the next body can start before the last result is passed
/// on), so every node has a sequencer before it.
class Flow {
 public:
  /// `on_done` is called in order, once for each frame that entered.
  Flow(flow::graph& graph, Chain& chain, std::function<void(const FrameRecords&)> on_done)
      : entry_(graph, kSequenceOf),
        fork_(graph),
        odometry_(graph, flow::serial, node(chain, Role::Odometry, &Chain::odometry)),
        after_odometry_(graph, kSequenceOf),
        place_(graph, flow::serial, node(chain, Role::Place, &Chain::place)),
        after_place_(graph, kSequenceOf),
        join_(graph),
        pair_(graph, flow::serial, [](const Pair& pair) { return std::get<0>(pair); }),
        before_cells_and_map_(graph, kSequenceOf),
        cells_and_map_(graph, flow::serial, node(chain, Role::Map, &Chain::runCellsAndMap)),
        after_cells_and_map_(graph, kSequenceOf),
        publish_(graph, flow::serial,
                 [publish = node(chain, Role::Observer, &Chain::publish),
                  done = std::move(on_done)](const FrameRecordsPtr& records) {
                   publish(records);
                   done(*records);
                   return records;
                 }) {
    flow::make_edge(entry_, fork_);
    flow::make_edge(fork_, odometry_);
    flow::make_edge(odometry_, after_odometry_);
    flow::make_edge(place_, after_place_);
    if (chain.placeNeedsMotion()) {
      flow::make_edge(after_odometry_, place_);
      flow::make_edge(after_place_, before_cells_and_map_);
    } else {
      flow::make_edge(fork_, place_);
      flow::make_edge(after_odometry_, flow::input_port<0>(join_));
      flow::make_edge(after_place_, flow::input_port<1>(join_));
      flow::make_edge(join_, pair_);
      flow::make_edge(pair_, before_cells_and_map_);
    }
    flow::make_edge(before_cells_and_map_, cells_and_map_);
    flow::make_edge(cells_and_map_, after_cells_and_map_);
    flow::make_edge(after_cells_and_map_, publish_);
  }

  flow::receiver<FrameRecordsPtr>& entry() { return entry_; }

 private:
  using Node = flow::function_node<FrameRecordsPtr, FrameRecordsPtr>;
  using Sequencer = flow::sequencer_node<FrameRecordsPtr>;
  using Pair = std::tuple<FrameRecordsPtr, FrameRecordsPtr>;
  static constexpr auto kSequenceOf = [](const FrameRecordsPtr& records) {
    return records->sequence;
  };

  Sequencer entry_;
  flow::broadcast_node<FrameRecordsPtr> fork_;
  Node odometry_;
  Sequencer after_odometry_;
  Node place_;
  Sequencer after_place_;
  flow::join_node<Pair, flow::queueing> join_;
  flow::function_node<Pair, FrameRecordsPtr> pair_;
  Sequencer before_cells_and_map_;
  Node cells_and_map_;
  Sequencer after_cells_and_map_;
  Node publish_;
};

void runLossless(Chain& chain, const config::PipelineSettings& options,
                 const Cancellation& cancellation) {
  flow::graph graph;
  flow::input_node<FrameRecordsPtr> source(graph, [&](tbb::flow_control& control) {
    FrameRecordsPtr records;
    chain.guarded(Role::Source, [&] {
      FrameRecordsPtr next = chain.readFrame(cancellation);
      if (next) chain.admit(*next);
      records = std::move(next);
    });
    if (!records) control.stop();
    return records;
  });
  flow::limiter_node<FrameRecordsPtr> limiter(graph, static_cast<std::size_t>(options.queue));
  Flow stages(graph, chain,
              [&](const FrameRecords&) { limiter.decrementer().try_put(flow::continue_msg()); });
  flow::make_edge(source, limiter);
  flow::make_edge(limiter, stages.entry());
  source.activate();
  graph.wait_for_all();
}

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
    const bool is_live = chain_.stages().source.instance().manifest().hasExtra("live");
    const auto start = Steady::now();
    std::optional<std::int64_t> first_ns;
    for (;;) {
      auto records = chain_.readFrame(cancellation_);
      if (!records) break;
      const std::int64_t stamp_ns = records->frame.stamp_ns;
      if (!first_ns) first_ns = stamp_ns;
      const double ahead_ns = static_cast<double>(stamp_ns - *first_ns);
      const auto due =
          start + std::chrono::nanoseconds(static_cast<std::int64_t>(ahead_ns / options_.speed));
      if (!is_live) waitUntil(due);  // a live camera has its own pace
      records->exposed = is_live ? Steady::now() : due;
      enqueue(records);
      pump();
    }
    drain();
  }

  /// Sleeps in short pieces, so that a cancellation takes effect within 50 ms.
  void waitUntil(Steady::time_point when) const {
    while (!cancellation_.requested() && Steady::now() < when) {
      std::this_thread::sleep_until(std::min(when, Steady::now() + std::chrono::milliseconds(50)));
    }
  }

  /// A full queue drops its oldest frame, or makes the source wait.
  void enqueue(const FrameRecordsPtr& records) {
    const auto capacity = static_cast<std::size_t>(options_.queue);
    std::unique_lock lock(pump_mutex_);
    if (options_.input_policy == config::QueuePolicy::Block) {
      room_.wait(lock, [&] { return queue_.size() < capacity; });
    }
    queue_.push_back(records);
    FrameRecordsPtr dropped;
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
      chain_.admit(*records);
      flow_.entry().try_put(records);
    }
  }

  void done(const FrameRecords& records) {
    {
      const std::lock_guard lock(pump_mutex_);
      --in_flight_;
      if (records.answered) {
        const std::chrono::duration<float, std::milli> took = records.posed - records.exposed;
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
    return {frames, percentile(50), percentile(99)};
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
  std::int64_t dropped_ = 0;  // used by the feeder thread until run() ends
};

}  // namespace

int concurrency(int threads) { return threads > 0 ? threads : tbb::info::default_concurrency(); }

DriveResult drive(Chain& chain, const config::PipelineSettings& options, int threads,
                  const Cancellation& cancellation) {
  const int workers = concurrency(threads);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(workers));
  tbb::task_arena arena(workers);
  bool interrupted = false;
  Latency latency;
  arena.execute([&] {
    chain.guarded(Role::Source, [&] {
      if (options.mode == config::PipelineMode::Lossless) {
        runLossless(chain, options, cancellation);
      } else {
        latency = PacedFeed(chain, options, cancellation).run();
      }
    });
    interrupted = cancellation.requested();
    if (interrupted) chain.saveNow();  // before finish(), which changes the state
    chain.finish();  // an observer may block here until cancellation, e.g. to serve a page
  });
  return {chain.failure(), interrupted, chain.counters(), chain.finishTimes(), latency};
}

}  // namespace tolman::engine
