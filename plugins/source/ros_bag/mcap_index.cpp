// SPDX-License-Identifier: BSD-3-Clause
#include "mcap_index.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <vector>

namespace tolman::ros_bag {
namespace {

constexpr std::uint64_t kFooterSize = 20;  // of its contents
constexpr std::uint64_t kMcapMagicSize = 8;
constexpr std::uint64_t kTail = kMcapRecordHeader + kFooterSize + kMcapMagicSize;
constexpr std::uint64_t kMostIndexBytes = std::uint64_t{256} << 20U;

std::int64_t countOf(std::uint64_t messages) {
  return static_cast<std::int64_t>(std::min(messages, std::uint64_t{1} << 48));
}

/// Numbers of messages in a record of statistics.
void takeStatistics(ByteReader& fields, McapIndex& index) {
  index.all_messages = countOf(fields.number<std::uint64_t>());
  fields.take(2 + 4 * 4 + 2 * 8);  // totals of other records, first and last time
  ByteReader pairs(fields.take(fields.number<std::uint32_t>()));
  while (fields.ok() && pairs.left() > 0) {
    const auto channel = pairs.number<std::uint16_t>();
    const auto messages = pairs.number<std::uint64_t>();
    if (!pairs.ok()) return;
    index.messages[channel] = countOf(messages);
  }
}

/// Whether all records of the summary were read.
bool takeRecords(Bytes summary, McapIndex& index) {
  ByteReader records(summary);
  while (records.left() > 0) {
    const auto kind = records.number<std::uint8_t>();
    ByteReader fields(records.take(records.number<std::uint64_t>()));
    if (!records.ok()) return false;
    if (kind == kMcapSchema) takeSchema(fields, index.types);
    if (kind == kMcapChannel) takeChannel(fields, index.types, index.topics);
    if (kind == kMcapStatistics) takeStatistics(fields, index);
    if (!fields.ok()) return false;
  }
  return true;
}

/// Reads the summary from `begin` to the end of the footer's second number, which its sum covers.
std::string takeSummary(FileBytes& file, std::uint64_t begin, std::uint64_t footer_at,
                        std::uint32_t sum, McapIndex& index) {
  if (footer_at - begin > kMostIndexBytes) return "has more than 256 MiB";
  std::vector<std::uint8_t> bytes(
      static_cast<std::size_t>(footer_at - begin + kMcapRecordHeader + 2 * sizeof(std::uint64_t)));
  if (!file.read(begin, bytes)) return "cannot be read";
  if (sum != 0 && sum != crc32_z(0, bytes.data(), bytes.size())) {
    return "does not match its check sum";
  }
  const Bytes summary = Bytes(bytes).first(static_cast<std::size_t>(footer_at - begin));
  return takeRecords(summary, index) ? "" : "is damaged";
}

}  // namespace

McapIndex readMcapIndex(FileBytes& file) {
  McapIndex index;
  index.problem = "is missing";
  std::array<std::uint8_t, kTail> tail{};
  std::array<std::uint8_t, kMcapMagicSize> magic{};
  if (file.size() < kMcapMagicSize + kTail || !file.read(file.size() - kTail, tail)) return index;
  if (!file.read(0, magic) ||
      !std::equal(magic.begin(), magic.end(), tail.end() - kMcapMagicSize)) {
    return index;
  }
  ByteReader fields(tail);
  if (fields.number<std::uint8_t>() != kMcapFooter) return index;
  if (fields.number<std::uint64_t>() != kFooterSize) return index;
  const auto begin = fields.number<std::uint64_t>();
  fields.number<std::uint64_t>();  // offsets of groups in the summary
  const auto sum = fields.number<std::uint32_t>();
  const std::uint64_t footer_at = file.size() - kTail;
  index.begin = begin == 0 ? footer_at : begin;
  index.problem = "is damaged";
  if (begin > footer_at || (begin != 0 && begin < kMcapMagicSize)) return index;
  index.problem = begin == 0 ? "" : takeSummary(file, begin, footer_at, sum, index);
  if (!index.problem.empty()) {
    index.types.clear();
    index.topics.clear();
    index.messages.clear();
    index.all_messages = 0;
  }
  return index;
}

void takeSchema(ByteReader& fields, McapTypes& types) {
  const auto id = fields.number<std::uint16_t>();
  const std::string name(fields.text());
  if (fields.ok()) types[id] = name;
}

bool takeChannel(ByteReader& fields, const McapTypes& types, McapTopics& topics) {
  const auto id = fields.number<std::uint16_t>();
  const auto schema = fields.number<std::uint16_t>();
  const std::string name(fields.text());
  const std::string encoding(fields.text());
  if (!fields.ok()) return true;
  const auto type = types.find(schema);
  const Topic topic{name, type == types.end() ? "" : type->second, encoding};
  const auto [known, is_new] = topics.emplace(id, topic);
  return is_new || known->second == topic;
}

}  // namespace tolman::ros_bag
