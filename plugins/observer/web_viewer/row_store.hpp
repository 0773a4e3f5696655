// SPDX-License-Identifier: BSD-3-Clause
// All rows of a run, on disk: none is ever lost, and memory stays flat.
#pragma once

#include <string>
#include <vector>

#include "history_row.hpp"
#include "temporary_file.hpp"

namespace tolman::web_viewer {

class RowStore {
 public:
  void append(const std::vector<HistoryRow>& rows) {
    const auto bytes = std::as_bytes(std::span(rows));
    file_.write(size_ * sizeof(HistoryRow),
                {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    size_ += rows.size();
  }
  std::size_t size() const { return size_; }

  /// The bytes of at most `count` rows from `first` on; fewer at the end, none beyond it.
  std::string read(std::size_t first, std::size_t count) const {
    first = std::min(first, size_);
    std::string bytes(std::min(count, size_ - first) * sizeof(HistoryRow), '\0');
    file_.read(first * sizeof(HistoryRow), bytes);
    return bytes;
  }

 private:
  TemporaryFile file_;
  std::size_t size_ = 0;
};

}  // namespace tolman::web_viewer
