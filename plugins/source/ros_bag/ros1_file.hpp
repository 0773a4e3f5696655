// SPDX-License-Identifier: BSD-3-Clause
// A ROS 1 bag, format 2.0 (wiki.ros.org/Bags/Format/2.0): records of a header with named fields and
// of data; messages are in chunks, which may be compressed. The file is read from start to end
// without the index, so that interrupted recordings can be read.
#pragma once

#include <map>
#include <memory>

#include "chunked_file.hpp"
#include "ros1_record.hpp"

namespace tolman::ros_bag {

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
