// SPDX-License-Identifier: BSD-3-Clause
#include "node.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "cdr_type.hpp"

namespace tolman::ros2_node {
namespace {

constexpr std::string_view kTopicPrefix = "rt";

struct QosDeleter {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};

std::unique_ptr<dds_qos_t, QosDeleter> qosOf(const Delivery& delivery) {
  std::unique_ptr<dds_qos_t, QosDeleter> qos(dds_create_qos());
  dds_qset_reliability(qos.get(),
                       delivery.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       DDS_MSECS(100));
  dds_qset_durability(qos.get(),
                      delivery.kept ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, delivery.depth);
  return qos;
}

/// "sensor_msgs::msg::dds_::Image_" of "sensor_msgs/msg/Image".
std::string ddsType(const std::string& type) {
  const std::size_t slash = type.rfind('/');
  std::string name = type.substr(0, type.find('/')) + "::msg::dds_::" + type.substr(slash + 1);
  return name + "_";
}

/// The other way round; empty if it is no message of ROS 2.
std::string rosType(std::string_view type) {
  constexpr std::string_view kMiddle = "::msg::dds_::";
  const std::size_t at = type.find(kMiddle);
  if (at == std::string_view::npos || !type.ends_with('_')) return "";
  const std::string_view name = type.substr(at + kMiddle.size());
  return std::string(type.substr(0, at)) + "/msg/" + std::string(name.substr(0, name.size() - 1));
}

bool isLoopback(const std::string& peer) {
  return peer == "localhost" || peer.starts_with("127.") || peer == "::1";
}

/// The peers of a list with commas between them. InvalidParameter for what is no address.
Result<std::vector<std::string>> peersOf(const std::string& list) {
  std::vector<std::string> peers;
  std::istringstream in(list);
  for (std::string peer; std::getline(in, peer, ',');) {
    std::erase(peer, ' ');
    if (peer.empty() || peer.find_first_of("<>&\"'") != std::string::npos) {
      return Status::invalidParameter("'" + peer + "' is no peer; write its address or name");
    }
    peers.push_back(peer);
  }
  return peers;
}

/// What Cyclone reads: its settings of the environment, and ours behind them.
std::string configurationOf(const std::vector<std::string>& peers) {
  const char* uri = std::getenv("CYCLONEDDS_URI");
  std::string text = uri == nullptr || *uri == '\0' ? "" : std::string(uri) + ",";
  text += "<CycloneDDS><Domain Id=\"any\"><SharedMemory><Enable>false</Enable></SharedMemory>";
  // Several images of full size may wait; the system gives what net.core.rmem_max permits.
  text += "<Internal><SocketReceiveBufferSize max=\"16MB\"/></Internal>";
  if (!peers.empty()) {
    text += "<General>";
    if (std::ranges::all_of(peers, isLoopback)) {
      text += "<Interfaces><NetworkInterface address=\"127.0.0.1\"/></Interfaces>";
    }
    text += "<AllowMulticast>false</AllowMulticast></General><Discovery>";
    text += "<ParticipantIndex>auto</ParticipantIndex>";
    text += "<MaxAutoParticipantIndex>60</MaxAutoParticipantIndex><Peers>";
    for (const std::string& peer : peers) text += "<Peer address=\"" + peer + "\"/>";
    text += "</Peers></Discovery>";
  }
  return text + "</Domain></CycloneDDS>";
}

Result<int> domainOf(int given) {
  if (given >= 0) return given;
  const char* set = std::getenv("ROS_DOMAIN_ID");
  const std::string_view text = set == nullptr ? "" : set;
  if (text.empty()) return 0;
  int domain = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), domain);
  if (failure == std::errc() && end == text.data() + text.size() && domain >= 0 && domain <= 230) {
    return domain;
  }
  return Status::invalidParameter("ROS_DOMAIN_ID is '" + std::string(text) +
                                  "', and no domain from 0 to 230; correct it, or set domain");
}

Status failure(const std::string& what, dds_return_t code) {
  return Status::failed(what + " failed: " + dds_strretcode(code));
}

std::vector<dds_entity_t> participantsOf(int domain) {
  std::array<dds_entity_t, 64> all{};
  const auto id = static_cast<dds_domainid_t>(domain);
  const dds_return_t count = dds_lookup_participant(id, all.data(), all.size());
  return {all.begin(), all.begin() + std::clamp<dds_return_t>(count, 0, all.size())};
}

/// Participants of one process share a domain and its configuration; the last of them ends it.
Result<dds_entity_t> makeParticipant(int domain, const std::vector<std::string>& peers) {
  const auto id = static_cast<dds_domainid_t>(domain);
  const dds_entity_t made = dds_create_domain(id, configurationOf(peers).c_str());
  if (made < 0 && made != DDS_RETCODE_PRECONDITION_NOT_MET) {
    return Status::failed(
        "DDS has no network to work with (the lines before this one say why); connect one, or set "
        "peers: localhost");
  }
  const dds_entity_t participant = dds_create_participant(id, nullptr, nullptr);
  if (participant < 0) {
    if (made > 0) dds_delete(made);
    return failure("joining domain " + std::to_string(domain), participant);
  }
  return participant;
}

}  // namespace

void Reader::take(const std::function<void(Bytes)>& handle) const {
  constexpr std::uint32_t kAtOnce = 16;
  std::array<ddsi_serdata*, kAtOnce> samples{};
  std::array<dds_sample_info_t, kAtOnce> infos{};
  dds_return_t count = 0;
  do {
    count = dds_takecdr(reader_, samples.data(), kAtOnce, infos.data(), DDS_ANY_STATE);
    for (dds_return_t i = 0; i < count; ++i) {
      ddsi_serdata* sample = samples[static_cast<std::size_t>(i)];
      if (infos[static_cast<std::size_t>(i)].valid_data) handle(bytesOf(sample));
      ddsi_serdata_unref(sample);
    }
  } while (count == static_cast<dds_return_t>(kAtOnce));
}

std::size_t Reader::publishers() const {
  dds_subscription_matched_status_t status{};
  dds_get_subscription_matched_status(reader_, &status);
  return status.current_count;
}

bool Reader::hasUnfit() const {
  dds_requested_incompatible_qos_status_t status{};
  dds_get_requested_incompatible_qos_status(reader_, &status);
  return status.total_count > 0;
}

std::size_t Reader::lost() const {
  dds_sample_lost_status_t status{};
  dds_get_sample_lost_status(reader_, &status);
  return status.total_count;
}

Status Writer::write(Bytes message) const {
  const dds_return_t code = dds_writecdr(writer_, newCdrSample(type_, message));
  return code == DDS_RETCODE_OK ? Status::ok() : failure("publishing", code);
}

Result<std::unique_ptr<Node>> Node::start(const Ros2Network& network) {
  const auto peers = peersOf(network.peers);
  if (!peers.isOk()) return peers.status();
  const Result<int> domain = domainOf(network.domain);
  if (!domain.isOk()) return domain.status();
  const auto participant = makeParticipant(domain.value(), peers.value());
  if (!participant.isOk()) return participant.status();
  return std::unique_ptr<Node>(new Node(domain.value(), participant.value()));
}

Node::Node(int domain, dds_entity_t participant)
    : domain_(domain),
      participant_(participant),
      publications_(
          dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr)),
      waitset_(dds_create_waitset(participant)) {}

Node::~Node() {
  const dds_entity_t of_domain = dds_get_parent(participant_);
  dds_delete(participant_);
  if (participantsOf(domain_).empty()) dds_delete(of_domain);
}

std::map<std::string, Offer> Node::offers() const {
  std::vector<dds_guid_t> own;
  for (const dds_entity_t participant : participantsOf(domain_)) {
    dds_get_guid(participant, &own.emplace_back());
  }
  constexpr std::uint32_t kMost = 4096;
  std::vector<void*> samples(kMost, nullptr);
  std::vector<dds_sample_info_t> infos(kMost);
  const dds_return_t count =
      dds_read_mask(publications_, samples.data(), infos.data(), kMost, kMost,
                    DDS_ANY_SAMPLE_STATE | DDS_ANY_VIEW_STATE | DDS_ALIVE_INSTANCE_STATE);
  std::map<std::string, Offer> found;
  for (dds_return_t i = 0; i < count; ++i) {
    const auto& endpoint =
        *static_cast<const dds_builtintopic_endpoint_t*>(samples[static_cast<std::size_t>(i)]);
    const bool is_own = std::ranges::any_of(own, [&](const dds_guid_t& guid) {
      return std::ranges::equal(guid.v, endpoint.participant_key.v);
    });
    const std::string_view name = endpoint.topic_name;
    const std::string type = rosType(endpoint.type_name);
    if (is_own || !name.starts_with(kTopicPrefix) || type.empty()) continue;
    dds_reliability_kind_t reliability{};
    dds_durability_kind_t durability{};
    dds_qget_reliability(endpoint.qos, &reliability, nullptr);
    dds_qget_durability(endpoint.qos, &durability);
    Offer& offer = found[std::string(name.substr(kTopicPrefix.size()))];
    offer.type = type;
    offer.reliable = offer.reliable && reliability == DDS_RELIABILITY_RELIABLE;
    offer.kept = offer.kept && durability != DDS_DURABILITY_VOLATILE;
  }
  if (count > 0) dds_return_loan(publications_, samples.data(), count);
  return found;
}

Result<std::pair<dds_entity_t, const ddsi_sertype*>> Node::topic(const std::string& name,
                                                                 const std::string& type) {
  ddsi_sertype* made = newCdrType(ddsType(type));
  const std::string full = std::string(kTopicPrefix) + name;
  const dds_entity_t topic =
      dds_create_topic_sertype(participant_, full.c_str(), &made, nullptr, nullptr, nullptr);
  if (topic >= 0) return std::pair<dds_entity_t, const ddsi_sertype*>(topic, made);
  ddsi_sertype_unref(made);
  return failure("topic " + name, topic);
}

Result<Reader> Node::subscribe(const std::string& name, const std::string& type,
                               Delivery delivery) {
  const auto of = topic(name, type);
  if (!of.isOk()) return of.status();
  const dds_entity_t reader =
      dds_create_reader(participant_, of.value().first, qosOf(delivery).get(), nullptr);
  if (reader < 0) return failure("subscribing to " + name, reader);
  dds_set_status_mask(reader, DDS_DATA_AVAILABLE_STATUS);
  dds_waitset_attach(waitset_, reader, reader);
  return Reader(reader);
}

Result<Writer> Node::advertise(const std::string& name, const std::string& type,
                               Delivery delivery) {
  const auto of = topic(name, type);
  if (!of.isOk()) return of.status();
  const dds_entity_t writer =
      dds_create_writer(participant_, of.value().first, qosOf(delivery).get(), nullptr);
  if (writer < 0) return failure("publishing " + name, writer);
  return Writer(writer, of.value().second);
}

void Node::wait(std::int64_t longest_ns) const {
  std::array<dds_attach_t, 16> triggered{};
  dds_waitset_wait(waitset_, triggered.data(), triggered.size(), longest_ns);
}

}  // namespace tolman::ros2_node
