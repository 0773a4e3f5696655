// SPDX-License-Identifier: BSD-3-Clause
// A problem of a data set that ends its reading.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "tolman/status.hpp"

namespace tolman::source_parameters {

/// Thrown by readers of files, caught where a source is configured.
class DataError : public std::runtime_error {
 public:
  /// "FILE:LINE: what; remedy". `line`: from 1; 0 for the whole file.
  DataError(const std::filesystem::path& file, int line, const std::string& what)
      : DataError(Status::invalidInput(
            file.string() + (line > 0 ? ":" + std::to_string(line) : "") + ": " + what)) {}
  DataError(const std::filesystem::path& file, const std::string& what)
      : DataError(file, 0, what) {}
  explicit DataError(const Status& failure)
      : std::runtime_error(failure.message()), status_(failure) {}

  const Status& status() const { return status_; }

 private:
  Status status_;
};

/// The value; its failure, which names the file, as a DataError.
template <class T>
T valueOf(Result<T> result) {
  if (!result.isOk()) throw DataError(result.status());
  return std::move(result).value();
}

}  // namespace tolman::source_parameters
