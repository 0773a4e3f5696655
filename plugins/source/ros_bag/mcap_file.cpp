// SPDX-License-Identifier: BSD-3-Clause
#include "mcap_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <vector>

#include "bag_problems.hpp"
#include "compression.hpp"
#include "mcap_index.hpp"

namespace tolman::ros_bag {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

/// The check sum of the bytes from `begin` to `end`; 0 if they cannot be read.
std::uint32_t sumOf(FileBytes& file, std::uint64_t begin, std::uint64_t end) {
  constexpr std::uint64_t kBlock = std::uint64_t{1} << 20U;
  std::vector<std::uint8_t> block(static_cast<std::size_t>(std::min(kBlock, end - begin)));
  uLong sum = 0;
  for (std::uint64_t at = begin; at < end; at += block.size()) {
    block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), end - at)));
    if (!file.read(at, block)) return 0;
    sum = crc32_z(sum, block.data(), block.size());
  }
  return static_cast<std::uint32_t>(sum);
}

}  // namespace

bool McapFile::isMcap(FileBytes& file) {
  std::array<std::uint8_t, 8> start{};
  return file.read(0, start) && start == kMagic;
}

void McapFile::visit(const MessageVisitor& visitor, FileDamage& damage) {
  McapIndex index = readMcapIndex(file());
  Scan scan{visitor, damage, std::move(index.types), std::move(index.topics), {}, {}, {}, false};
  scan.counts.indexAll(index.all_messages);
  for (const auto& [channel, messages] : index.messages) scan.counts.indexFile(channel, messages);
  const std::optional<std::uint64_t> end = visitRecords(scan);
  if (end && !index.problem.empty()) {
    damage.problems.push_back(badIndex(index.problem));
  } else if (end && *end != index.begin) {
    damage.problems.push_back(endsEarly(*end));
  }
  if (scan.damaged.count() > 0) damage.problems.push_back(leftOut(scan.damaged.text()));
  if (scan.wrong_clock.count() > 0) damage.problems.push_back(wrongClock(scan.wrong_clock.text()));
  scan.counts.visitMissing([&](std::uint32_t channel, std::int64_t messages) {
    const auto topic = scan.topics.find(static_cast<std::uint16_t>(channel));
    damage.lose(topic == scan.topics.end() ? Topic() : topic->second, messages);
  });
  damage.lose({}, scan.counts.missingOfNone());
}

/// Visits the records up to the end of the data; the place behind them, or nothing if they were cut
/// off, which is reported.
std::optional<std::uint64_t> McapFile::visitRecords(Scan& scan) {
  Problems& problems = scan.damage.problems;
  std::uint64_t at = kMagic.size();
  while (true) {
    std::array<std::uint8_t, kMcapRecordHeader> header{};
    if (!file().read(at, header)) {
      problems.push_back(hasNoEnd(at));
      return std::nullopt;
    }
    const std::uint8_t kind = header[0];
    const std::uint64_t size = ByteReader(Bytes(header).subspan(1)).number<std::uint64_t>();
    if (kind == kMcapFooter) return at;
    at += kMcapRecordHeader;
    const bool used = kind >= kMcapSchema && kind <= kMcapMessageIndex;
    if (used) {
      const std::optional<Contents> contents =
          readBytes(at, size, at - kMcapRecordHeader, problems);
      if (!contents) return std::nullopt;
      visitRecord(kind, *contents, 0, at, scan);
    } else if (size > file().size() - at) {
      problems.push_back(endsWithin(at - kMcapRecordHeader));
      return std::nullopt;
    }
    if (kind == kMcapDataEnd) checkSum(at, size, scan);
    at += size;
    if (kind == kMcapDataEnd) return at;  // what follows is the index
  }
}

/// Whether writers count the magic bytes and the header to the data differs.
void McapFile::checkSum(std::uint64_t at, std::uint64_t size, Scan& scan) {
  std::array<std::uint8_t, sizeof(std::uint32_t)> bytes{};
  if (!scan.has_unsummed || size < bytes.size() || !file().read(at, bytes)) return;
  const auto sum = ByteReader(bytes).number<std::uint32_t>();
  std::array<std::uint8_t, kMcapRecordHeader> header{};
  if (sum == 0 || !file().read(kMagic.size(), header)) return;
  const std::uint64_t behind_header =
      kMagic.size() + header.size() + ByteReader(Bytes(header).subspan(1)).number<std::uint64_t>();
  const std::uint64_t end = at - kMcapRecordHeader;
  for (const std::uint64_t begin :
       {std::uint64_t{0}, std::uint64_t{kMagic.size()}, behind_header}) {
    if (begin <= end && sumOf(file(), begin, end) == sum) return;
  }
  scan.damage.problems.push_back(badDataSum());
}

void McapFile::visitRecord(std::uint8_t kind, Bytes contents, std::uint64_t chunk, std::uint64_t at,
                           Scan& scan) {
  ByteReader fields(contents);
  bool agrees = true;
  if (kind == kMcapSchema) {
    takeSchema(fields, scan.types);
  } else if (kind == kMcapChannel) {
    agrees = takeChannel(fields, scan.types, scan.topics);
  } else if (kind == kMcapMessage) {
    return visitMessage(contents, chunk, at, scan);
  } else if (kind == kMcapChunk && chunk == 0) {
    return visitChunk(contents, at, scan);
  } else if (kind == kMcapMessageIndex && chunk == 0) {
    const auto channel = fields.number<std::uint16_t>();
    constexpr std::int64_t kEntry = 16;  // bytes; time and place of a message
    const std::int64_t messages = fields.number<std::uint32_t>() / kEntry;
    if (fields.ok()) scan.counts.indexChunk(channel, messages);
  }
  if (!fields.ok()) scan.damage.problems.push_back(hasPart("a damaged record", at));
  if (!agrees) scan.damage.problems.push_back(hasPart("a topic that changes its name or type", at));
}

void McapFile::visitMessage(Bytes contents, std::uint64_t chunk, std::uint64_t at, Scan& scan) {
  if (chunk == 0) scan.has_unsummed = true;
  ByteReader fields(contents);
  const auto channel = fields.number<std::uint16_t>();
  fields.number<std::uint32_t>();  // sequence number
  const auto log_ns = fields.number<std::int64_t>();
  fields.number<std::int64_t>();  // time of sending
  const auto topic = scan.topics.find(channel);
  const std::string place = atByte(chunk == 0 ? at : chunk);
  if (!fields.ok() || topic == scan.topics.end()) {
    scan.damaged.add([&] { return "has a damaged message" + place; });
    if (!fields.ok()) return;
    scan.counts.find(channel);
    return scan.damage.lose({}, 1);
  }
  scan.counts.find(channel);
  if (log_ns < 0) {
    scan.wrong_clock.add([&] { return beforeEpoch("the message" + place, log_ns); });
    return scan.damage.lose(topic->second, 1);
  }
  const MessagePlace bytes{chunk, at + fields.at(), fields.left()};
  scan.visitor(topic->second, log_ns, bytes, contents.subspan(fields.at()));
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
  ByteReader head(contents);
  head.take(3 * sizeof(std::uint64_t));  // times, and size when unpacked
  if (head.number<std::uint32_t>() == 0) scan.has_unsummed = true;
  if (!records.isOk()) {
    scan.damage.problems.push_back(badChunk(at, records.status().message()));
    return;
  }
  ByteReader fields(records.value());
  while (fields.left() > 0) {
    const auto kind = fields.number<std::uint8_t>();
    const auto size = fields.number<std::uint64_t>();
    const std::size_t begin = fields.at();
    const Bytes record = fields.take(size);
    if (!fields.ok()) {
      scan.damage.problems.push_back(chunkEndsWithin(at));
      return;
    }
    visitRecord(kind, record, at, begin, scan);
  }
}

Result<McapFile::Contents> McapFile::readChunk(std::uint64_t at) {
  std::array<std::uint8_t, kMcapRecordHeader> header{};
  if (!file().read(at - kMcapRecordHeader, header))
    return Status::invalidInput("has become shorter");
  Problems problems;
  const auto size = ByteReader(Bytes(header).subspan(1)).number<std::uint64_t>();
  const std::optional<Contents> contents = readBytes(at, size, at - kMcapRecordHeader, problems);
  if (!contents) return Status::invalidInput(problems.front());
  return unpack(*contents);
}

}  // namespace tolman::ros_bag
