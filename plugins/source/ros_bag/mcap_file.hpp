// SPDX-License-Identifier: BSD-3-Clause
// A bag in the MCAP container (mcap.dev): records of a type, a length and contents; messages stand
// alone or in compressed chunks. Read from the start to the end: the index at the end is not
// needed, so that recordings that were killed can be read.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "bag_file.hpp"
#include "file_bytes.hpp"

namespace tolman::ros_bag {

class McapFile final : public BagFile {
 public:
  explicit McapFile(FileBytes file) : file_(std::move(file)) {}
  /// Whether the file begins as an MCAP file does.
  static bool isMcap(FileBytes& file);

  void visit(const MessageVisitor& visitor, std::vector<std::string>& problems) override;
  Result<std::vector<std::uint8_t>> read(const MessagePlace& place) override;

 private:
  struct Scan {
    const MessageVisitor& visitor;
    std::vector<std::string>& problems;
    std::map<std::uint16_t, std::string> types;  ///< by the number of the schema
    std::map<std::uint16_t, Topic> topics;       ///< by the number of the channel
  };
  using Contents = std::vector<std::uint8_t>;

  /// The contents of the record at `at`; none where the file ends before, which is told.
  std::optional<Contents> readRecord(std::uint64_t at, std::uint64_t size, Scan& scan);
  /// `chunk`: start of the chunk whose record this is, 0 for none; `at`: start of the contents.
  void visitRecord(std::uint8_t kind, Bytes contents, std::uint64_t chunk, std::uint64_t at,
                   Scan& scan);
  void visitMessage(Bytes contents, std::uint64_t chunk, std::uint64_t at, Scan& scan);
  void visitChunk(Bytes contents, std::uint64_t at, Scan& scan);
  /// The records of a chunk, from its contents.
  static Result<Contents> unpack(Bytes contents);
  Result<const Contents*> chunkAt(std::uint64_t at);

  FileBytes file_;
  std::deque<std::pair<std::uint64_t, Contents>> chunks_;  ///< unpacked last, at most two
};

}  // namespace tolman::ros_bag
