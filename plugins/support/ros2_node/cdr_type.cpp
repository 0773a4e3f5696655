// SPDX-License-Identifier: BSD-3-Clause
#include "cdr_type.hpp"

#include <dds/dds.h>
#include <dds/ddsi/q_radmin.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

namespace tolman::ros2_node {
namespace {

struct CdrSample : ddsi_serdata {
  CdrSample(const ddsi_sertype* of, ddsi_serdata_kind contents, std::size_t bytes)
      : ddsi_serdata{}, size(bytes), padded((bytes + 3) / 4 * 4) {
    ddsi_serdata_init(this, of, contents);
    hash = of->serdata_basehash;  // no key: all samples of a topic are of one instance
  }

  std::size_t size;
  std::vector<std::uint8_t> padded;  ///< to a multiple of four, which may be asked for
};

const CdrSample& sampleOf(const ddsi_serdata* sample) {
  return *static_cast<const CdrSample*>(sample);
}

ddsi_serdata* fromFragments(const ddsi_sertype* type, ddsi_serdata_kind kind,
                            const nn_rdata* fragment, std::size_t size) {
  auto sample = std::make_unique<CdrSample>(type, kind, size);
  for (std::uint32_t done = 0; fragment != nullptr; fragment = fragment->nextfrag) {
    if (fragment->maxp1 <= done) continue;
    const unsigned char* payload =
        NN_RMSG_PAYLOADOFF(fragment->rmsg, NN_RDATA_PAYLOAD_OFF(fragment));
    std::copy_n(payload + (done - fragment->min), fragment->maxp1 - done,
                sample->padded.data() + done);
    done = fragment->maxp1;
  }
  return sample.release();
}

ddsi_serdata* fromBuffers(const ddsi_sertype* type, ddsi_serdata_kind kind,
                          ddsrt_msg_iovlen_t count, const ddsrt_iovec_t* buffers,
                          std::size_t size) {
  auto sample = std::make_unique<CdrSample>(type, kind, size);
  std::size_t done = 0;
  for (ddsrt_msg_iovlen_t i = 0; i < count && done < size; ++i) {
    const std::size_t bytes = std::min<std::size_t>(buffers[i].iov_len, size - done);
    std::memcpy(sample->padded.data() + done, buffers[i].iov_base, bytes);
    done += bytes;
  }
  return sample.release();
}

ddsi_serdata* toSerRef(const ddsi_serdata* sample, std::size_t offset, std::size_t size,
                       ddsrt_iovec_t* buffer) {
  buffer->iov_base = const_cast<std::uint8_t*>(sampleOf(sample).padded.data() + offset);
  buffer->iov_len = size;
  return ddsi_serdata_ref(sample);
}

ddsi_serdata* toUntyped(const ddsi_serdata* sample) {
  auto key = std::make_unique<CdrSample>(sample->type, SDK_KEY, 0);
  key->type = nullptr;
  return key.release();
}

/// Samples are written and taken as bytes alone, so no operation makes structures of them.
ddsi_serdata_ops dataOperations() {
  ddsi_serdata_ops ops{};
  ops.eqkey = [](const ddsi_serdata*, const ddsi_serdata*) { return true; };
  ops.get_size = [](const ddsi_serdata* sample) {
    return static_cast<std::uint32_t>(sampleOf(sample).size);
  };
  ops.from_ser = fromFragments;
  ops.from_ser_iov = fromBuffers;
  ops.from_keyhash = [](const ddsi_sertype* type, const ddsi_keyhash*) -> ddsi_serdata* {
    return new CdrSample(type, SDK_KEY, 0);
  };
  ops.from_sample = [](const ddsi_sertype* type, ddsi_serdata_kind kind,
                       const void*) -> ddsi_serdata* { return new CdrSample(type, kind, 0); };
  ops.to_ser = [](const ddsi_serdata* sample, std::size_t offset, std::size_t size, void* to) {
    std::memcpy(to, sampleOf(sample).padded.data() + offset, size);
  };
  ops.to_ser_ref = toSerRef;
  ops.to_ser_unref = [](ddsi_serdata* sample, const ddsrt_iovec_t*) { ddsi_serdata_unref(sample); };
  ops.to_sample = [](const ddsi_serdata*, void*, void**, void*) { return false; };
  ops.to_untyped = toUntyped;
  ops.untyped_to_sample = [](const ddsi_sertype*, const ddsi_serdata*, void*, void**, void*) {
    return false;
  };
  ops.free = [](ddsi_serdata* sample) { delete static_cast<CdrSample*>(sample); };
  ops.print = [](const ddsi_sertype*, const ddsi_serdata*, char* text, std::size_t) {
    *text = '\0';
    return std::size_t{0};
  };
  ops.get_keyhash = [](const ddsi_serdata*, ddsi_keyhash* hash, bool) {
    std::memset(hash, 0, sizeof *hash);
  };
  return ops;
}

ddsi_sertype_ops typeOperations() {
  ddsi_sertype_ops ops{};
  ops.version = ddsi_sertype_v0;
  ops.free = [](ddsi_sertype* type) {
    ddsi_sertype_fini(type);
    delete type;
  };
  ops.zero_samples = [](const ddsi_sertype*, void*, std::size_t) {};
  ops.realloc_samples = [](void** all, const ddsi_sertype*, void*, std::size_t, std::size_t count) {
    std::fill_n(all, count, nullptr);
  };
  ops.free_samples = [](const ddsi_sertype*, void**, std::size_t, dds_free_op_t) {};
  ops.equal = [](const ddsi_sertype*, const ddsi_sertype*) { return true; };
  ops.hash = [](const ddsi_sertype*) { return std::uint32_t{0}; };
  return ops;
}

}  // namespace

ddsi_sertype* newCdrType(const std::string& name) {
  static const ddsi_serdata_ops data_operations = dataOperations();
  static const ddsi_sertype_ops type_operations = typeOperations();
  auto* type = new ddsi_sertype{};
  ddsi_sertype_init_flags(type, name.c_str(), &type_operations, &data_operations,
                          DDSI_SERTYPE_FLAG_TOPICKIND_NO_KEY);
  type->allowed_data_representation = DDS_DATA_REPRESENTATION_FLAG_XCDR1;
  return type;
}

ddsi_serdata* newCdrSample(const ddsi_sertype* type, std::span<const std::uint8_t> bytes) {
  auto sample = std::make_unique<CdrSample>(type, SDK_DATA, bytes.size());
  std::ranges::copy(bytes, sample->padded.begin());
  return sample.release();
}

std::span<const std::uint8_t> bytesOf(const ddsi_serdata* sample) {
  return {sampleOf(sample).padded.data(), sampleOf(sample).size};
}

}  // namespace tolman::ros2_node
