// SPDX-License-Identifier: BSD-3-Clause
// Bags of ROS 1.
//
// One record of a ROS 1 bag: a header of fields `name=value`, and data, each after its length.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

#include "bag.hpp"
#include "file_bytes.hpp"

namespace tolman::ros_bag {

enum class Ros1Kind : std::uint8_t {
  None = 0,
  Message = 2,
  BagHeader = 3,
  Index = 4,
  Chunk = 5,
  ChunkInfo = 6,
  Connection = 7,
};

/// A view of the bytes that it was read from.
struct Ros1Record {
  Bytes header;
  Bytes data;
  std::uint64_t data_at = 0;  ///< offset of the data from the start of the record

  /// The value of the field; empty if it is missing, or if the header is damaged before it.
  std::optional<Bytes> field(std::string_view name) const;
  /// The value as a number of exactly its size.
  template <class T>
  std::optional<T> number(std::string_view name) const {
    const std::optional<Bytes> value = field(name);
    if (!value || value->size() != sizeof(T)) return std::nullopt;
    return ByteReader(*value).number<T>();
  }
  /// None: it has no kind, or a damaged one.
  Ros1Kind kind() const;
};

/// The next record; empty if it is incomplete.
std::optional<Ros1Record> takeRecord(ByteReader& bytes);

/// Time of a message, ns since 1970; empty if it is missing. ROS 1 stores the seconds without a
/// sign; from 2038 on they are taken as those before 1970, which a wrong clock gives.
std::optional<std::int64_t> timeOf(const Ros1Record& message);

/// The topic of a connection record; its type is in the notation of ROS 2.
std::optional<Topic> topicOf(const Ros1Record& connection);

/// The unpacked records of a chunk. InvalidInput or Unsupported; the message does not name the
/// place.
Result<std::vector<std::uint8_t>> unpackChunk(const Ros1Record& chunk);

// A ROS 1 bag, format 2.0 (wiki.ros.org/Bags/Format/2.0): records of a header with named fields and
// of data; messages are in chunks, which may be compressed. The file is read from start to end
// without the index, so that interrupted recordings can be read.

class Ros1File final : public ChunkedFile {
 public:
  /// Unsupported for other versions of the format, InvalidInput for a file that does not begin as a
  /// bag does. Messages do not contain the name of the file.
  static Result<std::unique_ptr<Ros1File>> open(FileBytes file);
  /// Whether the file begins as a ROS 1 bag of any version does.
  static bool isRos1(FileBytes& file);

  void visit(const MessageVisitor& visitor, const DamageVisitor& damage) override;

 private:
  struct Scan {
    const MessageVisitor& visitor;
    const DamageVisitor& damage;
    std::map<std::uint32_t, Topic> topics;  ///< by the number of the connection
  };

  explicit Ros1File(FileBytes file) : ChunkedFile(std::move(file)) {}
  /// The bytes of the record at `at`.
  Result<Contents> readRecord(std::uint64_t at);
  /// `chunk`: start of the chunk whose record this is, 0 for none; `at`: start of the record.
  void visitRecord(const Ros1Record& record, std::uint64_t chunk, std::uint64_t at, Scan& scan);
  static void visitMessage(const Ros1Record& record, std::uint64_t chunk, std::uint64_t at,
                           Scan& scan);
  void visitChunk(const Ros1Record& chunk, std::uint64_t at, Scan& scan);
  Result<Contents> readChunk(std::uint64_t at) override;
};

}  // namespace tolman::ros_bag
