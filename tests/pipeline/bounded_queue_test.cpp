// SPDX-License-Identifier: BSD-3-Clause
#include "engine/bounded_queue.hpp"

#include <catch2/catch.hpp>
#include <deque>
#include <thread>
#include <vector>

#include "tolman/context.hpp"

using tolman::config::QueuePolicy;
using tolman::pipeline::BoundedQueue;

TEST_CASE("a queue gives back in order what went in") {
  BoundedQueue<int> queue(3, QueuePolicy::DropNewest);
  CHECK(queue.empty());
  for (const int item : {1, 2, 3}) CHECK_FALSE(queue.push(item));
  for (const int item : {1, 2, 3}) CHECK(queue.pop() == item);
  CHECK_FALSE(queue.pop());
}

TEST_CASE("a full queue drops by its policy, and returns what it dropped") {
  BoundedQueue<int> newest(2, QueuePolicy::DropNewest);
  BoundedQueue<int> oldest(2, QueuePolicy::DropOldest);
  for (const int item : {1, 2}) {
    CHECK_FALSE(newest.push(item));
    CHECK_FALSE(oldest.push(item));
  }
  CHECK(newest.push(3) == 3);
  CHECK(oldest.push(3) == 1);
  CHECK(newest.pop() == 1);
  CHECK(oldest.pop() == 2);
}

TEST_CASE("a blocking queue waits for room and drops nothing") {
  BoundedQueue<int> queue(1, QueuePolicy::Block);
  std::thread producer([&] {
    for (int item = 0; item < 100; ++item) (void)queue.push(item);
  });
  for (int expected = 0; expected < 100;) {
    if (const auto item = queue.pop()) CHECK(*item == expected++);
  }
  producer.join();
  CHECK(queue.empty());
}

TEST_CASE("any sequence of calls does what a list would") {
  for (const QueuePolicy policy : {QueuePolicy::DropNewest, QueuePolicy::DropOldest}) {
    tolman::RandomStream random(19);
    BoundedQueue<int> queue(4, policy);
    std::deque<int> list;
    for (int i = 0; i < 5000; ++i) {
      if (random.below(2) == 0) {
        const auto item = queue.pop();
        REQUIRE(item.has_value() == !list.empty());
        if (!item) continue;
        REQUIRE(*item == list.front());
        list.pop_front();
      } else {
        const auto dropped = queue.push(i);
        list.push_back(i);
        REQUIRE(dropped.has_value() == (list.size() > 4));
        if (!dropped) continue;
        const bool newest = policy == QueuePolicy::DropNewest;
        REQUIRE(*dropped == (newest ? list.back() : list.front()));
        newest ? list.pop_back() : list.pop_front();
      }
      REQUIRE(queue.empty() == list.empty());
    }
  }
}

TEST_CASE("of several producers nothing is lost or doubled, and each one's order is kept") {
  BoundedQueue<std::pair<int, int>> queue(3, QueuePolicy::Block);
  std::vector<std::thread> producers;
  for (int p = 0; p < 4; ++p) {
    producers.emplace_back([&queue, p] {
      for (int i = 0; i < 500; ++i) (void)queue.push({p, i});
    });
  }
  std::array<int, 4> next{};
  for (int taken = 0; taken < 2000;) {
    const auto item = queue.pop();
    if (!item) continue;
    CHECK(item->second == next[static_cast<std::size_t>(item->first)]++);
    ++taken;
  }
  for (std::thread& producer : producers) producer.join();
  CHECK(queue.empty());
}
