// SPDX-License-Identifier: BSD-3-Clause
#include "ros1_file.hpp"

#include <array>

#include "file_bytes.hpp"

namespace tolman::ros_bag {

std::optional<Bytes> Ros1Record::field(std::string_view name) const {
  ByteReader fields(header);
  while (fields.left() > 0) {
    const Bytes entry = fields.take(fields.number<std::uint32_t>());
    const std::string_view text = asText(entry);
    const std::size_t equals = text.find('=');
    if (!fields.ok() || equals == std::string_view::npos) return std::nullopt;
    if (text.substr(0, equals) == name) return entry.subspan(equals + 1);
  }
  return std::nullopt;
}

Ros1Kind Ros1Record::kind() const {
  const std::uint8_t kind = number<std::uint8_t>("op").value_or(0);
  return kind >= 2 && kind <= 7 ? static_cast<Ros1Kind>(kind) : Ros1Kind::None;
}

std::optional<Ros1Record> takeRecord(ByteReader& bytes) {
  const std::size_t begin = bytes.at();
  Ros1Record record;
  record.header = bytes.take(bytes.number<std::uint32_t>());
  const auto size = bytes.number<std::uint32_t>();
  record.data_at = bytes.at() - begin;
  record.data = bytes.take(size);
  if (!bytes.ok()) return std::nullopt;
  return record;
}

std::optional<std::int64_t> timeOf(const Ros1Record& message) {
  const std::optional<Bytes> time = message.field("time");
  if (!time || time->size() != 2 * sizeof(std::uint32_t)) return std::nullopt;
  ByteReader fields(*time);
  const std::int64_t seconds = fields.number<std::int32_t>();  // see timeOf()
  const std::int64_t nanoseconds = fields.number<std::uint32_t>();
  if (nanoseconds >= 1'000'000'000) return std::nullopt;
  return seconds * 1'000'000'000 + nanoseconds;
}

std::optional<Topic> topicOf(const Ros1Record& connection) {
  // The data are another header, that of the publisher.
  const Ros1Record sender{connection.data, {}};
  const auto name = connection.field("topic");
  const auto type = sender.field("type");
  if (!name || !type) return std::nullopt;
  std::string full(asText(*type));
  if (const auto slash = full.find('/'); slash != std::string::npos) full.insert(slash, "/msg");
  return Topic{std::string(asText(*name)), full, std::string(kRos1Encoding)};
}

Result<std::vector<std::uint8_t>> unpackChunk(const Ros1Record& chunk) {
  constexpr std::uint32_t kMaxBytes = std::uint32_t{256} << 20U;
  const auto size = chunk.number<std::uint32_t>("size");
  const auto compression = chunk.field("compression");
  if (!size || !compression) return Status::invalidInput("has a damaged header");
  if (*size > kMaxBytes) return Status::invalidInput("claims more than 256 MiB");
  const std::string_view how = asText(*compression);
  std::optional<std::vector<std::uint8_t>> records;
  if (how == "none") {
    records = std::vector<std::uint8_t>(chunk.data.begin(), chunk.data.end());
  } else if (how == "bz2") {
    records = unpackBz2(chunk.data, *size);
  } else if (how == "lz4") {
    records = unpackLz4(chunk.data, *size);
  } else {
    return Status::unsupported("has an unknown compression");
  }
  if (!records || records->size() != *size) return Status::invalidInput("does not unpack");
  return std::move(*records);
}

namespace {

constexpr std::string_view kStart = "#ROSBAG V";
constexpr std::string_view kVersion = "2.0\n";
constexpr std::uint64_t kBegin = kStart.size() + kVersion.size();  // offset of the first record

}  // namespace

bool Ros1File::isRos1(FileBytes& file) {
  std::array<std::uint8_t, kStart.size()> start{};
  return file.read(0, start) && asText(start) == kStart;
}

Result<std::unique_ptr<Ros1File>> Ros1File::open(FileBytes file) {
  std::array<std::uint8_t, kVersion.size()> version{};
  if (!file.read(kStart.size(), version) || asText(version) != kVersion) {
    return Status::unsupported(
        "is a ROS 1 bag of another version than 2.0; convert it (`rosbag fix`)");
  }
  std::unique_ptr<Ros1File> bag(new Ros1File(std::move(file)));
  const Result<Contents> bytes = bag->readRecord(kBegin);
  if (!bytes.isOk()) return bytes.status();
  ByteReader reader(bytes.value());
  const auto record = takeRecord(reader);
  if (!record || record->kind() != Ros1Kind::BagHeader) {
    return Status::invalidInput("does not begin as a ROS 1 bag does; copy it again");
  }
  const auto encryptor = record->field("encryptor");
  if (!encryptor || encryptor->empty()) return bag;
  return Status::unsupported("is an encrypted ROS 1 bag; decrypt it (`rosbag decrypt`)");
}

Result<Ros1File::Contents> Ros1File::readRecord(std::uint64_t at) {
  // A record: the length of its header (4 bytes), the header, the length of its data, the data.
  std::uint64_t size = 0;
  for (int part = 0; part < 2 && size <= kMaxBytes; ++part) {
    std::array<std::uint8_t, sizeof(std::uint32_t)> length{};
    if (!file().read(at + size, length)) {
      return Status::invalidInput("is cut off within the record" + atByte(at));
    }
    size += length.size() + ByteReader(length).number<std::uint32_t>();
  }
  return readBytes(at, size, at);
}

void Ros1File::visit(const MessageVisitor& visitor, const DamageVisitor& damage) {
  Scan scan{visitor, damage, {}};
  std::uint64_t index_at = 0;  // 0: the bag was not closed
  for (std::uint64_t at = kBegin; at < file().size();) {
    const Result<Contents> bytes = readRecord(at);
    if (!bytes.isOk()) return damage(bytes.status().message());
    ByteReader reader(bytes.value());
    const auto record = takeRecord(reader);
    if (!record) return damage("has a damaged record" + atByte(at));
    if (record->kind() == Ros1Kind::BagHeader) {
      index_at = record->number<std::uint64_t>("index_pos").value_or(0);
    }
    if (record->kind() == Ros1Kind::ChunkInfo) return;  // follows all messages
    visitRecord(*record, 0, at, scan);
    at += bytes.value().size();
  }
  if (index_at == 0 || index_at > file().size()) damage("has no end: the recording was cut off");
}

void Ros1File::visitRecord(const Ros1Record& record, std::uint64_t chunk, std::uint64_t at,
                           Scan& scan) {
  const std::string place = atByte(chunk == 0 ? at : chunk);
  if (record.kind() == Ros1Kind::Connection) {
    const auto number = record.number<std::uint32_t>("conn");
    const auto topic = topicOf(record);
    if (!number || !topic) return scan.damage("has a damaged topic" + place);
    scan.topics.emplace(*number, *topic);
  } else if (record.kind() == Ros1Kind::Message) {
    visitMessage(record, chunk, at, scan);
  } else if (record.kind() == Ros1Kind::Chunk && chunk == 0) {
    visitChunk(record, at, scan);
  } else if (record.kind() == Ros1Kind::None) {
    scan.damage("has a record of no known kind" + place);
  }
}

void Ros1File::visitMessage(const Ros1Record& record, std::uint64_t chunk, std::uint64_t at,
                            Scan& scan) {
  const auto connection = record.number<std::uint32_t>("conn");
  const auto topic = connection ? scan.topics.find(*connection) : scan.topics.end();
  const auto log_ns = timeOf(record);
  if (topic == scan.topics.end() || !log_ns) {
    return scan.damage("has a damaged message" + atByte(chunk == 0 ? at : chunk));
  }
  const MessagePlace place{chunk, at + record.data_at, record.data.size()};
  scan.visitor(topic->second, *log_ns, place, record.data);
}

void Ros1File::visitChunk(const Ros1Record& chunk, std::uint64_t at, Scan& scan) {
  const Result<Contents> records = unpackChunk(chunk);
  if (!records.isOk()) {
    return scan.damage("has a chunk" + atByte(at) + " that " + records.status().message());
  }
  ByteReader reader(records.value());
  while (reader.left() > 0) {
    const std::size_t begin = reader.at();
    const auto record = takeRecord(reader);
    if (!record) return scan.damage("has a chunk" + atByte(at) + " that ends in a record");
    visitRecord(*record, at, begin, scan);
  }
}

Result<Ros1File::Contents> Ros1File::readChunk(std::uint64_t at) {
  const Result<Contents> bytes = readRecord(at);
  if (!bytes.isOk()) return bytes.status();
  ByteReader reader(bytes.value());
  const auto record = takeRecord(reader);
  if (!record) return Status::failed("has changed while it was read");
  return unpackChunk(*record);
}

}  // namespace tolman::ros_bag
