// SPDX-License-Identifier: BSD-3-Clause
#include "chunked_file.hpp"

#include <algorithm>

#include "bag_problems.hpp"

namespace tolman::ros_bag {

std::optional<ChunkedFile::Contents> ChunkedFile::readBytes(std::uint64_t at, std::uint64_t size,
                                                            std::uint64_t record,
                                                            Problems& problems) {
  if (size > file_.size() - at) {
    problems.push_back(endsWithin(record));
    return std::nullopt;
  }
  if (size > kMaxBytes) {
    problems.push_back("has a record of more than 256 MiB" + atByte(record) + "; record it again");
    return std::nullopt;
  }
  Contents bytes(static_cast<std::size_t>(size));
  if (file_.read(at, bytes)) return bytes;
  problems.push_back(cannotBeRead(at));
  return std::nullopt;
}

Result<const ChunkedFile::Contents*> ChunkedFile::chunkAt(std::uint64_t at) {
  const auto known = std::find_if(chunks_.begin(), chunks_.end(),
                                  [at](const auto& chunk) { return chunk.first == at; });
  if (known != chunks_.end()) return &known->second;
  Result<Contents> records = readChunk(at);
  if (!records.isOk()) return records.status();
  if (chunks_.size() == 2) chunks_.pop_front();  // the images of a pair may be in two chunks
  chunks_.emplace_back(at, std::move(records).value());
  return &chunks_.back().second;
}

Result<std::vector<std::uint8_t>> ChunkedFile::read(const MessagePlace& place) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(place.size));
  if (place.chunk == 0) {
    if (file_.read(place.offset, bytes)) return bytes;
    return Status::failed(cannotBeRead(place.offset));
  }
  const Result<const Contents*> chunk = chunkAt(place.chunk);
  if (!chunk.isOk()) return chunk.status();
  const Bytes records = *chunk.value();
  if (place.offset > records.size() || place.size > records.size() - place.offset) {
    return Status::failed("has changed while it was read");
  }
  const Bytes message = records.subspan(static_cast<std::size_t>(place.offset), bytes.size());
  std::copy(message.begin(), message.end(), bytes.begin());
  return bytes;
}

}  // namespace tolman::ros_bag
