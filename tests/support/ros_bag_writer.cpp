// SPDX-License-Identifier: BSD-3-Clause
#include "support/ros_bag_writer.hpp"

#include <lz4frame.h>
#include <sqlite3.h>
#include <zlib.h>
#include <zstd.h>

#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>

namespace tolman::test {
namespace {

template <class T>
std::string raw(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string prefixed(const std::string& text) {
  return raw(static_cast<std::uint32_t>(text.size())) + text;
}

std::string record(std::uint8_t kind, const std::string& contents) {
  return raw(kind) + raw(static_cast<std::uint64_t>(contents.size())) + contents;
}

std::string packedByLz4(const std::string& bytes) {
  std::string packed(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  packed.resize(
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), nullptr));
  return packed;
}

std::string chunk(const std::string& records, const McapStyle& style) {
  std::string packed = records;
  if (style.compression == "zstd") packed = packedByZstd(records);
  if (style.compression == "lz4") packed = packedByLz4(records);
  const auto sum =
      crc32(0, reinterpret_cast<const Bytef*>(records.data()), static_cast<uInt>(records.size()));
  return record(6, raw(std::int64_t{0}) + raw(std::int64_t{0}) +
                       raw(static_cast<std::uint64_t>(records.size())) +
                       raw(static_cast<std::uint32_t>(style.sums ? sum : 0)) +
                       prefixed(style.compression) +
                       raw(static_cast<std::uint64_t>(packed.size())) + packed);
}

/// Numbers of messages by channel.
using Counts = std::map<std::uint16_t, std::uint32_t>;

/// The indices of the messages of a chunk; times and places of messages are not filled in.
std::string chunkIndices(const Counts& counts) {
  std::string bytes;
  for (const auto& [id, count] : counts) {
    bytes += record(7, raw(id) + prefixed(std::string(16 * count, '\0')));
  }
  return bytes;
}

std::string statistics(const Counts& counts, bool totals_only) {
  std::string pairs;
  std::uint64_t all = 0;
  for (const auto& [id, count] : counts) {
    pairs += raw(id) + raw(std::uint64_t{count});
    all += count;
  }
  return record(11, raw(all) + std::string(34, '\0') + prefixed(totals_only ? "" : pairs));
}

std::string footer(std::uint64_t summary_at, const std::string& summary) {
  if (summary.empty()) return record(2, std::string(20, '\0'));
  const std::string kind_and_size = raw(std::uint8_t{2}) + raw(std::uint64_t{20});
  const std::string numbers = raw(summary_at) + raw(std::uint64_t{0});
  const std::string summed = summary + kind_and_size + numbers;
  const auto sum =
      crc32(0, reinterpret_cast<const Bytef*>(summed.data()), static_cast<uInt>(summed.size()));
  return kind_and_size + numbers + raw(static_cast<std::uint32_t>(sum));
}

std::string declared(std::uint16_t id, const RosMessage& message, const McapStyle& style) {
  const std::string schema = raw(id) + prefixed(message.type) + prefixed("ros2msg") + prefixed("");
  const std::string channel =
      raw(id) + raw(id) + prefixed(message.topic) + prefixed(style.encoding) + prefixed("");
  return record(3, schema) + record(4, channel);
}

void execute(sqlite3* database, const char* sql) {
  if (sqlite3_exec(database, sql, nullptr, nullptr, nullptr) != SQLITE_OK) {
    throw std::runtime_error(sqlite3_errmsg(database));
  }
}

}  // namespace

std::string imageMessage(const RosImage& image, bool big_endian) {
  const auto step = static_cast<std::uint32_t>(image.pixels.size() / image.height);
  return CdrWriter(big_endian)
      .header(image.stamp_ns)
      .number(image.height)
      .number(image.width)
      .text(image.encoding)
      .number(static_cast<std::uint8_t>(image.big_endian ? 1 : 0))
      .number(step)
      .data(image.pixels)
      .bytes();
}

std::string compressedImageMessage(std::int64_t stamp_ns, const std::string& format,
                                   const std::string& coded) {
  return CdrWriter().header(stamp_ns).text(format).data(coded).bytes();
}

RosCamera plainCamera(std::uint32_t width, std::uint32_t height, double focal, double baseline) {
  const double cx = (width - 1) / 2.0;
  const double cy = (height - 1) / 2.0;
  RosCamera camera{width, height, "plumb_bob", {0, 0, 0, 0, 0}, {}, {}, {}, 0};
  camera.K = {focal, 0, cx, 0, focal, cy, 0, 0, 1};
  camera.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  camera.P = {focal, 0, cx, -focal * baseline, 0, focal, cy, 0, 0, 0, 1, 0};
  return camera;
}

std::string cameraInfoMessage(const RosCamera& camera) {
  CdrWriter message;
  message.header(1'000'000'000).number(camera.height).number(camera.width).text(camera.model);
  message.number(static_cast<std::uint32_t>(camera.D.size())).numbers(camera.D);
  message.numbers(camera.K).numbers(camera.R).numbers(camera.P);
  message.number(camera.binning).number(camera.binning);
  for (int i = 0; i < 4; ++i) message.number(std::uint32_t{0});  // region of interest
  return message.number(std::uint8_t{0}).bytes();
}

std::string imuMessage(std::int64_t stamp_ns, const std::vector<double>& angular_velocity,
                       const std::vector<double>& linear_acceleration) {
  const std::vector<double> unknown(9, 0);
  CdrWriter message;
  message.header(stamp_ns).numbers({0, 0, 0, 1}).numbers(unknown);
  message.numbers(angular_velocity).numbers(unknown);
  return message.numbers(linear_acceleration).numbers(unknown).bytes();
}

std::string odometryMessage(std::int64_t stamp_ns, double x, double y, double theta, double speed,
                            const std::string& frame, double turn_rate) {
  const std::vector<double> unknown(36, 0);
  CdrWriter message;
  message.header(stamp_ns, frame).text("base").numbers({x, y, 0});
  message.numbers({0, 0, std::sin(theta / 2), std::cos(theta / 2)}).numbers(unknown);
  return message.numbers({speed, 0, 0, 0, 0, turn_rate}).numbers(unknown).bytes();
}

std::string mcapBytes(const std::vector<RosMessage>& messages, const McapStyle& style) {
  const std::string magic = "\x89MCAP0\r\n";
  std::string bytes = magic + record(1, prefixed("ros2") + prefixed("test"));
  std::map<std::string, std::uint16_t> ids;
  std::string declarations;
  Counts all;
  Counts in_chunk;
  std::string open;
  std::size_t count = 0;
  const auto close = [&] {
    bytes += style.chunks ? chunk(open, style) : open;
    if (style.chunks && style.indexed) bytes += chunkIndices(in_chunk);
    open.clear();
    in_chunk.clear();
  };
  for (const RosMessage& message : messages) {
    const auto [id, is_new] =
        ids.emplace(message.topic, static_cast<std::uint16_t>(ids.size() + 1));
    if (is_new) open += declared(id->second, message, style);
    if (is_new) declarations += declared(id->second, message, style);
    open += record(5, raw(id->second) + raw(std::uint32_t{0}) + raw(message.log_ns) +
                          raw(message.log_ns) + message.bytes);
    ++all[id->second];
    ++in_chunk[id->second];
    if (style.chunks && ++count % style.per_chunk == 0) close();
  }
  if (!open.empty()) close();
  std::uint32_t sum = 0;
  if (style.summed_from >= 0) {
    const std::string summed = bytes.substr(static_cast<std::size_t>(style.summed_from));
    sum = static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(summed.data()), static_cast<uInt>(summed.size())));
  }
  bytes += record(15, raw(sum));
  const std::string summary =
      style.indexed ? declarations + statistics(all, style.totals_only) : "";
  return bytes + summary + footer(bytes.size(), summary) + magic;
}

void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string packedByZstd(const std::string& bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
  return packed;
}

void writeDb3(const std::filesystem::path& file, const std::vector<RosMessage>& messages,
              bool compressed) {
  sqlite3* database = nullptr;
  if (sqlite3_open(file.c_str(), &database) != SQLITE_OK) throw std::runtime_error("no database");
  execute(database,
          "PRAGMA page_size = 512; PRAGMA journal_mode = OFF; BEGIN;"
          "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
          " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
          "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,"
          " timestamp INTEGER NOT NULL, data BLOB NOT NULL)");
  std::map<std::string, int> ids;
  for (const RosMessage& message : messages) {
    const auto [id, is_new] = ids.emplace(message.topic, static_cast<int>(ids.size() + 1));
    if (is_new) {
      const std::string sql = "INSERT INTO topics VALUES (" + std::to_string(id->second) + ", '" +
                              message.topic + "', '" + message.type + "', 'cdr', '')";
      execute(database, sql.c_str());
    }
    const std::string data = compressed ? packedByZstd(message.bytes) : message.bytes;
    sqlite3_stmt* insert = nullptr;
    sqlite3_prepare_v2(database, "INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)",
                       -1, &insert, nullptr);
    sqlite3_bind_int(insert, 1, id->second);
    sqlite3_bind_int64(insert, 2, message.log_ns);
    sqlite3_bind_blob(insert, 3, data.data(), static_cast<int>(data.size()), SQLITE_TRANSIENT);
    sqlite3_step(insert);
    sqlite3_finalize(insert);
  }
  execute(database, "CREATE INDEX timestamp_idx ON messages (timestamp ASC); COMMIT");
  sqlite3_close(database);
}

}  // namespace tolman::test
