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

struct Channel {
  std::uint16_t id = 0;
  std::string declaration;  ///< schema and channel
  std::uint64_t messages = 0;
  std::string index;  ///< of the open chunk
};

class Mcap final : public BagOutput {
 public:
  explicit Mcap(std::ofstream file) : file_(std::move(file)) {
    put(kMagic + record(Kind::Header, prefixed("ros2") + prefixed("tolman")));
  }

  Format format() const override { return Format::Ros2; }

  void write(const std::string& topic, const std::string& type, std::int64_t stamp_ns,
             const std::vector<std::uint8_t>& message) override {
    const auto time = static_cast<std::uint64_t>(std::max<std::int64_t>(stamp_ns, 0));
    Channel& channel = channels_[topic];
    if (channel.id == 0) declare(channel, topic, type);
    if (chunk_.empty()) chunk_begin_ = chunk_end_ = time;
    if (channel.messages == 0) chunk_ += channel.declaration;
    channel.index += raw(time) + raw(static_cast<std::uint64_t>(chunk_.size()));
    const auto number = static_cast<std::uint32_t>(channel.messages++);
    chunk_ += record(Kind::Message, raw(channel.id) + raw(number) + raw(time) + raw(time) +
                                        std::string(message.begin(), message.end()));
    chunk_begin_ = std::min(chunk_begin_, time);
    chunk_end_ = std::max(chunk_end_, time);
    constexpr std::size_t kEnough = 4U << 20;  // bytes
    if (chunk_.size() > kEnough) endChunk();
  }

  Status close() override {
    if (!chunk_.empty()) endChunk();
    put(record(Kind::DataEnd, raw(std::uint32_t{0})));
    const std::uint64_t at = at_;
    std::string summary;
    for (const auto& [topic, channel] : channels_) summary += channel.declaration;
    summary += statistics() + chunk_indices_;
    const std::string ends = raw(at) + raw(std::uint64_t{0});
    const std::string begin = record(Kind::Footer, ends + raw(std::uint32_t{0}));
    const std::uint32_t sum = crcOf(summary + begin.substr(0, begin.size() - 4));
    put(summary + begin.substr(0, begin.size() - 4) + raw(sum) + kMagic);
    file_.close();
    return file_ ? Status::ok() : Status::failed("the bag cannot be written; is the disk full?");
  }

 private:
  void put(const std::string& bytes) {
    file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    at_ += bytes.size();
  }

  void declare(Channel& channel, const std::string& topic, const std::string& type) {
    channel.id = static_cast<std::uint16_t>(channels_.size());
    channel.declaration =
        record(Kind::Schema, raw(channel.id) + prefixed(type) + prefixed("ros2msg") +
                                 prefixed(definitionOf(type, Format::Ros2))) +
        record(Kind::Channel, raw(channel.id) + raw(channel.id) + prefixed(topic) +
                                  prefixed("cdr") + prefixed(""));
  }

  void endChunk() {
    const std::uint64_t begin = at_;
    const auto size = static_cast<std::uint64_t>(chunk_.size());
    put(record(Kind::Chunk, raw(chunk_begin_) + raw(chunk_end_) + raw(size) + raw(crcOf(chunk_)) +
                                prefixed("") + raw(size) + chunk_));
    const std::uint64_t length = at_ - begin;
    std::string offsets;
    for (auto& [topic, channel] : channels_) {
      if (channel.index.empty()) continue;
      offsets += raw(channel.id) + raw(at_);
      put(record(Kind::MessageIndex, raw(channel.id) + prefixed(channel.index)));
      channel.index.clear();
    }
    chunk_indices_ +=
        record(Kind::ChunkIndex, raw(chunk_begin_) + raw(chunk_end_) + raw(begin) + raw(length) +
                                     prefixed(offsets) + raw(at_ - begin - length) + prefixed("") +
                                     raw(size) + raw(size));
    begin_ = chunks_ == 0 ? chunk_begin_ : std::min(begin_, chunk_begin_);
    end_ = std::max(end_, chunk_end_);
    ++chunks_;
    chunk_.clear();
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
                                        raw(begin_) + raw(end_) + prefixed(counts));
  }

  std::ofstream file_;
  std::uint64_t at_ = 0;  ///< bytes written
  std::map<std::string, Channel> channels_;
  std::string chunk_;
  std::uint64_t chunk_begin_ = 0;  ///< time of the first message
  std::uint64_t chunk_end_ = 0;
  std::string chunk_indices_;
  std::uint32_t chunks_ = 0;
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace

std::unique_ptr<BagOutput> newMcap(std::ofstream file) {
  return std::make_unique<Mcap>(std::move(file));
}

}  // namespace tolman::bag_writer
