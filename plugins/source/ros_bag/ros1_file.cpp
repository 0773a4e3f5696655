// SPDX-License-Identifier: BSD-3-Clause
#include "ros1_file.hpp"

#include <array>

#include "bag_problems.hpp"

namespace tolman::ros_bag {
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
  Problems problems;
  const auto bytes = bag->readRecord(kBegin, problems);
  if (!bytes) return Status::invalidInput(problems.front());
  ByteReader reader(*bytes);
  const auto record = takeRecord(reader);
  if (!record || record->kind() != Ros1Kind::BagHeader) {
    return Status::invalidInput("does not begin as a ROS 1 bag does; copy it again");
  }
  const auto encryptor = record->field("encryptor");
  if (!encryptor || encryptor->empty()) return bag;
  return Status::unsupported("is an encrypted ROS 1 bag; decrypt it (`rosbag decrypt`)");
}

std::optional<Ros1File::Contents> Ros1File::readRecord(std::uint64_t at, Problems& problems) {
  // A record: the length of its header (4 bytes), the header, the length of its data, the data.
  std::uint64_t size = 0;
  for (int part = 0; part < 2 && size <= kMaxBytes; ++part) {
    std::array<std::uint8_t, sizeof(std::uint32_t)> length{};
    if (!file().read(at + size, length)) {
      problems.push_back(endsWithin(at));
      return std::nullopt;
    }
    size += length.size() + ByteReader(length).number<std::uint32_t>();
  }
  return readBytes(at, size, at, problems);
}

/// Reads the records at the end of the bag, which repeat the connections and count the messages of
/// each chunk. They are empty in some bags, and then say nothing.
bool Ros1File::readIndex(std::uint64_t begin, Scan& scan) {
  Problems unused;  // the index is a witness only
  for (std::uint64_t at = begin; at < file().size();) {
    const std::optional<Contents> bytes = readRecord(at, unused);
    if (!bytes) return false;
    ByteReader reader(*bytes);
    const auto record = takeRecord(reader);
    if (!record) return false;
    if (record->kind() == Ros1Kind::Connection) {
      if (!takeConnection(*record, scan)) return false;
    } else if (record->kind() != Ros1Kind::ChunkInfo) {
      return false;
    } else {
      ByteReader pairs(record->data);
      while (pairs.left() > 0) {
        const auto connection = pairs.number<std::uint32_t>();
        const auto messages = pairs.number<std::uint32_t>();
        if (!pairs.ok()) return false;
        scan.counts.indexFile(connection, messages);
      }
    }
    at += bytes->size();
  }
  return true;
}

void Ros1File::visit(const MessageVisitor& visitor, FileDamage& damage) {
  Problems& problems = damage.problems;
  Scan scan{visitor, damage, {}, {}, {}, {}};
  Problems unused;
  const auto begin = readRecord(kBegin, unused);  // sound, see open()
  std::uint64_t index_at = 0;
  if (begin) {
    ByteReader reader(*begin);
    const auto header = takeRecord(reader);
    if (header) index_at = header->number<std::uint64_t>("index_pos").value_or(0);
  }
  const bool has_index = index_at >= kBegin && index_at <= file().size();
  const bool is_index_sound = has_index && readIndex(index_at, scan);
  if (!is_index_sound) {
    scan.topics.clear();
    scan.counts = {};
  }
  const bool is_whole = visitRecords(is_index_sound ? index_at : file().size(), scan);
  if (is_whole && !has_index) problems.push_back(hasNoEnd(file().size()));
  if (is_whole && has_index && !is_index_sound) problems.push_back(badIndex("is damaged"));
  if (scan.damaged.count() > 0) problems.push_back(leftOut(scan.damaged.text()));
  if (scan.wrong_clock.count() > 0) problems.push_back(wrongClock(scan.wrong_clock.text()));
  scan.counts.visitMissing([&](std::uint32_t connection, std::int64_t messages) {
    const auto topic = scan.topics.find(connection);
    damage.lose(topic == scan.topics.end() ? Topic() : topic->second, messages);
  });
}

/// Visits the records before `end`, or before the index; false if the last was cut off, which is
/// reported.
bool Ros1File::visitRecords(std::uint64_t end, Scan& scan) {
  for (std::uint64_t at = kBegin; at < end;) {
    const std::optional<Contents> bytes = readRecord(at, scan.damage.problems);
    if (!bytes) return false;
    ByteReader reader(*bytes);
    const auto record = takeRecord(reader);
    if (!record) return false;
    if (record->kind() == Ros1Kind::ChunkInfo) return true;  // follows all messages
    visitRecord(*record, 0, at, scan);
    at += bytes->size();
  }
  return true;
}

bool Ros1File::takeConnection(const Ros1Record& record, Scan& scan) {
  const auto number = record.number<std::uint32_t>("conn");
  const auto topic = topicOf(record);
  if (!number || !topic) return false;
  const auto [known, is_new] = scan.topics.emplace(*number, *topic);
  return is_new || known->second == *topic;
}

void Ros1File::visitRecord(const Ros1Record& record, std::uint64_t chunk, std::uint64_t at,
                           Scan& scan) {
  Problems& problems = scan.damage.problems;
  const std::uint64_t place = chunk == 0 ? at : chunk;
  if (record.kind() == Ros1Kind::Connection) {
    if (!takeConnection(record, scan)) {
      problems.push_back(hasPart("a damaged or changed topic", place));
    }
  } else if (record.kind() == Ros1Kind::Message) {
    visitMessage(record, chunk, at, scan);
  } else if (record.kind() == Ros1Kind::Chunk && chunk == 0) {
    visitChunk(record, at, scan);
  } else if (record.kind() == Ros1Kind::Index) {
    const auto connection = record.number<std::uint32_t>("conn");
    const auto messages = record.number<std::uint32_t>("count");
    if (connection && messages) scan.counts.indexChunk(*connection, *messages);
  } else if (record.kind() == Ros1Kind::None) {
    problems.push_back(hasPart("a record of no known kind", place));
  }
}

void Ros1File::visitMessage(const Ros1Record& record, std::uint64_t chunk, std::uint64_t at,
                            Scan& scan) {
  const auto connection = record.number<std::uint32_t>("conn");
  const auto topic = connection ? scan.topics.find(*connection) : scan.topics.end();
  const auto log_ns = timeOf(record);
  const std::string place = atByte(chunk == 0 ? at : chunk);
  if (connection) scan.counts.find(*connection);
  if (topic == scan.topics.end() || !log_ns) {
    scan.damaged.add([&] { return "has a damaged message" + place; });
    return scan.damage.lose(topic == scan.topics.end() ? Topic() : topic->second, 1);
  }
  if (*log_ns < 0) {
    scan.wrong_clock.add([&] { return beforeEpoch("the message" + place, *log_ns); });
    return scan.damage.lose(topic->second, 1);
  }
  const MessagePlace bytes{chunk, at + record.data_at, record.data.size()};
  scan.visitor(topic->second, *log_ns, bytes, record.data);
}

void Ros1File::visitChunk(const Ros1Record& chunk, std::uint64_t at, Scan& scan) {
  const Result<Contents> records = unpackChunk(chunk);
  if (!records.isOk()) {
    scan.damage.problems.push_back(badChunk(at, records.status().message()));
    return;
  }
  ByteReader reader(records.value());
  while (reader.left() > 0) {
    const std::size_t begin = reader.at();
    const auto record = takeRecord(reader);
    if (!record) {
      scan.damage.problems.push_back(chunkEndsWithin(at));
      return;
    }
    visitRecord(*record, at, begin, scan);
  }
}

Result<Ros1File::Contents> Ros1File::readChunk(std::uint64_t at) {
  Problems problems;
  const auto bytes = readRecord(at, problems);
  if (!bytes) return Status::invalidInput(problems.front());
  ByteReader reader(*bytes);
  const auto record = takeRecord(reader);
  if (!record) return Status::failed("has changed while it was read");
  return unpackChunk(*record);
}

}  // namespace tolman::ros_bag
