// SPDX-License-Identifier: BSD-3-Clause
#include "mcap_file.hpp"

#include <zlib.h>

#include <array>
#include <optional>

namespace tolman::ros_bag {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
constexpr std::uint64_t kHeader = 9;  // bytes of a record: kind, then length of the contents

enum Kind : std::uint8_t {
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

void McapFile::visit(const MessageVisitor& visitor, const DamageVisitor& damage) {
  Scan scan{visitor, damage, {}, {}};
  std::uint64_t at = kMagic.size();
  while (true) {
    std::array<std::uint8_t, kHeader> header{};
    if (!file().read(at, header)) return damage("has no end: the recording was cut off");
    const std::uint8_t kind = header[0];
    if (kind == kFooter || kind == kDataEnd) return;
    const auto size = ByteReader(Bytes(header).subspan(1)).number<std::uint64_t>();
    const Result<Contents> contents = readBytes(at + kHeader, size, at);
    if (!contents.isOk()) return damage(contents.status().message());
    visitRecord(kind, contents.value(), 0, at + kHeader, scan);
    at += kHeader + size;
  }
}

void McapFile::visitRecord(std::uint8_t kind, Bytes contents, std::uint64_t chunk, std::uint64_t at,
                           Scan& scan) {
  ByteReader fields(contents);
  if (kind == kMessage) return visitMessage(contents, chunk, at, scan);
  if (kind == kChunk && chunk == 0) return visitChunk(contents, at, scan);
  if (kind == kSchema) {
    const auto id = fields.number<std::uint16_t>();
    scan.types[id] = std::string(fields.text());
  } else if (kind == kChannel) {
    const auto id = fields.number<std::uint16_t>();
    const std::string type = scan.types[fields.number<std::uint16_t>()];
    const std::string name(fields.text());
    scan.topics.emplace(id, Topic{name, type, std::string(fields.text())});
  }
  if (!fields.ok()) scan.damage("has a damaged record" + atByte(at));
}

void McapFile::visitMessage(Bytes contents, std::uint64_t chunk, std::uint64_t at, Scan& scan) {
  ByteReader fields(contents);
  const auto topic = scan.topics.find(fields.number<std::uint16_t>());
  fields.number<std::uint32_t>();  // sequence number
  const auto log_ns = fields.number<std::int64_t>();
  fields.number<std::int64_t>();  // time of sending
  if (!fields.ok() || topic == scan.topics.end()) {
    return scan.damage("has a damaged message" + atByte(chunk == 0 ? at : chunk));
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
    return scan.damage("has a chunk" + atByte(at) + " that " + records.status().message());
  }
  ByteReader fields(records.value());
  while (fields.left() > 0) {
    const auto kind = fields.number<std::uint8_t>();
    const auto size = fields.number<std::uint64_t>();
    const std::size_t begin = fields.at();
    const Bytes record = fields.take(size);
    if (!fields.ok()) return scan.damage("has a chunk" + atByte(at) + " that ends in a record");
    visitRecord(kind, record, at, begin, scan);
  }
}

Result<McapFile::Contents> McapFile::readChunk(std::uint64_t at) {
  std::array<std::uint8_t, kHeader> header{};
  if (!file().read(at - kHeader, header)) return Status::invalidInput("has become shorter");
  const auto size = ByteReader(Bytes(header).subspan(1)).number<std::uint64_t>();
  const Result<Contents> contents = readBytes(at, size, at - kHeader);
  return contents.isOk() ? unpack(contents.value()) : contents.status();
}

}  // namespace tolman::ros_bag
