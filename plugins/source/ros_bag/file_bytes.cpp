// SPDX-License-Identifier: BSD-3-Clause
#include "file_bytes.hpp"

#include <algorithm>
#include <array>
#include <system_error>

#include "base/open_files.hpp"
#include "compression.hpp"

namespace tolman::ros_bag {
namespace fs = std::filesystem;

Result<FileBytes> FileBytes::open(const fs::path& path) {
  constexpr std::size_t kMaxInMemory = std::size_t{2} << 30U;
  std::error_code failure;
  FileBytes file;
  if (fs::is_regular_file(path, failure)) file.stream_.open(path, std::ios::binary);
  if (!file.stream_.is_open()) {
    return Status::invalidInput(path.string() + ": " +
                                file_opening::notOpened("not a readable file; check the path"));
  }
  file.size_ = fs::file_size(path, failure);
  if (failure) return Status::failed(path.string() + ": has no size; check the disk");
  std::array<std::uint8_t, 4> start{};
  if (!file.read(0, start) || !isZstd(start)) return file;
  const std::string remedy = "; unpack it: `zstd -d " + path.string() + "`";
  if (file.size_ > kMaxInMemory) {
    return Status::unsupported(path.string() + ": is too large to be unpacked in memory" + remedy);
  }
  std::vector<std::uint8_t> packed(static_cast<std::size_t>(file.size_));
  const bool read = file.read(0, packed);
  // Images are not compressed to less than a hundredth, so a larger file is not a bag.
  const std::size_t most = std::min(kMaxInMemory, 100 * packed.size() + (1U << 20U));
  auto unpacked = read ? unpackZstd(packed, most) : std::nullopt;
  if (!unpacked) {
    return Status::invalidInput(path.string() +
                                ": is compressed, and damaged or larger than 2 GiB" + remedy);
  }
  file.memory_ = std::move(*unpacked);
  file.size_ = file.memory_.size();
  file.in_memory_ = true;
  return file;
}

bool FileBytes::read(std::uint64_t at, std::span<std::uint8_t> bytes) {
  if (at > size_ || bytes.size() > size_ - at) return false;
  if (in_memory_) {
    std::copy_n(memory_.begin() + static_cast<std::ptrdiff_t>(at), bytes.size(), bytes.begin());
    return true;
  }
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(at));
  stream_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return static_cast<bool>(stream_);
}

}  // namespace tolman::ros_bag
