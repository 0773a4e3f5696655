// SPDX-License-Identifier: BSD-3-Clause
// A ROS 1 bag, format 2.0 (wiki.ros.org/Bags/Format/2.0): records of a header with named fields and
// of data; messages are in chunks, which may be compressed. The file is read from start to end
// without the index, so that interrupted recordings can be read.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "chunked_file.hpp"
#include "message_counts.hpp"
#include "ros1_record.hpp"

namespace tolman::ros_bag {

class Ros1File final : public ChunkedFile {
 public:
  /// Unsupported for other versions of the format, InvalidInput for a file that does not begin as a
  /// bag does. Messages do not contain the name of the file.
  static Result<std::unique_ptr<Ros1File>> open(FileBytes file);
  /// Whether the file begins as a ROS 1 bag of any version does.
  static bool isRos1(FileBytes& file);

  void visit(const MessageVisitor& visitor, FileDamage& damage) override;

 private:
  struct Scan {
    const MessageVisitor& visitor;
    FileDamage& damage;
    std::map<std::uint32_t, Topic> topics;  ///< by the number of the connection
    MessageCounts counts;                   ///< by the same
    Repeated damaged;                       ///< messages
    Repeated wrong_clock;                   ///< messages
  };

  explicit Ros1File(FileBytes file) : ChunkedFile(std::move(file)) {}
  bool readIndex(std::uint64_t begin, Scan& scan);
  bool visitRecords(std::uint64_t end, Scan& scan);
  /// False if the connection is damaged, or already another topic.
  static bool takeConnection(const Ros1Record& record, Scan& scan);
  /// The bytes of the record at `at`. If the file is too short or the record too large: empty, and
  /// the problem is reported.
  std::optional<Contents> readRecord(std::uint64_t at, Problems& problems);
  /// `chunk`: start of the chunk whose record this is, 0 for none; `at`: start of the record.
  void visitRecord(const Ros1Record& record, std::uint64_t chunk, std::uint64_t at, Scan& scan);
  void visitMessage(const Ros1Record& record, std::uint64_t chunk, std::uint64_t at, Scan& scan);
  void visitChunk(const Ros1Record& chunk, std::uint64_t at, Scan& scan);
  Result<Contents> readChunk(std::uint64_t at) override;
};

}  // namespace tolman::ros_bag
