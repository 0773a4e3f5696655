// SPDX-License-Identifier: BSD-3-Clause
#include "mp4_fragments.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>

namespace tolman::video {
namespace {

constexpr std::uint64_t kNumber = 4;  // bytes

constexpr std::array kOfFile = {boxType("ftyp"), boxType("styp"), boxType("moov"), boxType("moof"),
                                boxType("mdat"), boxType("free"), boxType("skip"), boxType("wide"),
                                boxType("uuid"), boxType("sidx"), boxType("ssix"), boxType("mfra"),
                                boxType("pdin"), boxType("prft"), boxType("emsg"), boxType("meta"),
                                boxType("meco"), boxType("udta"), boxType("pnot"), boxType("imda")};
constexpr std::array kOfFragment = {boxType("mfhd"), boxType("traf"), boxType("meta"),
                                    boxType("pssh"), boxType("uuid"), boxType("free"),
                                    boxType("skip")};
constexpr std::array kOfTrackFragment = {
    boxType("tfhd"), boxType("trun"), boxType("tfdt"), boxType("sbgp"), boxType("sgpd"),
    boxType("subs"), boxType("saiz"), boxType("saio"), boxType("senc"), boxType("meta"),
    boxType("uuid"), boxType("free"), boxType("skip")};

std::string unknownBox(const Box& box, std::span<const std::uint32_t> known) {
  if (std::find(known.begin(), known.end(), box.type) != known.end()) return {};
  return "is damaged: the box " + nameOf(box) + " is of no known type";
}

std::uint64_t bitsOf(std::uint64_t flags) {
  return static_cast<std::uint64_t>(std::popcount(flags));
}

class Fragments {
 public:
  Fragments(ContainerBytes& file, const DefaultSizes& tracks) : file_(file), tracks_(tracks) {}

  std::string check() {
    return visitBoxes(file_, 0, file_.size(), [this](const Box& box) {
      if (box.type == boxType("moof")) return checkFragment(box);
      return box.type == boxType("mdat") ? checkData(box) : unknownBox(box, kOfFile);
    });
  }

 private:
  std::string checkFragment(const Box& fragment) {
    in_fragment_ = true;
    return visitBoxes(file_, fragment.content, fragment.end, [this](const Box& box) {
      if (box.type == boxType("mfhd")) return checkOrder(box);
      return box.type == boxType("traf") ? checkTrack(box) : unknownBox(box, kOfFragment);
    });
  }

  /// Whether the fragments' numbers, of box `mfhd`, proceed evenly. Some writers give no numbers,
  /// and of a file that was separated from others every second one may be there.
  std::string checkOrder(const Box& head) {
    const auto number = static_cast<std::int64_t>(numberAt(head, 1));
    const std::int64_t step = number - last_;
    const std::int64_t before = std::exchange(last_, number);
    ++fragments_;
    if (fragments_ == 2) step_ = step;
    if (fragments_ == 1 || step == step_) return {};
    return "is damaged: fragment " + std::to_string(number) + " follows fragment " +
           std::to_string(before) + ", so that others are missing or not in order";
  }

  std::string checkTrack(const Box& track) {
    return visitBoxes(file_, track.content, track.end, [this](const Box& box) {
      if (box.type == boxType("tfhd")) return takeHead(box);
      return box.type == boxType("trun") ? takeRun(box) : unknownBox(box, kOfTrackFragment);
    });
  }

  /// Section 8.8.7: flags, track, and the values that the flags name.
  std::string takeHead(const Box& head) {
    constexpr std::uint64_t kSize = 0x10;
    constexpr std::uint64_t kLongNumber = 0x1;
    constexpr std::uint64_t kNumbersBefore = 0x2 | 0x8;
    const std::uint64_t flags = numberAt(head, 0);
    const std::uint64_t track = numberAt(head, 1);
    const auto known = tracks_.find(track);
    if (known == tracks_.end()) {
      return "is damaged: the box " + nameOf(head) + " is of track " + std::to_string(track) +
             ", which the header does not name";
    }
    const std::uint64_t before = 2 * bitsOf(flags & kLongNumber) + bitsOf(flags & kNumbersBefore);
    size_ = (flags & kSize) != 0 ? numberAt(head, 2 + before) : known->second;
    return {};
  }

  /// Section 8.8.8: flags, count, and for each picture the values that the flags name.
  std::string takeRun(const Box& run) {
    constexpr std::uint64_t kInHead = 0x1 | 0x4;
    constexpr std::uint64_t kOfPicture = 0x100 | 0x200 | 0x400 | 0x800;
    constexpr std::uint64_t kBeforeSize = 0x100;
    constexpr std::uint64_t kSize = 0x200;
    const std::uint64_t flags = numberAt(run, 0);
    const std::uint64_t count = numberAt(run, 1);
    const std::uint64_t head = 2 + bitsOf(flags & kInHead);
    const std::uint64_t numbers = bitsOf(flags & kOfPicture);
    if ((head + count * numbers) * kNumber != run.end - run.content) {
      return "is damaged: the number of pictures in the box " + nameOf(run) +
             " is not that of its size";
    }
    if ((flags & kSize) == 0) {
      expected_ += count * size_;
      return {};
    }
    const std::uint64_t first = head + bitsOf(flags & kBeforeSize);
    for (std::uint64_t i = 0; i < count; ++i) expected_ += numberAt(run, first + i * numbers);
    return {};
  }

  /// Whether the data are those of the pictures of the fragment before; data can be in several
  /// boxes.
  std::string checkData(const Box& data) {
    const std::uint64_t size = data.end - data.content;
    if (!in_fragment_) return {};
    if (size > expected_) {
      return "is damaged: " + std::to_string(size - expected_) + " bytes of the box " +
             nameOf(data) + " are of no picture";
    }
    expected_ -= size;
    return {};
  }

  /// Number `index` of four bytes of a box's content; 0 beyond its end.
  std::uint64_t numberAt(const Box& box, std::uint64_t index) const {
    if ((index + 1) * kNumber > box.end - box.content) return 0;
    return file_.number(box.content + index * kNumber, kNumber).value_or(0);
  }

  ContainerBytes& file_;
  const DefaultSizes& tracks_;
  bool in_fragment_ = false;    ///< behind the first box `moof`
  std::uint64_t size_ = 0;      ///< of pictures of the current track without their own
  std::uint64_t expected_ = 0;  ///< bytes of pictures whose data were not yet met
  std::int64_t fragments_ = 0;
  std::int64_t last_ = 0;  ///< number of a fragment
  std::int64_t step_ = 0;  ///< from each number to the next
};

}  // namespace

DefaultSizes tracksOf(ContainerBytes& file, const Box& movie) {
  DefaultSizes tracks;
  visitBoxes(file, movie.content, movie.end, [&](const Box& box) -> std::string {
    const auto head = box.type == boxType("trak") ? findBox(file, box, {"tkhd"}) : std::nullopt;
    if (!head) return {};
    const bool has_long_times = file.number(head->content, 1) == 1;
    tracks[file.number(head->content + (has_long_times ? 20 : 12), kNumber).value_or(0)] = 0;
    return {};
  });
  const auto extension = findBox(file, movie, {"mvex"});
  if (!extension) return tracks;
  visitBoxes(file, extension->content, extension->end, [&](const Box& box) -> std::string {
    if (box.type != boxType("trex")) return {};
    tracks[file.number(box.content + kNumber, kNumber).value_or(0)] =
        file.number(box.content + 4 * kNumber, kNumber).value_or(0);
    return {};
  });
  return tracks;
}

std::string defectOfFragments(ContainerBytes& file, const DefaultSizes& tracks) {
  return Fragments(file, tracks).check();
}

}  // namespace tolman::video
