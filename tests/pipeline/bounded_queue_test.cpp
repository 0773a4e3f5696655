// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/bounded_queue.hpp"

#include <catch2/catch.hpp>
#include <thread>

using tolman::config::QueuePolicy;
using tolman::pipeline::BoundedQueue;

TEST_CASE("a queue gives back in order what went in") {
  BoundedQueue<int> queue(3, QueuePolicy::DropNewest);
  CHECK(queue.empty());
  for (const int item : {1, 2, 3}) CHECK_FALSE(queue.push(item));
  for (const int item : {1, 2, 3}) CHECK(queue.pop() == item);
  CHECK_FALSE(queue.pop());
}

TEST_CASE("a full queue drops what its policy says, and tells") {
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
