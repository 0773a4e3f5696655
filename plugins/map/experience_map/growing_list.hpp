// SPDX-License-Identifier: BSD-3-Clause
// A list for data that is kept for the whole run and grows with every frame, in blocks of 64 KiB. A
// vector would copy all elements when it grows. The nodes of std::deque (512 bytes) would lie
// between the buffers of images, and keep those pages from being returned to the system when the
// images are freed: twice the memory of the data itself (docs/results.md).
#pragma once

#include <boost/container/deque.hpp>
#include <memory>

namespace tolman::experience_map {

using LargeBlocks =
    boost::container::deque_options<boost::container::block_bytes<(1U << 16U)>>::type;

template <class T>
using GrowingList = boost::container::deque<T, std::allocator<T>, LargeBlocks>;

}  // namespace tolman::experience_map
