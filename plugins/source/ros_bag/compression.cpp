// SPDX-License-Identifier: BSD-3-Clause
#include "compression.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>

namespace tolman::ros_bag {
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

}  // namespace tolman::ros_bag
