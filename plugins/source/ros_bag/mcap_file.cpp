// SPDX-License-Identifier: BSD-3-Clause
#include "mcap_file.hpp"

#include <zlib.h>

#include <array>

#include "bag_problems.hpp"
#include "compression.hpp"

namespace tolman::ros_bag {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
constexpr std::uint64_t kRecordHeader = 9;  // kind, then length of the contents

enum RecordKind : std::uint8_t {
  kFooter = 2,
  kSchema = 3,
  kChannel = 4,
  kMessage = 5,
  kChunk = 6,
  kDataEnd = 15,
};

}  // namespace

bool McapFile::isMcap(FileBytes& file) {
  std::array<std::uint8_t, 8> start{};
  return file.read(0, start) && start == kMagic;
}

void McapFile::visit(const MessageVisitor& visitor, std::vector<std::string>& problems) {
  Scan scan{visitor, problems, {}, {}};
  std::uint64_t at = kMagic.size();
  while (true) {
    std::array<std::uint8_t, kRecordHeader> header{};
    if (!file().read(at, header)) {
      problems.push_back(hasNoEnd(at));
      return;
    }
    const std::uint8_t kind = header[0];
    const std::uint64_t size = ByteReader(Bytes(header).subspan(1)).number<std::uint64_t>();
    if (kind == kDataEnd || kind == kFooter) return;  // what follows is the index
    at += kRecordHeader;
    const bool used = kind >= kSchema && kind <= kChunk;
    if (used) {
      const std::optional<Contents> contents = readBytes(at, size, at - kRecordHeader, problems);
      if (!contents) return;
      visitRecord(kind, *contents, 0, at, scan);
    } else if (size > file().size() - at) {
      problems.push_back(endsWithin(at - kRecordHeader));
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
    scan.problems.push_back(hasPart("a damaged record", at));
  }
}

void McapFile::visitMessage(Bytes contents, std::uint64_t chunk, std::uint64_t at, Scan& scan) {
  ByteReader fields(contents);
  const auto channel = fields.number<std::uint16_t>();
  fields.number<std::uint32_t>();  // sequence number
  const auto log_ns = fields.number<std::int64_t>();
  fields.number<std::int64_t>();  // time of sending
  const auto topic = scan.topics.find(channel);
  if (!fields.ok() || topic == scan.topics.end() || log_ns < 0) {
    scan.problems.push_back(hasPart("a damaged message", chunk == 0 ? at : chunk));
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
  if (size > kMaxBytes) return Status::invalidInput("claims more than 256 MiB");
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
    scan.problems.push_back(badChunk(at, records.status().message()));
    return;
  }
  ByteReader fields(records.value());
  while (fields.left() > 0) {
    const auto kind = fields.number<std::uint8_t>();
    const auto size = fields.number<std::uint64_t>();
    const std::size_t begin = fields.at();
    const Bytes record = fields.take(size);
    if (!fields.ok()) {
      scan.problems.push_back(chunkEndsWithin(at));
      return;
    }
    visitRecord(kind, record, at, begin, scan);
  }
}

Result<McapFile::Contents> McapFile::readChunk(std::uint64_t at) {
  std::array<std::uint8_t, kRecordHeader> header{};
  if (!file().read(at - kRecordHeader, header)) return Status::invalidInput("has become shorter");
  Problems problems;
  const auto size = ByteReader(Bytes(header).subspan(1)).number<std::uint64_t>();
  const std::optional<Contents> contents = readBytes(at, size, at - kRecordHeader, problems);
  if (!contents) return Status::invalidInput(problems.front());
  return unpack(*contents);
}

}  // namespace tolman::ros_bag
