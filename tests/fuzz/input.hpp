// SPDX-License-Identifier: BSD-3-Clause
// Tools for fuzz targets: numbers and texts from the bytes of the input, inputs as files, and a
// check whose failure is a crash.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tolman::fuzz {

using Bytes = std::span<const std::uint8_t>;

inline std::string_view asText(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Ends the process as a finding unless `sound`.
void require(bool sound, const char* what);

/// Takes numbers from the front of an input; zero beyond its end.
class Input {
 public:
  explicit Input(Bytes bytes) : bytes_(bytes) {}

  template <class T>
  T take() requires std::is_arithmetic_v<T> {
    T value{};
    const std::size_t size = std::min(sizeof value, bytes_.size());
    if (size > 0) std::memcpy(&value, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
    return value;
  }
  Bytes rest() const { return bytes_; }

 private:
  Bytes bytes_;
};

/// The input as a regular file in memory.
class MemoryFile {
 public:
  explicit MemoryFile(Bytes bytes);
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  int descriptor_;
  std::filesystem::path path_;
};

/// An empty folder, in memory where the system has such; removed with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

/// The parts of an input between lines that are "%%" and nothing else.
std::vector<std::string_view> partsOf(std::string_view text);

}  // namespace tolman::fuzz
