// SPDX-License-Identifier: BSD-3-Clause
// MCAP of ROS 2 (mcap.dev): chunks without compression, since images are compressed already, with
// check sums and indices.
#include <zlib.h>

#include <algorithm>
#include <map>

#include "bag_output.hpp"
#include "message_types.hpp"

namespace tolman::bag_writer {
namespace {

constexpr const char* kMagic = "\x89MCAP0\r\n";

enum class Kind : std::uint8_t {
  Header = 1,
  Footer = 2,
  Schema = 3,
  Channel = 4,
  Message = 5,
  Chunk = 6,
  MessageIndex = 7,
  ChunkIndex = 8,
  Statistics = 11,
  DataEnd = 15
};

std::string record(Kind kind, const std::string& contents) {
  return raw(static_cast<std::uint8_t>(kind)) + raw(static_cast<std::uint64_t>(contents.size())) +
         contents;
}

std::uint32_t crcOf(const std::string& bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string nanoseconds(std::int64_t ns) {
  return raw(static_cast<std::uint64_t>(std::max<std::int64_t>(ns, 0)));
}

struct Channel {
  std::uint16_t id = 0;
  std::string declaration;  ///< schema and channel
  std::uint64_t messages = 0;
  std::string index;  ///< of the open chunk
};

class Mcap final : public BagOutput {
 public:
  explicit Mcap(std::ofstream file) : BagOutput(std::move(file)) {
    put(kMagic + record(Kind::Header, prefixed("ros2") + prefixed("tolman")));
  }

  Format format() const override { return Format::Ros2; }

 private:
  void append(const std::string& topic, const std::string& type, std::int64_t stamp_ns,
              const std::string& message) override {
    const std::string time = nanoseconds(stamp_ns);
    Channel& channel = channels_[topic];
    if (channel.id == 0) declare(channel, topic, type);
    if (channel.messages == 0) chunk_ += channel.declaration;
    channel.index += time + raw(static_cast<std::uint64_t>(chunk_.size()));
    const auto number = static_cast<std::uint32_t>(channel.messages++);
    chunk_ += record(Kind::Message, raw(channel.id) + raw(number) + time + time + message);
  }

  void writeIndex() override {
    put(record(Kind::DataEnd, raw(std::uint32_t{0})));
    const std::uint64_t at = at_;
    std::string summary;
    for (const auto& [topic, channel] : channels_) summary += channel.declaration;
    summary += statistics() + chunk_indices_;
    const std::string ends = raw(at) + raw(std::uint64_t{0});
    const std::string begin = record(Kind::Footer, ends + raw(std::uint32_t{0}));
    const std::uint32_t sum = crcOf(summary + begin.substr(0, begin.size() - 4));
    put(summary + begin.substr(0, begin.size() - 4) + raw(sum) + kMagic);
  }

  void declare(Channel& channel, const std::string& topic, const std::string& type) {
    channel.id = static_cast<std::uint16_t>(channels_.size());
    channel.declaration =
        record(Kind::Schema, raw(channel.id) + prefixed(type) + prefixed("ros2msg") +
                                 prefixed(definitionOf(type, Format::Ros2))) +
        record(Kind::Channel, raw(channel.id) + raw(channel.id) + prefixed(topic) +
                                  prefixed("cdr") + prefixed(""));
  }

  void writeChunk() override {
    const std::uint64_t begin = at_;
    const auto size = static_cast<std::uint64_t>(chunk_.size());
    const std::string times = nanoseconds(begin_ns_) + nanoseconds(end_ns_);
    put(record(Kind::Chunk,
               times + raw(size) + raw(crcOf(chunk_)) + prefixed("") + raw(size) + chunk_));
    const std::uint64_t length = at_ - begin;
    std::string offsets;
    for (auto& [topic, channel] : channels_) {
      if (channel.index.empty()) continue;
      offsets += raw(channel.id) + raw(at_);
      put(record(Kind::MessageIndex, raw(channel.id) + prefixed(channel.index)));
      channel.index.clear();
    }
    chunk_indices_ += record(Kind::ChunkIndex, times + raw(begin) + raw(length) +
                                                   prefixed(offsets) + raw(at_ - begin - length) +
                                                   prefixed("") + raw(size) + raw(size));
    first_ns_ = chunks_ == 0 ? begin_ns_ : std::min(first_ns_, begin_ns_);
    last_ns_ = std::max(last_ns_, end_ns_);
  }

  std::string statistics() const {
    std::string counts;
    std::uint64_t all = 0;
    for (const auto& [topic, channel] : channels_) {
      counts += raw(channel.id) + raw(channel.messages);
      all += channel.messages;
    }
    const auto channels = static_cast<std::uint32_t>(channels_.size());
    return record(Kind::Statistics, raw(all) + raw(static_cast<std::uint16_t>(channels)) +
                                        raw(channels) + raw(std::uint64_t{0}) + raw(chunks_) +
                                        nanoseconds(first_ns_) + nanoseconds(last_ns_) +
                                        prefixed(counts));
  }

  std::map<std::string, Channel> channels_;
  std::string chunk_indices_;
  std::int64_t first_ns_ = 0;  ///< of all messages
  std::int64_t last_ns_ = 0;
};

}  // namespace

std::unique_ptr<BagOutput> newMcap(std::ofstream file) {
  return std::make_unique<Mcap>(std::move(file));
}

}  // namespace tolman::bag_writer
