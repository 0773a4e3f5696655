// SPDX-License-Identifier: BSD-3-Clause
#include "mcap_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>

#include "compression.hpp"

namespace tolman::ros_bag {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
constexpr std::uint64_t kRecordHeader = 9;  // kind, then length of the contents
constexpr std::uint64_t kMostBytes = std::uint64_t{256} << 20U;  // of a record, and unpacked

enum RecordKind : std::uint8_t {
  kFooter = 2,
  kSchema = 3,
  kChannel = 4,
  kMessage = 5,
  kChunk = 6,
  kDataEnd = 15,
};

std::string atByte(std::uint64_t at) { return " at byte " + std::to_string(at); }

}  // namespace

bool McapFile::isMcap(FileBytes& file) {
  std::array<std::uint8_t, 8> start{};
  return file.read(0, start) && start == kMagic;
}

std::optional<McapFile::Contents> McapFile::readRecord(std::uint64_t at, std::uint64_t size,
                                                       Scan& scan) {
  if (size > file_.size() - at) {
    scan.problems.push_back("ends within the record" + atByte(at - kRecordHeader) +
                            ": the recording was cut off; use what is there by on_corrupt: skip");
    return std::nullopt;
  }
  if (size > kMostBytes) {
    scan.problems.push_back("has a record of " + std::to_string(size) + " bytes" +
                            atByte(at - kRecordHeader) + ", more than 256 MiB; record it again");
    return std::nullopt;
  }
  Contents contents(static_cast<std::size_t>(size));
  if (file_.read(at, contents)) return contents;
  scan.problems.push_back("cannot be read" + atByte(at) + "; check the disk");
  return std::nullopt;
}

void McapFile::visit(const MessageVisitor& visitor, std::vector<std::string>& problems) {
  Scan scan{visitor, problems, {}, {}};
  std::uint64_t at = kMagic.size();
  while (true) {
    std::array<std::uint8_t, kRecordHeader> header{};
    if (!file_.read(at, header)) {
      problems.push_back("has no end" + atByte(at) +
                         ": the recording was cut off; use what is there by on_corrupt: skip");
      return;
    }
    const std::uint8_t kind = header[0];
    const std::uint64_t size = ByteReader(Bytes(header).subspan(1)).number<std::uint64_t>();
    if (kind == kDataEnd || kind == kFooter) return;  // what follows is the index
    at += kRecordHeader;
    const bool used = kind >= kSchema && kind <= kChunk;
    if (used) {
      const std::optional<Contents> contents = readRecord(at, size, scan);
      if (!contents) return;
      visitRecord(kind, *contents, 0, at, scan);
    } else if (size > file_.size() - at) {
      (void)readRecord(at, size, scan);  // tells it
      return;
    }
    at += size;
  }
}

void McapFile::visitRecord(std::uint8_t kind, Bytes contents, std::uint64_t chunk, std::uint64_t at,
                           Scan& scan) {
  ByteReader fields(contents);
  if (kind == kSchema) {
    const auto id = fields.number<std::uint16_t>();
    const std::string name(fields.text());
    if (fields.ok()) scan.types[id] = name;
  } else if (kind == kChannel) {
    const auto id = fields.number<std::uint16_t>();
    const auto schema = fields.number<std::uint16_t>();
    const std::string name(fields.text());
    const std::string encoding(fields.text());
    const auto type = scan.types.find(schema);
    if (fields.ok()) {
      scan.topics[id] = {name, type == scan.types.end() ? "" : type->second, encoding};
    }
  } else if (kind == kMessage) {
    return visitMessage(contents, chunk, at, scan);
  } else if (kind == kChunk && chunk == 0) {
    return visitChunk(contents, at, scan);
  }
  if (!fields.ok()) {
    scan.problems.push_back("has a damaged record" + atByte(at) +
                            "; copy it again, or leave it out by on_corrupt: skip");
  }
}

void McapFile::visitMessage(Bytes contents, std::uint64_t chunk, std::uint64_t at, Scan& scan) {
  ByteReader fields(contents);
  const auto channel = fields.number<std::uint16_t>();
  fields.number<std::uint32_t>();  // counts the messages of the channel
  const auto log_ns = fields.number<std::int64_t>();
  fields.number<std::int64_t>();  // time of sending
  const auto topic = scan.topics.find(channel);
  if (!fields.ok() || topic == scan.topics.end() || log_ns < 0) {
    scan.problems.push_back("has a damaged message" + atByte(chunk == 0 ? at : chunk) +
                            "; copy it again, or leave it out by on_corrupt: skip");
    return;
  }
  const MessagePlace place{chunk, at + fields.at(), fields.left()};
  scan.visitor(topic->second, log_ns, place, contents.subspan(fields.at()));
}

Result<McapFile::Contents> McapFile::unpack(Bytes contents) {
  ByteReader fields(contents);
  fields.take(2 * sizeof(std::uint64_t));  // times of the first and the last message
  const auto size = fields.number<std::uint64_t>();
  const auto sum = fields.number<std::uint32_t>();
  const std::string_view compression = fields.text();
  const Bytes packed = fields.take(fields.number<std::uint64_t>());
  if (!fields.ok()) return Status::invalidInput("is not complete");
  if (size > kMostBytes) return Status::invalidInput("claims more than 256 MiB");
  std::optional<Contents> records;
  if (compression.empty()) {
    records = Contents(packed.begin(), packed.end());
  } else if (compression == "zstd") {
    records = unpackZstd(packed, static_cast<std::size_t>(size));
  } else if (compression == "lz4") {
    records = unpackLz4(packed, static_cast<std::size_t>(size));
  } else {
    return Status::unsupported("has an unknown compression");
  }
  if (!records || records->size() != size) return Status::invalidInput("does not unpack");
  const uLong found = crc32_z(0, records->data(), records->size());
  if (sum != 0 && sum != found) return Status::invalidInput("has a wrong check sum");
  return std::move(*records);
}

void McapFile::visitChunk(Bytes contents, std::uint64_t at, Scan& scan) {
  const Result<Contents> records = unpack(contents);
  if (!records.isOk()) {
    scan.problems.push_back("the chunk" + atByte(at) + " " + records.status().message() +
                            "; copy the file again, or leave it out by on_corrupt: skip");
    return;
  }
  ByteReader fields(records.value());
  while (fields.left() > 0) {
    const auto kind = fields.number<std::uint8_t>();
    const auto size = fields.number<std::uint64_t>();
    const std::size_t begin = fields.at();
    const Bytes record = fields.take(size);
    if (!fields.ok()) {
      scan.problems.push_back("the chunk" + atByte(at) +
                              " ends within a record; record it again, or leave it out by "
                              "on_corrupt: skip");
      return;
    }
    visitRecord(kind, record, at, begin, scan);
  }
}

Result<const McapFile::Contents*> McapFile::chunkAt(std::uint64_t at) {
  const auto known = std::find_if(chunks_.begin(), chunks_.end(),
                                  [at](const auto& chunk) { return chunk.first == at; });
  if (known != chunks_.end()) return &known->second;
  std::array<std::uint8_t, kRecordHeader> header{};
  if (!file_.read(at - kRecordHeader, header)) return Status::invalidInput("has become shorter");
  std::vector<std::string> problems;
  Scan scan{{}, problems, {}, {}};
  const auto size = ByteReader(Bytes(header).subspan(1)).number<std::uint64_t>();
  const std::optional<Contents> contents = readRecord(at, size, scan);
  if (!contents) return Status::invalidInput(problems.front());
  Result<Contents> records = unpack(*contents);
  if (!records.isOk()) return records.status();
  if (chunks_.size() == 2) chunks_.pop_front();  // the images of a pair may stand in two
  chunks_.emplace_back(at, std::move(records).value());
  return &chunks_.back().second;
}

Result<std::vector<std::uint8_t>> McapFile::read(const MessagePlace& place) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(place.size));
  if (place.chunk == 0) {
    if (file_.read(place.offset, bytes)) return bytes;
    return Status::failed("cannot be read" + atByte(place.offset) + "; check the disk");
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
