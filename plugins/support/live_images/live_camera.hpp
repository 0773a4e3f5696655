// SPDX-License-Identifier: BSD-3-Clause
// The cameras of a run as live topics: received images, the measurements beside them, and the
// reason if no images come.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "image_sets.hpp"
#include "live_parameters.hpp"
#include "live_topics.hpp"
#include "messages.hpp"
#include "side_measurements.hpp"
#include "tolman/context.hpp"
#include "transport.hpp"

namespace tolman::live_images {

/// A topic of images, and its CameraInfo.
struct LiveStream {
  std::string topic;
  std::string type;                 ///< in the notation of ROS 2
  std::vector<std::uint8_t> first;  ///< the first image, which next() also returns
  std::string info_topic;           ///< empty if there is none
  std::vector<std::uint8_t> info;   ///< the last CameraInfo
};

class LiveCamera {
 public:
  /// Waits for the topics, and then for the first image of each camera and its CameraInfo.
  static Result<std::unique_ptr<LiveCamera>> open(std::unique_ptr<Transport> transport,
                                                  const LiveParameters& parameters,
                                                  const Context& context);

  /// The left camera, then the right one and that of depth, where there are.
  const std::vector<LiveStream>& streams() const { return streams_; }
  const LiveTopics& topics() const { return topics_; }
  const Transport& transport() const { return *transport_; }
  ros_messages::Message message(const std::vector<std::uint8_t>& bytes) const {
    return {bytes, transport_->encoding()};
  }

  /// Waits for the next set of images, and a moment for the measurements up to its time.
  /// EndOfStream: none came within the time `wait`; silence() has the reason. Cancelled: the run is
  /// to end.
  Status next(ImageSet& set);
  /// The reason why no images come.
  Status silence() const;
  /// Number of images that came without those of the other cameras.
  std::size_t leftOut() const { return sets_.leftOut(); }
  /// Number of images that were lost on the way.
  std::size_t lost() const;
  ros_messages::SideMeasurements& measurements() { return measurements_; }

 private:
  LiveCamera(std::unique_ptr<Transport> transport, const LiveParameters& parameters,
             const Context& context)
      : parameters_(parameters),
        clock_(context.clock),
        cancellation_(context.cancellation),
        findings_(context.findings),
        transport_(std::move(transport)) {}
  Status findTopics();
  Status subscribe();
  Status subscribeMeasurements();
  Status waitForFirst();
  /// The topic of which nothing has come yet; empty if there is none.
  std::string missing() const;
  Status waitForMeasurements(std::int64_t stamp_ns);
  /// Hands out messages that come within a moment.
  Status pause();
  std::int64_t deadline() const;

  /// A topic of measurements, and the time of its last message.
  struct Sensor {
    std::int64_t last_ns = 0;
    bool is_late = false;  ///< it was waited for in vain, and nothing has come since then
  };

  LiveParameters parameters_;
  const Clock& clock_;
  const Cancellation& cancellation_;
  FindingCollector& findings_;
  LiveTopics topics_;
  std::vector<LiveStream> streams_;
  ImageSets sets_;
  ros_messages::SideMeasurements measurements_;
  std::map<std::string, Sensor> sensors_;
  std::unique_ptr<Transport> transport_;  ///< destroyed first: it calls into the others
};

}  // namespace tolman::live_images
