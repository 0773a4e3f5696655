// SPDX-License-Identifier: BSD-3-Clause
#include "ros1_record.hpp"

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

}  // namespace tolman::ros_bag
