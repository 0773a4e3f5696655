// SPDX-License-Identifier: BSD-3-Clause
// A bag of ROS 1, format 2.0: chunks without compression, with their indices.
#include <algorithm>
#include <map>

#include "bag_output.hpp"
#include "message_types.hpp"

namespace tolman::bag_writer {
namespace {

enum class Op : std::uint8_t {
  Message = 2,
  BagHeader = 3,
  Index = 4,
  Chunk = 5,
  ChunkInfo = 6,
  Connection = 7
};

std::string field(const std::string& name, const std::string& value) {
  return prefixed(name + "=" + value);
}

std::string record(Op op, const std::string& fields, const std::string& data) {
  return prefixed(field("op", raw(static_cast<std::uint8_t>(op))) + fields) + prefixed(data);
}

std::string timeOf(std::int64_t ns) {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  return raw(static_cast<std::uint32_t>(ns / kSecond_ns)) +
         raw(static_cast<std::uint32_t>(ns % kSecond_ns));
}

struct Connection {
  std::uint32_t id = 0;
  std::string declaration;
  std::string index;        ///< of the open chunk
  std::uint32_t count = 0;  ///< in the open chunk
};

class Ros1Bag final : public BagOutput {
 public:
  explicit Ros1Bag(std::ofstream file) : BagOutput(std::move(file)) { put(header(0)); }

  Format format() const override { return Format::Ros1; }

 private:
  void append(const std::string& topic, const std::string& type, std::int64_t stamp_ns,
              const std::string& message) override {
    const auto [known, is_new] = connections_.try_emplace(topic);
    Connection& connection = known->second;
    if (is_new) {
      declare(connection, topic, type);
      chunk_ += connection.declaration;
    }
    connection.index += timeOf(stamp_ns) + raw(static_cast<std::uint32_t>(chunk_.size()));
    ++connection.count;
    chunk_ += record(Op::Message,
                     field("conn", raw(connection.id)) + field("time", timeOf(stamp_ns)), message);
  }

  void writeIndex() override {
    const std::uint64_t index_at = at_;
    for (const auto& [topic, connection] : connections_) put(connection.declaration);
    put(chunk_infos_);
    file_.seekp(0);
    put(header(index_at));
  }

  /// The beginning of the file, of one size whatever is in it.
  std::string header(std::uint64_t index_at) const {
    constexpr std::size_t kSize = 4096;
    const std::string fields =
        field("index_pos", raw(index_at)) +
        field("conn_count", raw(static_cast<std::uint32_t>(connections_.size()))) +
        field("chunk_count", raw(chunks_));
    const std::string bare = record(Op::BagHeader, fields, "");
    return "#ROSBAG V2.0\n" + record(Op::BagHeader, fields, std::string(kSize - bare.size(), ' '));
  }

  void declare(Connection& connection, const std::string& topic, const std::string& type) {
    connection.id = static_cast<std::uint32_t>(connections_.size() - 1);
    connection.declaration = record(
        Op::Connection, field("conn", raw(connection.id)) + field("topic", topic),
        field("topic", topic) + field("type", ros1Type(type)) + field("md5sum", sumOf(type)) +
            field("message_definition", definitionOf(type, Format::Ros1)));
  }

  void writeChunk() override {
    const std::uint64_t begin = at_;
    put(record(Op::Chunk,
               field("compression", "none") +
                   field("size", raw(static_cast<std::uint32_t>(chunk_.size()))),
               chunk_));
    std::string counts;
    std::uint32_t used = 0;
    for (auto& [topic, connection] : connections_) {
      if (connection.count == 0) continue;
      put(record(Op::Index,
                 field("ver", raw(std::uint32_t{1})) + field("conn", raw(connection.id)) +
                     field("count", raw(connection.count)),
                 connection.index));
      counts += raw(connection.id) + raw(connection.count);
      connection.count = 0;
      connection.index.clear();
      ++used;
    }
    chunk_infos_ += record(Op::ChunkInfo,
                           field("ver", raw(std::uint32_t{1})) + field("chunk_pos", raw(begin)) +
                               field("start_time", timeOf(begin_ns_)) +
                               field("end_time", timeOf(end_ns_)) + field("count", raw(used)),
                           counts);
  }

  std::map<std::string, Connection> connections_;
  std::string chunk_infos_;
};

}  // namespace

std::unique_ptr<BagOutput> newRos1Bag(std::ofstream file) {
  return std::make_unique<Ros1Bag>(std::move(file));
}

}  // namespace tolman::bag_writer
