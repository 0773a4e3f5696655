// SPDX-License-Identifier: BSD-3-Clause
// All history rows of a run, in a temporary file: no row is dropped, and memory is constant.
#pragma once

#include <string>
#include <vector>

#include "container.hpp"
#include "history_row.hpp"
#include "temporary_file.hpp"

namespace tolman::web_viewer {

class RowStore {
 public:
  /// `values`: whole rows, one after the other.
  void append(const std::vector<double>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    file_.write(size_ * rowBytes(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    size_ += values.size() / rowColumns().size();
  }
  std::size_t size() const { return size_; }

  /// At most `count` rows from `first` on, as the array "rows"; fewer at the end, none beyond it.
  PackedArray read(std::size_t first, std::size_t count) const {
    first = std::min(first, size_);
    count = std::min(count, size_ - first);
    std::string bytes(count * rowBytes(), '\0');
    file_.read(first * rowBytes(), bytes);
    return {"rows",
            ElementType::F64,
            {count, rowColumns().size()},
            std::make_shared<const std::string>(std::move(bytes))};
  }

 private:
  static std::size_t rowBytes() { return rowColumns().size() * sizeof(double); }

  TemporaryFile file_;
  std::size_t size_ = 0;
};

}  // namespace tolman::web_viewer
