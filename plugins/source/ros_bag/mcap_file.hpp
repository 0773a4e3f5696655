// SPDX-License-Identifier: BSD-3-Clause
// A bag in the MCAP container (mcap.dev): records of a type, a length and contents; messages are
// single records or in compressed chunks. The file is read from start to end without its index, so
// that interrupted recordings can be read.
#pragma once

#include <map>
#include <utility>

#include "file_bytes.hpp"

namespace tolman::ros_bag {

class McapFile final : public ChunkedFile {
 public:
  explicit McapFile(FileBytes file) : ChunkedFile(std::move(file)) {}
  /// Whether the file begins as an MCAP file does.
  static bool isMcap(FileBytes& file);

  void visit(const MessageVisitor& visitor, const DamageVisitor& damage) override;

 private:
  struct Scan {
    const MessageVisitor& visitor;
    const DamageVisitor& damage;
    std::map<std::uint16_t, std::string> types;  ///< by the number of the schema
    std::map<std::uint16_t, Topic> topics;       ///< by the number of the channel
  };

  /// `chunk`: start of the chunk whose record this is, 0 for none; `at`: start of the contents.
  void visitRecord(std::uint8_t kind, Bytes contents, std::uint64_t chunk, std::uint64_t at,
                   Scan& scan);
  static void visitMessage(Bytes contents, std::uint64_t chunk, std::uint64_t at, Scan& scan);
  void visitChunk(Bytes contents, std::uint64_t at, Scan& scan);
  /// The records of a chunk, from its contents.
  static Result<Contents> unpack(Bytes contents);
  Result<Contents> readChunk(std::uint64_t at) override;
};

}  // namespace tolman::ros_bag
