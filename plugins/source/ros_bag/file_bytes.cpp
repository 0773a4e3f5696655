// SPDX-License-Identifier: BSD-3-Clause
#include "file_bytes.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <memory>
#include <system_error>

#include "base/text_file.hpp"

namespace tolman::ros_bag {

namespace fs = std::filesystem;

Result<FileBytes> FileBytes::open(const fs::path& path) {
  constexpr std::size_t kMaxInMemory = std::size_t{2} << 30U;
  std::error_code failure;
  FileBytes file;
  if (fs::is_regular_file(path, failure)) file.stream_.open(path, std::ios::binary);
  if (!file.stream_.is_open()) {
    return Status::invalidInput(path.string() + ": not a readable file; check the path");
  }
  file.size_ = fs::file_size(path, failure);
  if (failure) return Status::failed(path.string() + ": has no size; check the disk");
  std::array<std::uint8_t, 4> start{};
  if (!file.read(0, start) || !isZstd(start)) return file;
  const std::string remedy = "; unpack it: `zstd -d " + path.string() + "`";
  if (file.size_ > kMaxInMemory) {
    return Status::unsupported(path.string() + ": is too large to be unpacked in memory" + remedy);
  }
  std::vector<std::uint8_t> packed(static_cast<std::size_t>(file.size_));
  const bool read = file.read(0, packed);
  // Images are not compressed to less than a hundredth, so a larger file is not a bag.
  const std::size_t most = std::min(kMaxInMemory, 100 * packed.size() + (1U << 20U));
  auto unpacked = read ? unpackZstd(packed, most) : std::nullopt;
  if (!unpacked) {
    return Status::invalidInput(path.string() +
                                ": is compressed, and damaged or larger than 2 GiB" + remedy);
  }
  file.memory_ = std::move(*unpacked);
  file.size_ = file.memory_.size();
  file.in_memory_ = true;
  return file;
}

bool FileBytes::read(std::uint64_t at, std::span<std::uint8_t> bytes) {
  if (at > size_ || bytes.size() > size_ - at) return false;
  if (in_memory_) {
    std::copy_n(memory_.begin() + static_cast<std::ptrdiff_t>(at), bytes.size(), bytes.begin());
    return true;
  }
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(at));
  stream_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return static_cast<bool>(stream_);
}

namespace {

/// Allocates memory for the next piece, at most a fixed amount more than is used.
bool grow(std::vector<std::uint8_t>& out, std::size_t used, std::size_t most) {
  constexpr std::size_t kMin = 1U << 16U;
  if (used < out.size()) return true;
  if (out.size() >= most + 1) return false;
  out.resize(std::min(most + 1, std::max(kMin, 2 * out.size())));
  return true;
}

struct Zstd {
  void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
};
struct Bz2 {
  void operator()(bz_stream* stream) const { BZ2_bzDecompressEnd(stream); }
};
struct Lz4 {
  void operator()(LZ4F_dctx* stream) const { LZ4F_freeDecompressionContext(stream); }
};

}  // namespace

bool isZstd(Bytes packed) {
  return packed.size() >= 4 && packed[0] == 0x28 && packed[1] == 0xb5 && packed[2] == 0x2f &&
         packed[3] == 0xfd;
}

std::optional<std::vector<std::uint8_t>> unpackZstd(Bytes packed, std::size_t most) {
  const std::unique_ptr<ZSTD_DStream, Zstd> stream(ZSTD_createDStream());
  if (stream == nullptr) return std::nullopt;
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  std::vector<std::uint8_t> unpacked;
  std::size_t used = 0;
  std::size_t left = 1;  // bytes of the frame that are expected; 0 at its end
  while (left != 0 || in.pos < in.size) {
    if (!grow(unpacked, used, most)) return std::nullopt;
    ZSTD_outBuffer out{unpacked.data(), unpacked.size(), used};
    const std::size_t before = in.pos;
    left = ZSTD_decompressStream(stream.get(), &out, &in);
    if (ZSTD_isError(left) != 0) return std::nullopt;
    const bool stuck = in.pos == before && out.pos == used;
    used = out.pos;
    if (stuck && left != 0) return std::nullopt;  // the frame is not complete
  }
  if (used > most) return std::nullopt;
  unpacked.resize(used);
  return unpacked;
}

std::optional<std::vector<std::uint8_t>> unpackLz4(Bytes packed, std::size_t most) {
  LZ4F_dctx* created = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&created, LZ4F_VERSION)) != 0) {
    return std::nullopt;
  }
  const std::unique_ptr<LZ4F_dctx, Lz4> stream(created);
  std::vector<std::uint8_t> unpacked;
  std::size_t used = 0;
  std::size_t left = 1;
  while (left != 0 || !packed.empty()) {
    if (!grow(unpacked, used, most)) return std::nullopt;
    std::size_t written = unpacked.size() - used;
    std::size_t read = packed.size();
    left = LZ4F_decompress(stream.get(), unpacked.data() + used, &written, packed.data(), &read,
                           nullptr);
    if (LZ4F_isError(left) != 0) return std::nullopt;
    if (written == 0 && read == 0 && (left != 0 || !packed.empty())) return std::nullopt;
    used += written;
    packed = packed.subspan(read);
  }
  if (used > most) return std::nullopt;
  unpacked.resize(used);
  return unpacked;
}

std::optional<std::vector<std::uint8_t>> unpackBz2(Bytes packed, std::size_t most) {
  bz_stream stream{};
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) return std::nullopt;
  const std::unique_ptr<bz_stream, Bz2> owner(&stream);
  std::vector<std::uint8_t> unpacked;
  std::size_t used = 0;
  // The library takes both lengths as 32 bit; chunks are shorter (unpackChunk).
  if (packed.size() > most + most / 100 + 600) return std::nullopt;
  stream.next_in = const_cast<char*>(reinterpret_cast<const char*>(packed.data()));
  stream.avail_in = static_cast<unsigned>(packed.size());
  for (int state = BZ_OK; state != BZ_STREAM_END;) {
    if (!grow(unpacked, used, most)) return std::nullopt;
    const auto room = static_cast<unsigned>(unpacked.size() - used);
    const unsigned before = stream.avail_in;
    stream.next_out = reinterpret_cast<char*>(unpacked.data() + used);
    stream.avail_out = room;
    state = BZ2_bzDecompress(&stream);
    used += room - stream.avail_out;
    const bool stuck = stream.avail_out == room && stream.avail_in == before;
    if (state != BZ_STREAM_END && (state != BZ_OK || stuck)) return std::nullopt;
  }
  if (used > most || stream.avail_in > 0) return std::nullopt;
  unpacked.resize(used);
  return unpacked;
}

Result<ChunkedFile::Contents> ChunkedFile::readBytes(std::uint64_t at, std::uint64_t size,
                                                     std::uint64_t record) {
  if (at > file_.size() || size > file_.size() - at) {
    return Status::invalidInput("is cut off within the record" + atByte(record));
  }
  if (size > kMaxBytes) {
    return Status::invalidInput("has a record of more than 256 MiB" + atByte(record));
  }
  Contents bytes(static_cast<std::size_t>(size));
  if (file_.read(at, bytes)) return bytes;
  return Status::invalidInput("cannot be read" + atByte(at));
}

Result<const ChunkedFile::Contents*> ChunkedFile::chunkAt(std::uint64_t at) {
  const auto known = std::find_if(chunks_.begin(), chunks_.end(),
                                  [at](const auto& chunk) { return chunk.first == at; });
  if (known != chunks_.end()) return &known->second;
  Result<Contents> records = readChunk(at);
  if (!records.isOk()) return records.status();
  if (chunks_.size() == 2) chunks_.pop_front();  // the images of a pair may be in two chunks
  chunks_.emplace_back(at, std::move(records).value());
  return &chunks_.back().second;
}

Result<std::vector<std::uint8_t>> ChunkedFile::read(const MessagePlace& place) {
  if (place.chunk == 0) return readBytes(place.offset, place.size, place.offset);
  const Result<const Contents*> chunk = chunkAt(place.chunk);
  if (!chunk.isOk()) return chunk.status();
  const Bytes records = *chunk.value();
  if (place.offset > records.size() || place.size > records.size() - place.offset) {
    return Status::failed("has changed while it was read");
  }
  const Bytes message =
      records.subspan(static_cast<std::size_t>(place.offset), static_cast<std::size_t>(place.size));
  return std::vector<std::uint8_t>(message.begin(), message.end());
}

}  // namespace tolman::ros_bag
