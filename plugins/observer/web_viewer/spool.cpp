// SPDX-License-Identifier: BSD-3-Clause
#include "spool.hpp"

namespace tolman::web_viewer {
namespace {

// Bytes; only whole blocks of the file system can be freed.
constexpr std::uint64_t kBlock = 4096;

std::uint64_t blocks(std::uint64_t size) { return (size + kBlock - 1) / kBlock * kBlock; }

}  // namespace

bool Spool::store(std::int64_t number, const std::string& message) {
  const std::uint64_t needed = blocks(message.size());
  if (needed > capacity_ || full_) return false;
  if (const auto old = extents_.find(number); old != extents_.end()) drop(old);
  while (used_ + needed > capacity_ && !full_) thin();
  if (full_) return false;
  file_.write(end_, message);
  extents_[number] = {end_, message.size()};
  end_ += needed;
  used_ += needed;
  return true;
}

Spool::Extents::iterator Spool::drop(Extents::iterator extent) {
  const std::uint64_t size = blocks(extent->second.size);
  full_ = !file_.release(extent->second.offset, size) || full_;
  used_ -= size;
  return extents_.erase(extent);
}

/// Drops the second, fourth, ... message; if there is only one message, drops it.
void Spool::thin() {
  auto extent = extents_.begin();
  if (extents_.size() > 1) ++extent;
  while (extent != extents_.end()) {
    extent = drop(extent);
    if (extent != extents_.end()) ++extent;
  }
}

std::optional<std::string> Spool::at(std::int64_t number) const {
  const auto found = extents_.find(number);
  if (found == extents_.end()) return std::nullopt;
  std::string message(found->second.size, '\0');
  file_.read(found->second.offset, message);
  return message;
}

std::optional<std::int64_t> Spool::atOrBefore(std::int64_t number) const {
  auto after = extents_.upper_bound(number);
  if (after == extents_.begin()) return std::nullopt;
  return std::prev(after)->first;
}

}  // namespace tolman::web_viewer
