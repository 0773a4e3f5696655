// SPDX-License-Identifier: BSD-3-Clause
#include "record/answers_file.hpp"

#include <array>
#include <cstring>
#include <optional>

#include "record/answers_codec.hpp"
#include "record/regular_file.hpp"
#include "record/run_id.hpp"

namespace tolman::record {
namespace {

constexpr std::string_view kAnswersMagic = "TLMANSW2";
constexpr std::int64_t kAnswersStart = -1;
constexpr std::int64_t kAnswersEnd = -2;
constexpr std::uint64_t kMaxTextBytes = 1U << 20U;  // of a text in the first block

struct AnswersBlock {
  std::int64_t tag = 0;
  std::uint64_t size = 0;
  std::uint64_t checksum = 0;
};

std::uint64_t answersChecksum(std::string_view payload) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : payload) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

template <class... T>
std::string encoded(const T&... values) {
  AnswersEncoder encoder;
  (encoder.put(values), ...);
  return encoder.take();
}

template <class T>
T rawAt(std::ifstream& stream) {
  std::array<char, sizeof(T)> bytes{};
  stream.read(bytes.data(), bytes.size());
  return std::bit_cast<T>(bytes);
}

/// The next block with a complete payload; none at the end or where the file is damaged.
std::optional<AnswersBlock> nextBlock(std::ifstream& stream) {
  const auto block = rawAt<AnswersBlock>(stream);
  if (!stream || block.size > (std::uint64_t{1} << 32U)) return std::nullopt;
  std::string payload(block.size, '\0');
  stream.read(payload.data(), static_cast<std::streamsize>(payload.size()));
  if (!stream || answersChecksum(payload) != block.checksum) return std::nullopt;
  return block;
}

/// The id in the first block: its second text. Empty where there is none.
std::string answersRunId(const std::filesystem::path& file) {
  std::ifstream stream = openRegular(file);
  stream.seekg(static_cast<std::streamoff>(kAnswersMagic.size() + sizeof(AnswersBlock)));
  const auto names = rawAt<std::uint64_t>(stream);
  if (!stream || names > kMaxTextBytes) return "";
  stream.seekg(static_cast<std::streamoff>(names), std::ios::cur);
  const auto size = rawAt<std::uint64_t>(stream);
  if (!stream || size > kMaxTextBytes) return "";
  std::string id(size, '\0');
  stream.read(id.data(), static_cast<std::streamsize>(size));
  return stream ? id : "";
}

/// Whether all blocks match their checksums and the last one is the end.
bool isWhole(const std::filesystem::path& file) {
  std::ifstream stream = openRegular(file);
  stream.seekg(static_cast<std::streamoff>(kAnswersMagic.size()));
  auto block = nextBlock(stream);
  if (!block || block->tag != kAnswersStart) return false;
  std::int64_t last = kAnswersStart;
  for (block = nextBlock(stream); block && block->tag > last; block = nextBlock(stream)) {
    last = block->tag;
  }
  return block && block->tag == kAnswersEnd && stream.peek() == std::ifstream::traits_type::eof();
}

}  // namespace

Result<AnswersFile> AnswersFile::create(const std::filesystem::path& directory,
                                        const SourceInfo& source,
                                        const std::vector<ArrayInfo>& sensors,
                                        const std::string& run_id) {
  AnswersFile file(directory / kAnswersFile);
  Status status = file.open(std::ios::trunc);
  if (!status.isOk()) return status;
  file.stream_ << kAnswersMagic;
  const std::string names = fieldNames<SourceInfo>() + fieldNames<ArrayInfo>() +
                            fieldNames<Frame>() + fieldNames<Motion>() +
                            fieldNames<PlaceObservation>();
  status = file.block(kAnswersStart, encoded(names, run_id, encoded(source), encoded(sensors)));
  if (!status.isOk()) return status;
  return file;
}

Result<AnswersFile> AnswersFile::reopen(const std::filesystem::path& directory,
                                        std::int64_t next_frame, const std::string& run_id) {
  AnswersFile file(directory / kAnswersFile);
  Status of_run = isOfRun(file.file_, answersRunId(file.file_), run_id);
  if (!of_run.isOk()) return of_run;
  std::ifstream stream = openRegular(file.file_);
  stream.seekg(static_cast<std::streamoff>(kAnswersMagic.size()));
  std::int64_t last = kAnswersStart;
  std::streamoff end = -1;
  for (auto block = nextBlock(stream); block && block->tag == (end < 0 ? kAnswersStart : last + 1);
       block = nextBlock(stream)) {
    last = block->tag;
    end = stream.tellg();
    if (last == next_frame - 1) break;
  }
  if (end < 0 || last != next_frame - 1) {
    return Status::invalidInput(file.file_.string() + ": has no answers of frame " +
                                std::to_string(last + 1) + "; run it again");
  }
  std::error_code error;
  std::filesystem::resize_file(file.file_, static_cast<std::uintmax_t>(end), error);
  if (error) return Status::failed(file.file_.string() + ": " + error.message());
  Status status = file.open(std::ios::app);
  if (!status.isOk()) return status;
  return file;
}

Status AnswersFile::open(std::ios::openmode mode) {
  stream_.open(file_, std::ios::binary | std::ios::out | mode);
  return stream_ ? Status::ok() : Status::failed(file_.string() + ": cannot be written");
}

Status AnswersFile::block(std::int64_t tag, const std::string& payload) {
  const AnswersBlock header{tag, payload.size(), answersChecksum(payload)};
  stream_.write(reinterpret_cast<const char*>(&header), sizeof header);
  stream_.write(payload.data(), static_cast<std::streamsize>(payload.size()));
  if (stream_) return Status::ok();
  return Status::failed(file_.string() + ": cannot be written; look for a full disk");
}

/// Writes the points of one points_frame only once, as in run.sqlite.
Status AnswersFile::add(const Frame& frame, const Motion& motion, const PlaceObservation& place) {
  const bool same = motion.points.cols() > 0 && motion.points_frame == points_frame_;
  std::string answer;
  if (same) {
    Motion without_points = motion;
    without_points.points.resize(Eigen::NoChange, 0);
    answer = encoded(same, without_points);
  } else {
    answer = encoded(same, motion);
    if (motion.points.cols() > 0) points_frame_ = motion.points_frame;
  }
  return block(frame.frame, encoded(encoded(frame), answer, encoded(place)));
}

Status AnswersFile::flush() {
  stream_.flush();
  return stream_ ? Status::ok()
                 : Status::failed(file_.string() + ": cannot be written; look for a full disk");
}

Status AnswersFile::finish(const std::vector<MotionRevision>& revisions) {
  Status status = block(kAnswersEnd, encoded(encoded(revisions)));
  if (status.isOk()) status = flush();
  if (!status.isOk() || isWhole(file_)) return status;
  return Status::failed(file_.string() +
                        ": was removed or changed while the run was going; run it again");
}

bool hasAnswers(const std::filesystem::path& directory) {
  std::ifstream stream = openRegular(directory / kAnswersFile);
  stream.seekg(static_cast<std::streamoff>(kAnswersMagic.size()));
  for (auto block = rawAt<AnswersBlock>(stream); stream; block = rawAt<AnswersBlock>(stream)) {
    if (block.size > (std::uint64_t{1} << 32U)) return false;
    stream.seekg(static_cast<std::streamoff>(block.size), std::ios::cur);
    if (block.tag == kAnswersEnd) return stream.peek() == std::ifstream::traits_type::eof();
  }
  return false;
}

}  // namespace tolman::record
