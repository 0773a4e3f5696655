// SPDX-License-Identifier: BSD-3-Clause
// A bag in the MCAP container (mcap.dev): records of a type, a length and contents; messages are
// single records or in compressed chunks. The file is read from start to end, so that interrupted
// recordings can be read; indices, where they are, tell which messages are missing.
#pragma once

#include <optional>
#include <utility>

#include "chunked_file.hpp"
#include "mcap_index.hpp"
#include "message_counts.hpp"

namespace tolman::ros_bag {

class McapFile final : public ChunkedFile {
 public:
  explicit McapFile(FileBytes file) : ChunkedFile(std::move(file)) {}
  /// Whether the file begins as an MCAP file does.
  static bool isMcap(FileBytes& file);

  void visit(const MessageVisitor& visitor, FileDamage& damage) override;

 private:
  struct Scan {
    const MessageVisitor& visitor;
    FileDamage& damage;
    McapTypes types;
    McapTopics topics;
    MessageCounts counts;       ///< by the number of the channel
    Repeated damaged;           ///< messages
    Repeated wrong_clock;       ///< messages
    bool has_unsummed = false;  ///< messages without a check sum of their own, or of their chunk
  };

  std::optional<std::uint64_t> visitRecords(Scan& scan);
  /// Compares the check sum of all data, in the record DataEnd with contents at `at`, where
  /// messages have no other.
  void checkSum(std::uint64_t at, std::uint64_t size, Scan& scan);
  /// `chunk`: start of the chunk whose record this is, 0 for none; `at`: start of the contents.
  void visitRecord(std::uint8_t kind, Bytes contents, std::uint64_t chunk, std::uint64_t at,
                   Scan& scan);
  void visitMessage(Bytes contents, std::uint64_t chunk, std::uint64_t at, Scan& scan);
  void visitChunk(Bytes contents, std::uint64_t at, Scan& scan);
  /// The records of a chunk, from its contents.
  static Result<Contents> unpack(Bytes contents);
  Result<Contents> readChunk(std::uint64_t at) override;
};

}  // namespace tolman::ros_bag
