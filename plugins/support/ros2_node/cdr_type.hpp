// SPDX-License-Identifier: BSD-3-Clause
// A type of DDS whose samples are the bytes of messages, as they are on the wire: CDR behind its
// header of four bytes. So one type serves all messages, and the readers of bags decode them.
#pragma once

#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>

#include <cstdint>
#include <span>
#include <string>

namespace tolman::ros2_node {

/// A type of this name in the notation of DDS: "sensor_msgs::msg::dds_::Image_". Its reference
/// belongs to the caller until a topic takes it.
ddsi_sertype* newCdrType(const std::string& name);

/// A sample of these bytes; the reference belongs to the caller.
ddsi_serdata* newCdrSample(const ddsi_sertype* type, std::span<const std::uint8_t> bytes);

/// The bytes of a sample of such a type; valid as long as the sample.
std::span<const std::uint8_t> bytesOf(const ddsi_serdata* sample);

}  // namespace tolman::ros2_node
