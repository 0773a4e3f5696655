// SPDX-License-Identifier: BSD-3-Clause
#include "chunked_file.hpp"

#include <algorithm>

namespace tolman::ros_bag {

Result<ChunkedFile::Contents> ChunkedFile::readBytes(std::uint64_t at, std::uint64_t size,
                                                     std::uint64_t record) {
  if (at > file_.size() || size > file_.size() - at) {
    return Status::invalidInput("is cut off within the record" + atByte(record));
  }
  if (size > kMaxBytes) {
    return Status::invalidInput("has a record of more than 256 MiB" + atByte(record));
  }
  Contents bytes(static_cast<std::size_t>(size));
  if (file_.read(at, bytes)) return bytes;
  return Status::invalidInput("cannot be read" + atByte(at));
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
  if (place.chunk == 0) return readBytes(place.offset, place.size, place.offset);
  const Result<const Contents*> chunk = chunkAt(place.chunk);
  if (!chunk.isOk()) return chunk.status();
  const Bytes records = *chunk.value();
  if (place.offset > records.size() || place.size > records.size() - place.offset) {
    return Status::failed("has changed while it was read");
  }
  const Bytes message =
      records.subspan(static_cast<std::size_t>(place.offset), static_cast<std::size_t>(place.size));
  return std::vector<std::uint8_t>(message.begin(), message.end());
}

}  // namespace tolman::ros_bag
