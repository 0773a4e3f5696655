// SPDX-License-Identifier: BSD-3-Clause
#include "matroska_check.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <vector>

#include "matroska_elements.hpp"

extern "C" {
#include <libavutil/bswap.h>
}

namespace tolman::video {
namespace {

constexpr std::uint32_t kEbmlHeader = 0x1A45DFA3;
constexpr std::uint32_t kSegment = 0x18538067;
constexpr std::uint32_t kTracks = 0x1654AE6B;
constexpr std::uint32_t kTrack = 0xAE;
constexpr std::uint32_t kTrackNumber = 0xD7;
constexpr std::uint32_t kCluster = 0x1F43B675;
constexpr std::uint32_t kSimpleBlock = 0xA3;
constexpr std::uint32_t kBlockGroup = 0xA0;
constexpr std::uint32_t kBlock = 0xA1;
constexpr std::uint32_t kCues = 0x1C53BB6B;
constexpr std::uint32_t kCuePoint = 0xBB;
constexpr std::uint32_t kCueTrackPositions = 0xB7;
constexpr std::uint32_t kCueClusterPosition = 0xF1;
constexpr std::uint32_t kCheckSum = 0xBF;
constexpr std::uint32_t kVoid = 0xEC;

// Of the segment: head of places, information, attachments, chapters, tags.
constexpr std::array<std::uint32_t, 10> kOfSegment = {
    kTracks,    kCluster,   kCues,      kCheckSum,  kVoid,
    0x114D9B74, 0x1549A966, 0x1941A469, 0x1043A770, 0x1254C367};
// Of a cluster: time, silent tracks, its place, size of the one before, encrypted block.
constexpr std::array<std::uint32_t, 9> kOfCluster = {
    kSimpleBlock, kBlockGroup, kCheckSum, kVoid, 0xE7, 0x5854, 0xA7, 0xAB, 0xAF};
// Of a group: additions, duration, priority, references, state, padding, slices.
constexpr std::array<std::uint32_t, 13> kOfGroup = {
    kBlock, kCheckSum, kVoid, 0xA2, 0x75A1, 0x9B, 0xFA, 0xFB, 0xFD, 0xA4, 0x75A2, 0x8E, 0xC8};

bool isOneOf(std::uint32_t id, std::span<const std::uint32_t> known) {
  return std::find(known.begin(), known.end(), id) != known.end();
}

std::string atByte(const Element& element) { return " at byte " + std::to_string(element.begin); }

class Matroska {
 public:
  explicit Matroska(ContainerBytes& file) : file_(file) {}

  std::string check() {
    return visitElements(file_, 0, file_.size(),
                         [this](const Element& element, std::string& defect) {
                           const bool is_known = element.id == kEbmlHeader || element.id == kVoid;
                           if (element.id == kSegment) {
                             defect = checkSegment(element);
                           } else if (!is_known) {
                             defect = unknown(element);
                           }
                           return Next::Continue;
                         });
  }

 private:
  std::string checkSegment(const Element& segment) {
    tracks_.clear();
    clusters_.clear();
    cued_.clear();
    in_endless_cluster_ = false;
    std::string defect = visitElements(file_, segment.content, segment.end,
                                       [this](const Element& element, std::string& found) {
                                         return visitOfSegment(element, found);
                                       });
    if (!defect.empty()) return defect;
    for (const std::uint64_t place : cued_) {
      const std::uint64_t cluster = segment.content + place;
      if (!std::binary_search(clusters_.begin(), clusters_.end(), cluster)) {
        return "is damaged: its index names a cluster at byte " + std::to_string(cluster) +
               ", where none is";
      }
    }
    return {};
  }

  Next visitOfSegment(const Element& element, std::string& defect) {
    if (in_endless_cluster_ && isOneOf(element.id, kOfCluster)) {
      defect = checkOfCluster(element);
      return Next::Continue;
    }
    if (!isOneOf(element.id, kOfSegment)) {
      defect = unknown(element);
      return Next::Continue;
    }
    in_endless_cluster_ = element.id == kCluster && element.endless;
    if (element.id == kCluster) clusters_.push_back(element.begin);
    if (in_endless_cluster_) return Next::Enter;
    if (element.id == kCluster || element.id == kTracks || element.id == kCues) {
      defect = checkContent(element);
    }
    return Next::Continue;
  }

  /// Of a cluster, the tracks or the index.
  std::string checkContent(const Element& parent) {
    return visitElements(file_, parent.content, parent.end,
                         [&](const Element& element, std::string& defect) {
                           if (element.id == kCheckSum) {
                             defect = checkSum(element, parent);
                           } else if (parent.id == kCluster) {
                             defect = checkOfCluster(element);
                           } else {
                             take(element, 0);
                           }
                           return Next::Continue;
                         });
  }

  std::string checkSum(const Element& element, const Element& parent) {
    const std::uint64_t stored = numberOf(file_, element);  // read as big-endian, but it is not
    const auto sum = file_.checkSum(element.end, parent.end);
    const bool is_whole = element.end - element.content == sizeof(std::uint32_t) && sum;
    if (is_whole && stored == av_bswap32(*sum)) return {};
    return "is damaged: the check sum" + atByte(element) + " does not match";
  }

  std::string checkOfCluster(const Element& element) {
    if (element.id == kSimpleBlock) return checkTrack(element);
    if (element.id != kBlockGroup) return isOneOf(element.id, kOfCluster) ? "" : unknown(element);
    return visitElements(file_, element.content, element.end,
                         [this](const Element& part, std::string& defect) {
                           if (part.id == kBlock) {
                             defect = checkTrack(part);
                           } else if (!isOneOf(part.id, kOfGroup)) {
                             defect = unknown(part);
                           }
                           return Next::Continue;
                         });
  }

  std::string checkTrack(const Element& block) {
    const std::uint64_t track = variableNumber(file_, block.content).value;
    if (std::find(tracks_.begin(), tracks_.end(), track) != tracks_.end()) return {};
    return "is damaged: the block" + atByte(block) + " is of track " + std::to_string(track) +
           ", which the header does not name";
  }

  /// Numbers of tracks and places of clusters, which are up to three elements deep.
  void take(const Element& element, int depth) {
    if (element.id == kTrackNumber) tracks_.push_back(numberOf(file_, element));
    if (element.id == kCueClusterPosition) cued_.push_back(numberOf(file_, element));
    if (depth > 2 || !isOneOf(element.id, std::array{kTrack, kCuePoint, kCueTrackPositions})) {
      return;
    }
    visitElements(file_, element.content, element.end, [&](const Element& inner, std::string&) {
      take(inner, depth + 1);
      return Next::Continue;
    });
  }

  static std::string unknown(const Element& element) {
    return "is damaged: the element" + atByte(element) + " is of no known kind";
  }

  ContainerBytes& file_;
  std::vector<std::uint64_t> tracks_;
  std::vector<std::uint64_t> clusters_;  ///< where they begin
  std::vector<std::uint64_t> cued_;      ///< clusters that the index names, from the segment on
  bool in_endless_cluster_ = false;
};

}  // namespace

std::string defectOfMatroska(ContainerBytes& file) { return Matroska(file).check(); }

}  // namespace tolman::video
