// SPDX-License-Identifier: BSD-3-Clause
// A list for data that is kept for the whole run and grows with every frame. It grows in blocks of
// 64 KiB: a vector copies all elements when it grows, and the nodes of std::deque (512 bytes) each
// keep the page that they lie in, between the buffers of images that come and go. That took twice
// the memory of the data itself (docs/performance.md, Soak).
#pragma once

#include <boost/container/deque.hpp>
#include <memory>

namespace tolman::experience_map {

using LargeBlocks =
    boost::container::deque_options<boost::container::block_bytes<(1U << 16U)>>::type;

template <class T>
using GrowingList = boost::container::deque<T, std::allocator<T>, LargeBlocks>;

}  // namespace tolman::experience_map
