// SPDX-License-Identifier: BSD-3-Clause
#include "answers_reader.hpp"

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "answers_decoder.hpp"
#include "base/bounded_json.hpp"

namespace tolman::answers_file {
namespace {

constexpr std::string_view kMagic = "TLMANSW2";
constexpr std::int64_t kStart = -1;
constexpr std::int64_t kEnd = -2;
constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 32U;  // of one block

std::uint64_t checksum(std::string_view payload) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : payload) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

std::string expectedNames() {
  return fieldNames<SourceInfo>() + fieldNames<ArrayInfo>() + fieldNames<Frame>() +
         fieldNames<Motion>() + fieldNames<PlaceObservation>();
}

/// The run.json beside answers.bin; no object where it is missing or damaged.
nlohmann::json runFile(const std::string& answers) {
  std::ifstream stream(std::filesystem::path(answers).replace_filename("run.json"));
  return bounded_json::parse<nlohmann::json>(stream);
}

std::string partOf(const nlohmann::json& run, std::int64_t promised, std::int64_t recorded) {
  const auto status = run.is_object() ? run.find("status") : run.end();
  if (recorded >= promised || status == run.end()) return "";
  const bool interrupted = *status == "interrupted";
  if (!interrupted && *status != "failed") return "";
  return "has " + std::to_string(recorded) + " of the " + std::to_string(promised) +
         " frames of its source, because its run " +
         (interrupted ? "was interrupted; `tolman run --resume` goes on with it"
                      : "failed; run it again for all of them");
}

}  // namespace

Status AnswersReader::damaged(const std::string& what) const {
  return Status::invalidInput(file_ + ": " + what);
}

Status AnswersReader::open(const std::string& run) {
  file_ = (std::filesystem::path(run) / "answers.bin").string();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file_, ignored)) {
    return damaged("is not there; record the run with `record.replay: true`");
  }
  const auto bytes = static_cast<std::streamoff>(std::filesystem::file_size(file_, ignored));
  stream_.open(file_, std::ios::binary);
  std::array<char, 8> magic{};
  stream_.read(magic.data(), magic.size());
  if (std::string_view(magic.data(), magic.size()) != kMagic) return damaged("is no such file");
  blocks_.clear();
  Block start;
  for (Block block; end_.tag != kEnd;) {
    std::array<std::uint64_t, 3> words{};
    stream_.read(reinterpret_cast<char*>(words.data()), sizeof words);
    block = {static_cast<std::int64_t>(words[0]), words[1], words[2], stream_.tellg()};
    if (!stream_ || block.size > kMaxBytes ||
        block.start + static_cast<std::streamoff>(block.size) > bytes) {
      return damaged(
          "the run has not ended, or the file was cut off: `tolman run --resume` goes on with "
          "the run, if it has not ended; otherwise run it again");
    }
    stream_.seekg(static_cast<std::streamoff>(block.size), std::ios::cur);
    if (block.tag == kStart) {
      start = block;
    } else if (block.tag == kEnd) {
      end_ = block;
    } else if (block.tag == frames()) {
      blocks_.push_back(block);
    } else {
      return damaged("frame " + std::to_string(frames()) +
                     " is missing; a run that dropped frames or continued a map has no replay");
    }
  }
  return readStart(start);
}

Status AnswersReader::readStart(const Block& block) {
  Status status = readPayload(block);
  if (!status.isOk()) return status;
  AnswersDecoder texts(payload_);
  if (texts.text() != expectedNames()) {
    return damaged("was written by a version with other records; record the run again");
  }
  const nlohmann::json run = runFile(file_);
  status = checkRun(run, texts.text());
  if (!status.isOk()) return status;
  AnswersDecoder source(texts.text());
  AnswersDecoder sensors(texts.text());
  source.get(source_);
  sensors.get(sensors_);
  part_ = partOf(run, source_.frames, frames());
  source_.frames = frames();
  return source.complete() && sensors.complete() ? Status::ok() : damaged("is damaged");
}

/// The answers must be of the run whose run.json lies beside them, if it has an id.
Status AnswersReader::checkRun(const nlohmann::json& run, std::string_view id) const {
  if (!run.is_object() || !run.contains("id") || run["id"] == id) return Status::ok();
  return damaged("is of another run than the run.json beside it; put back the file of that run");
}

void AnswersReader::rewind() {
  next_motion_ = 0;
  points_.resize(Eigen::NoChange, 0);
}

Status AnswersReader::readPayload(const Block& block) {
  stream_.clear();
  stream_.seekg(block.start);
  payload_.resize(block.size);
  stream_.read(payload_.data(), static_cast<std::streamsize>(payload_.size()));
  if (!stream_ || checksum(payload_) != block.checksum) return damaged("is damaged");
  return Status::ok();
}

Status AnswersReader::readFrame(std::int64_t frame) {
  if (frame == frames() && !part_.empty()) return damaged(part_);
  if (frame < 0 || frame >= frames()) {
    return damaged("has no frame " + std::to_string(frame) + "; take source, odometry and place " +
                   "of one record, in a run that continues no map");
  }
  return readPayload(blocks_[static_cast<std::size_t>(frame)]);
}

Status AnswersReader::read(std::int64_t frame, Frame& answer) {
  Status status = readFrame(frame);
  if (!status.isOk()) return status;
  AnswersDecoder texts(payload_);
  AnswersDecoder decoder(texts.text());
  decoder.get(answer);
  return decoder.complete() ? Status::ok() : damaged("is damaged");
}

/// Checks that the recorded answers are of this drive. Frame number and time are not enough: they
/// are often equal in different drives.
Status AnswersReader::compare(std::string_view recorded, const Frame& frame) const {
  AnswersDecoder decoder(recorded);
  const auto then = decoder.next<Frame>();
  if (!decoder.complete()) return damaged("is damaged");
  const bool has_truth = then.has_truth && frame.has_truth;
  if (then.stamp_ns == frame.stamp_ns && then.source_index == frame.source_index &&
      (!has_truth || then.T_world_camera_truth.matrix() == frame.T_world_camera_truth.matrix())) {
    return Status::ok();
  }
  return damaged("frame " + std::to_string(frame.frame) +
                 " has another time, place in the data set or true pose than in this run; take " +
                 "source, odometry and place of one record");
}

/// Frames that were left out are read as well, because points are stored only when they change.
Status AnswersReader::read(const Frame& frame, Motion& answer) {
  for (bool same = false; next_motion_ <= frame.frame; ++next_motion_) {
    Status status = readFrame(next_motion_);
    if (!status.isOk()) return status;
    AnswersDecoder texts(payload_);
    const std::string_view recorded = texts.text();
    if (next_motion_ == frame.frame) status = compare(recorded, frame);
    if (!status.isOk()) return status;
    AnswersDecoder decoder(texts.text());
    decoder.get(same);
    answer = decoder.next<Motion>();
    if (!decoder.complete()) return damaged("is damaged");
    if (answer.points.cols() > 0) points_ = answer.points;
    if (same) answer.points = points_;
  }
  return answer.frame == frame.frame ? Status::ok() : damaged("frames were asked for out of order");
}

Status AnswersReader::read(const Frame& frame, PlaceObservation& answer) {
  Status status = readFrame(frame.frame);
  if (!status.isOk()) return status;
  AnswersDecoder texts(payload_);
  status = compare(texts.text(), frame);
  if (!status.isOk()) return status;
  (void)texts.text();
  AnswersDecoder decoder(texts.text());
  decoder.get(answer);
  return decoder.complete() ? Status::ok() : damaged("is damaged");
}

Status AnswersReader::read(std::vector<MotionRevision>& revisions) {
  Status status = readPayload(end_);
  if (!status.isOk()) return status;
  AnswersDecoder texts(payload_);
  AnswersDecoder decoder(texts.text());
  decoder.get(revisions);
  return decoder.complete() && texts.complete() ? Status::ok() : damaged("is damaged");
}

}  // namespace tolman::answers_file
