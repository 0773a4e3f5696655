// SPDX-License-Identifier: BSD-3-Clause
// Another participant of DDS than ours, in a process of its own: eProsima's Fast DDS and Fast CDR,
// on the loopback, with the types of ROS 2 by their published definitions.
//
//   fast_dds_peer publish DOMAIN LIST HERTZ best_effort|reliable exit|stay|again [now]
//     Publishes a message a line once all topics have a subscriber, with a pause where the stamp
//     changes. stay: the process goes on; again: it begins anew, with later stamps; now: stamps are
//     those of the clock, except of CameraInfo.
//   fast_dds_peer listen DOMAIN PREFIX OUT
//     Writes a line for each message that comes, until it is killed.
//
//     image TOPIC STAMP WIDTH HEIGHT ENCODING FILE    FILE has the bytes of the pixels
//     compressed TOPIC STAMP FORMAT FILE
//     camera TOPIC STAMP WIDTH HEIGHT MODEL COUNT D... K(9) R(9) P(12)
//     imu TOPIC STAMP angular(3) linear(3)
//     odometry TOPIC STAMP x y theta
#include <fastcdr/Cdr.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastcdr::Cdr;
using Message = std::vector<char>;

std::int64_t now() {
  return std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Samples are messages that Fast CDR has written, or that it will read.
class MessageType : public dds::TopicDataType {
 public:
  explicit MessageType(const std::string& ros) {
    const std::size_t slash = ros.rfind('/');
    setName((ros.substr(0, ros.find('/')) + "::msg::dds_::" + ros.substr(slash + 1) + "_").c_str());
    m_typeSize = 4096;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const Message& message = *static_cast<Message*>(data);
    payload->encapsulation = CDR_LE;
    payload->length = static_cast<std::uint32_t>(message.size());
    std::memcpy(payload->data, message.data(), message.size());
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    const auto* bytes = reinterpret_cast<const char*>(payload->data);
    static_cast<Message*>(data)->assign(bytes, bytes + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<Message*>(data)->size()); };
  }
  void* createData() override { return new Message; }
  void deleteData(void* data) override { delete static_cast<Message*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

// ---- messages by their definitions

template <std::size_t N>
void array(Cdr& cdr, const std::vector<double>& values, std::size_t from = 0) {
  for (std::size_t i = 0; i < N; ++i) cdr << values.at(from + i);
}

std::vector<double> numbers(std::istream& in) {
  return {std::istream_iterator<double>(in), std::istream_iterator<double>()};
}

std::vector<std::uint8_t> contents(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(file + " cannot be read");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

struct Line {
  std::string kind, topic, type;
  std::int64_t stamp_ns = 0;
  std::string rest;
  std::vector<std::uint8_t> data;  ///< of the file
};

void writeImage(Cdr& cdr, std::istream& in, const Line& line) {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::string encoding;
  in >> width >> height >> encoding;
  cdr << height << width << encoding << std::uint8_t{0}
      << static_cast<std::uint32_t>(line.data.size() / height) << line.data;
}

void writeCamera(Cdr& cdr, std::istream& in) {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::string model;
  std::size_t count = 0;
  in >> width >> height >> model >> count;
  const std::vector<double> values = numbers(in);
  cdr << height << width << model;
  cdr << std::vector<double>(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
  array<9>(cdr, values, count);
  array<9>(cdr, values, count + 9);
  array<12>(cdr, values, count + 18);
  for (int i = 0; i < 6; ++i) cdr << std::uint32_t{0};  // binning, region of interest
  cdr << false;
}

Message write(const Line& line, std::int64_t stamp_ns) {
  eprosima::fastcdr::FastBuffer buffer;
  Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  cdr << static_cast<std::int32_t>(stamp_ns / 1'000'000'000)
      << static_cast<std::uint32_t>(stamp_ns % 1'000'000'000) << std::string("camera");
  std::istringstream in(line.rest);
  if (line.kind == "image") writeImage(cdr, in, line);
  if (line.kind == "camera") writeCamera(cdr, in);
  if (line.kind == "compressed") {
    std::string format;
    in >> format;
    cdr << format << line.data;
  }
  const std::vector<double> none(36, 0.0);
  if (line.kind == "imu") {
    const std::vector<double> values = numbers(in);
    array<4>(cdr, {0, 0, 0, 1});
    array<9>(cdr, none);
    array<3>(cdr, values);
    array<9>(cdr, none);
    array<3>(cdr, values, 3);
    array<9>(cdr, none);
  }
  if (line.kind == "odometry") {
    const std::vector<double> values = numbers(in);
    cdr << std::string("base");
    array<3>(cdr, {values.at(0), values.at(1), 0});
    array<4>(cdr, {0, 0, std::sin(values.at(2) / 2), std::cos(values.at(2) / 2)});
    array<36>(cdr, none);
    array<6>(cdr, none);
    array<36>(cdr, none);
  }
  return {buffer.getBuffer(), buffer.getBuffer() + cdr.getSerializedDataLength()};
}

std::vector<Line> linesOf(const std::string& file) {
  const std::map<std::string, std::string> types = {
      {"image", "sensor_msgs/msg/Image"},
      {"compressed", "sensor_msgs/msg/CompressedImage"},
      {"camera", "sensor_msgs/msg/CameraInfo"},
      {"imu", "sensor_msgs/msg/Imu"},
      {"odometry", "nav_msgs/msg/Odometry"}};
  std::vector<Line> lines;
  std::ifstream in(file);
  for (std::string text; std::getline(in, text);) {
    std::istringstream words(text);
    Line line;
    words >> line.kind >> line.topic >> line.stamp_ns;
    std::getline(words, line.rest);
    line.type = types.at(line.kind);
    if (line.kind == "image" || line.kind == "compressed") {
      line.data = contents(line.rest.substr(line.rest.rfind(' ') + 1));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

// ---- the participant

class Peer {
 public:
  explicit Peer(int domain) {
    dds::DomainParticipantQos qos;
    auto loopback = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    loopback->interfaceWhiteList = {"127.0.0.1"};
    loopback->sendBufferSize = loopback->receiveBufferSize = 4 << 20;
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports.push_back(loopback);
    qos.name("fast_dds_peer");
    auto* factory = dds::DomainParticipantFactory::get_instance();
    participant_ = factory->create_participant(static_cast<std::uint32_t>(domain), qos);
    if (participant_ == nullptr) throw std::runtime_error("no participant");
  }
  dds::DataWriter* writer(const std::string& name, const std::string& type, bool reliable,
                          bool kept) {
    dds::DataWriterQos qos;
    qos.reliability().kind =
        reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
    qos.durability().kind =
        kept ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
    qos.history().depth = kept ? 1 : 10;
    qos.endpoint().history_memory_policy = rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
    qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
    if (publisher_ == nullptr) {
      publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    }
    return publisher_->create_datawriter(topic(name, type), qos);
  }
  void reader(const std::string& name, const std::string& type, bool kept,
              dds::DataReaderListener* listener) {
    dds::DataReaderQos qos;
    qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
    if (kept) qos.durability().kind = dds::TRANSIENT_LOCAL_DURABILITY_QOS;
    qos.history().depth = 200;
    qos.endpoint().history_memory_policy = rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
    if (subscriber_ == nullptr) {
      subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
    }
    subscriber_->create_datareader(topic(name, type), qos, listener);
  }
  void leave() {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }

 private:
  dds::Topic* topic(const std::string& name, const std::string& ros) {
    dds::TypeSupport type(new MessageType(ros));
    type.register_type(participant_);
    return participant_->create_topic("rt" + name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
  }

  dds::DomainParticipant* participant_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
};

bool isHeard(dds::DataWriter* writer) {
  dds::PublicationMatchedStatus status;
  writer->get_publication_matched_status(status);
  return status.current_count > 0;
}

struct Publication {
  int domain;
  std::string list;
  double hertz;
  bool reliable;
  std::string then;
  bool now;
};

void publish(const Publication& asked) {
  Peer peer(asked.domain);
  const std::vector<Line> lines = linesOf(asked.list);
  std::map<std::string, dds::DataWriter*> writers;
  for (const Line& line : lines) {
    const bool kept = line.kind == "camera";
    auto& writer = writers[line.topic];
    if (writer == nullptr) {
      writer = peer.writer(line.topic, line.type, asked.reliable || kept, kept);
    }
  }
  for (const auto& [topic, writer] : writers) {
    while (!isHeard(writer)) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // the other side knows it, too
  const std::chrono::nanoseconds period(std::llround(1e9 / asked.hertz));
  auto due = std::chrono::steady_clock::now();
  std::int64_t offset_ns = 0;
  do {
    std::int64_t last_ns = -1;
    std::int64_t stamp_ns = 0;
    for (const Line& line : lines) {
      if (line.kind == "camera" && offset_ns > 0) continue;
      if (line.kind != "camera" && line.stamp_ns != last_ns) {
        due += period;
        std::this_thread::sleep_until(due);
        last_ns = line.stamp_ns;
        stamp_ns = asked.now ? now() : line.stamp_ns + offset_ns;
      }
      Message message = write(line, line.kind == "camera" ? line.stamp_ns : stamp_ns);
      writers[line.topic]->write(&message);
    }
    offset_ns += last_ns - lines.front().stamp_ns + 100'000'000;
  } while (asked.then == "again");
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  while (asked.then == "stay") std::this_thread::sleep_for(std::chrono::seconds(1));
  peer.leave();
}

// ---- what Tolman publishes, a line a message

struct Stamp {
  std::int64_t ns = 0;
  std::string frame;

  explicit Stamp(Cdr& cdr) {
    std::int32_t seconds = 0;
    std::uint32_t nanoseconds = 0;
    cdr >> seconds >> nanoseconds >> frame;
    ns = seconds * std::int64_t{1'000'000'000} + nanoseconds;
  }
};

std::array<double, 7> pose(Cdr& cdr) {
  std::array<double, 7> values{};
  for (double& value : values) cdr >> value;
  return values;
}

std::uint32_t count(Cdr& cdr) {
  std::uint32_t elements = 0;
  cdr >> elements;
  return elements;
}

std::string odometryLine(Cdr& cdr) {
  const Stamp stamp(cdr);
  std::string child;
  cdr >> child;
  const auto at = pose(cdr);
  std::array<double, 36> covariance{};
  std::array<double, 6> twist{};
  for (double& value : covariance) cdr >> value;
  for (double& value : twist) cdr >> value;
  for (double& value : covariance) cdr >> value;
  std::ostringstream out;
  out.precision(17);
  out << stamp.frame << " " << child << " " << stamp.ns;
  for (const double value : at) out << " " << value;
  out << " speed " << twist[0];
  return out.str();
}

std::string pathLine(Cdr& cdr) {
  const Stamp stamp(cdr);
  const std::uint32_t poses = count(cdr);
  for (std::uint32_t i = 0; i < poses; ++i) {
    (void)Stamp(cdr);
    pose(cdr);
  }
  return stamp.frame + " " + std::to_string(poses);
}

std::string tfLine(Cdr& cdr) {
  std::string text;
  for (std::uint32_t left = count(cdr); left > 0; --left) {
    const Stamp stamp(cdr);
    std::string child;
    cdr >> child;
    const auto at = pose(cdr);
    text += stamp.frame + " " + child + " " + std::to_string(stamp.ns) + " " +
            std::to_string(at[0]) + " ";
  }
  return text;
}

std::string markersLine(Cdr& cdr) {
  std::string text;
  for (std::uint32_t left = count(cdr); left > 0; --left) {
    (void)Stamp(cdr);
    std::string name, words;
    std::int32_t number = 0;
    double ignored = 0;
    float colour = 0;
    bool flag = false;
    cdr >> name >> number >> number >> number;
    pose(cdr);
    for (int i = 0; i < 3; ++i) cdr >> ignored;
    for (int i = 0; i < 4; ++i) cdr >> colour;
    std::uint32_t nanoseconds = 0;
    cdr >> number >> nanoseconds >> flag;
    const std::uint32_t points = count(cdr);
    for (std::uint32_t i = 0; i < 3 * points; ++i) cdr >> ignored;
    for (std::uint32_t colours = 4 * count(cdr); colours > 0; --colours) cdr >> colour;
    cdr >> words;  // texture
    (void)Stamp(cdr);
    cdr >> words;  // format of the texture
    if (count(cdr) + count(cdr) > 0) throw std::runtime_error("a marker with a texture");
    cdr >> words >> words >> words;  // text, mesh and its file
    if (count(cdr) > 0) throw std::runtime_error("a marker with a mesh");
    cdr >> flag;
    text += name + ":" + std::to_string(points) + " ";
  }
  return text;
}

std::string diagnosticsLine(Cdr& cdr) {
  const Stamp stamp(cdr);
  std::ostringstream out;
  for (std::uint32_t left = count(cdr); left > 0; --left) {
    std::uint8_t level = 0;
    std::string name, message, hardware, key, value;
    cdr >> level >> name >> message >> hardware;
    out << int{level} << " " << name << ": " << message;
    for (std::uint32_t pairs = count(cdr); pairs > 0; --pairs) {
      cdr >> key >> value;
      out << " " << key << "=" << value;
    }
  }
  return out.str();
}

class Ear : public dds::DataReaderListener {
 public:
  Ear(std::ostream& out, std::string word, std::string (*line)(Cdr&))
      : out_(out), word_(std::move(word)), line_(line) {}

  void on_data_available(dds::DataReader* reader) override {
    Message message;
    dds::SampleInfo info;
    while (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      const std::int64_t arrived = now();
      eprosima::fastcdr::FastBuffer buffer(message.data(), message.size());
      Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
      std::string text;
      try {
        cdr.read_encapsulation();
        text = line_(cdr);
        const auto rest = message.size() - cdr.getSerializedDataLength();
        if (rest > 3) text = "BAD: " + std::to_string(rest) + " bytes are left";
      } catch (const std::exception& failure) {
        text = std::string("BAD: ") + failure.what();
      }
      static std::mutex one;
      const std::lock_guard lock(one);
      out_ << word_ << " " << text << " arrived " << arrived << std::endl;
    }
  }

 private:
  std::ostream& out_;
  std::string word_;
  std::string (*line_)(Cdr&);
};

void listen(int domain, const std::string& prefix, const std::string& file) {
  std::ofstream out(file);
  Peer peer(domain);
  Ear odometry(out, "odometry", odometryLine);
  Ear path(out, "path", pathLine);
  Ear tf(out, "tf", tfLine);
  Ear map(out, "map", markersLine);
  Ear diagnostics(out, "diagnostics", diagnosticsLine);
  peer.reader(prefix + "/odometry", "nav_msgs/msg/Odometry", false, &odometry);
  peer.reader(prefix + "/path", "nav_msgs/msg/Path", true, &path);
  peer.reader("/tf", "tf2_msgs/msg/TFMessage", false, &tf);
  peer.reader(prefix + "/map", "visualization_msgs/msg/MarkerArray", true, &map);
  peer.reader("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", false, &diagnostics);
  out << "ready" << std::endl;
  while (true) std::this_thread::sleep_for(std::chrono::seconds(1));
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    const int domain = std::stoi(words.at(1));
    if (words.at(0) == "listen") listen(domain, words.at(2), words.at(3));
    publish({domain, words.at(2), std::stod(words.at(3)), words.at(4) == "reliable", words.at(5),
             words.size() > 6});
  } catch (const std::exception& failure) {
    std::cerr << failure.what() << "\n";
    return 1;
  }
  return 0;
}
