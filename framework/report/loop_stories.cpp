// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <map>

#include "base/must.hpp"
#include "report/run_data.hpp"
#include "report/svg.hpp"

namespace tolman::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kJustDriven = evaluation::RevisitRule{}.path_m;
constexpr double kJustDrivenShare = 0.04;  // of the path, where its scale is unknown
constexpr std::int64_t kSameView = 20;     // frames: further candidates within tell the same story

constexpr double kNearShare = 0.01;  // hypotheses that stay below were never near

std::string number(double value) { return fmt::format("{:.3g}", value); }

/// Finds what belongs to a frame.
class Stories {
 public:
  explicit Stories(const LoopRecord& record)
      : record_(record), learned_(evaluation::framesOfTemplates(record.places)) {
    for (const PlaceObservation& place : record.places) places_[place.frame] = &place;
    const std::vector<double> driven = evaluation::distances(record.odometry);
    for (std::size_t i = 0; i < driven.size(); ++i) driven_[record.odometry[i].frame] = driven[i];
    just_driven_ =
        record.in_metres || driven.empty() ? kJustDriven : kJustDrivenShare * driven.back();
    for (const Decision& decision : record.decisions) {
      for (const PlaceHypothesis& change : decision.hypotheses) {
        follow(decision.frame, change);
      }
    }
  }

  /// What place recognition and cells recorded of a frame.
  LoopStory at(std::int64_t frame) const {
    LoopStory story;
    story.frame = frame;
    if (!record_.in_metres) story.unit = "units";
    if (const auto place = places_.find(frame); place != places_.end()) {
      story.recognition = place->second->recognition;
      story.has_pose = place->second->has_relative_pose;
      if (!place->second->candidates.empty()) story.candidate = place->second->candidates.front();
      const bool familiar = story.recognition == Recognition::Familiar;
      const std::int64_t id = familiar          ? place->second->template_id
                              : story.candidate ? story.candidate->template_id
                                                : -1;
      if (const auto made = learned_.find(id); made != learned_.end()) story.earlier = made->second;
    }
    if (story.candidate && story.recognition != Recognition::Familiar && !isJustDriven(story)) {
      story.ending = Ending::Unfamiliar;
    }
    if (const auto id = supported_.find(frame); id != supported_.end()) {
      story.hypothesis = lives_.at(id->second);
      story.ending = Ending::Undecided;
    }
    return story;
  }

  LoopStory of(const evaluation::JudgedLoop& link) const {
    LoopStory story = at(link.frame);
    story.link = link;
    story.earlier = link.earlier;
    story.ending = link.rejected ? Ending::Rejected : Ending::Kept;
    return story;
  }

  /// One of each hypothesis that was not accepted.
  void addUndecided(std::vector<LoopStory>& stories) const {
    for (const auto& [id, life] : lives_) {
      if (life.end.fate == Fate::Accepted || life.best.share < kNearShare) continue;
      stories.push_back(at(life.last_view_frame));
      stories.back().hypothesis = life;
      stories.back().ending = Ending::Undecided;
    }
  }

  /// Of candidates near each other only the one that is nearest to its limit.
  void addUnfamiliar(std::vector<LoopStory>& stories) const {
    std::vector<LoopStory> found;
    for (const PlaceObservation& place : record_.places) {
      if (place.recognition == Recognition::Familiar || place.candidates.empty()) continue;
      LoopStory story = at(place.frame);
      if (story.ending != Ending::Unfamiliar || !isNear(*story.candidate)) continue;
      if (found.empty() || story.frame - found.back().frame > kSameView) {
        found.push_back(std::move(story));
      } else if (story.candidate->score < found.back().candidate->score) {
        found.back() = std::move(story);
      }
    }
    std::ranges::move(found, std::back_inserter(stories));
  }

 private:
  void follow(std::int64_t frame, const PlaceHypothesis& change) {
    HypothesisLife& life = lives_[change.id];
    if (life.id < 0) {
      life.id = change.id;
      life.first_frame = frame;
      life.best = change;
    }
    const std::int64_t experience =
        change.experience >= 0 ? change.experience : life.end.experience;
    life.end = change;
    life.end.experience = experience;
    if (change.share >= life.best.share) life.best = life.end;
    if (change.fate >= Fate::Accepted) life.end_frame = frame;
    if (change.fate > Fate::Accepted) return;  // not by a view
    life.last_view_frame = frame;
    supported_.try_emplace(frame, change.id);
  }
  static bool isNear(const Candidate& candidate) {
    return candidate.compared >= 0 || candidate.score <= 1.5 * candidate.limit;
  }
  bool isJustDriven(const LoopStory& story) const {
    const auto here = driven_.find(story.frame);
    const auto there = driven_.find(story.earlier);
    if (here == driven_.end() || there == driven_.end()) return true;
    return here->second - there->second < just_driven_;
  }

  const LoopRecord& record_;
  std::map<std::int64_t, HypothesisLife> lives_;
  std::map<std::int64_t, std::int64_t> learned_;    ///< frame of each template
  std::map<std::int64_t, std::int64_t> supported_;  ///< hypothesis of each frame with a view of one
  std::map<std::int64_t, const PlaceObservation*> places_;
  std::map<std::int64_t, double> driven_;
  double just_driven_ = kJustDriven;
};

/// Smaller: nearer to being a loop.
double distanceOf(const LoopStory& story) {
  switch (story.ending) {
    case Ending::Kept:
    case Ending::Rejected:
      return story.link->residual;
    case Ending::Undecided:
      return -story.hypothesis->best.share;
    default:
      return story.candidate ? story.candidate->score : 0;
  }
}

std::string beginning(const LoopStory& story) {
  const std::string to = story.earlier < 0 ? "" : fmt::format(" to frame {}", story.earlier);
  switch (story.ending) {
    case Ending::Kept:
      return fmt::format("Frame {} closes a loop{}.", story.frame, to);
    case Ending::Rejected:
      return fmt::format("Frame {} closed a loop{}, which the map rejected.", story.frame, to);
    case Ending::Undecided:
      if (story.hypothesis->end.fate != Fate::Accepted) break;
      return fmt::format("Frame {} returned{}; a link so near the last one was not due.",
                         story.frame, to);
    case Ending::Nothing:
      return fmt::format("Frame {} closes no loop, and none was near.", story.frame);
    default:
      break;
  }
  return fmt::format("Frame {} was not closed{}.", story.frame, to);
}

std::string placeText(const LoopStory& story) {
  std::string text;
  if (story.recognition == Recognition::Familiar) {
    text = story.has_pose ? " Place recognition measured a pose there"
                          : " Place recognition found it familiar";
  } else if (story.recognition == Recognition::Novel) {
    text = " Place recognition stored the view as new";
  } else {
    text = " Place recognition gave no answer";
  }
  if (!story.candidate) return text + ".";
  const Candidate& best = *story.candidate;
  text += fmt::format(": its best candidate has a score of {} (at most {} is familiar)",
                      number(best.score), number(best.limit));
  if (best.compared >= 0) {
    text += fmt::format(", {} of {} landmarks agree (needs {})", best.agreeing, best.compared,
                        best.needed);
  }
  if (!best.reason.empty()) text += "; " + best.reason;
  return text + ".";
}

std::string viewsText(std::int64_t views) {
  return fmt::format("{} view{}", views, views == 1 ? "" : "s");
}

std::string hypothesisText(const LoopStory& story) {
  if (!story.hypothesis) return "";
  const HypothesisLife& life = *story.hypothesis;
  std::string text =
      fmt::format(" The cells' hypothesis reached a share of {:.3f} (needs {:.3g}) after {}",
                  life.best.share, life.best.limit, viewsText(life.best.views));
  switch (life.end.fate) {
    case Fate::Accepted:
      return text + fmt::format(" and was accepted at frame {}.", life.end_frame);
    case Fate::Faded:
      return text + fmt::format(" and died at frame {}, {:.3g} {} after its last view.",
                                life.end_frame, life.end.unsupported, story.unit);
    case Fate::Displaced:
      return text + fmt::format(" and gave way to a stronger one at frame {}.", life.end_frame);
    default:
      return text + " and waited for more until the run ended.";
  }
}

std::string linkText(const LoopStory& story) {
  if (!story.link) return "";
  const evaluation::JudgedLoop& link = *story.link;
  std::string text;
  if (link.residual >= 0) {
    text += fmt::format(" The finished map is {:.1f} standard deviations from the link{}.",
                        link.residual, link.rejected ? ", too far for its robust loss" : "");
  }
  if (!link.is_true) return text;
  text += *link.is_true ? " By the true poses it is right" : " By the true poses it is FALSE";
  if (link.error_m) {
    text += fmt::format(": its measured pose is {:.2f} m off, {:.1f} of its standard deviations",
                        *link.error_m, *link.error_sigmas);
  }
  if (link.apart_m) {
    text += fmt::format("{} its ends are {:.1f} m apart", link.error_m ? ";" : ":", *link.apart_m);
  }
  return text + ".";
}

template <Record R>
Json jsonOf(const R& record) {
  Json json;
  visitFields(record, [&](const Field& field, const auto& value) {
    if constexpr (std::is_enum_v<std::remove_cvref_t<decltype(value)>>) {
      json[std::string(field.name)] = enumName(value);
    } else {
      json[std::string(field.name)] = value;
    }
  });
  return json;
}

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

}  // namespace

std::string LoopStory::text() const {
  return beginning(*this) + placeText(*this) + hypothesisText(*this) + linkText(*this);
}

std::vector<std::string> storyHeadings() {
  return {"frame",         "to",    "ending",     "score (limit)", "landmarks (needed)",
          "share (limit)", "views", "residual σ", "true"};
}

std::vector<std::string> LoopStory::cells() const {
  const auto shown = [](bool known, std::string text) { return known ? text : std::string("–"); };
  const Candidate best = candidate.value_or(Candidate{});
  const HypothesisLife life = hypothesis.value_or(HypothesisLife{});
  const evaluation::JudgedLoop judged = link.value_or(evaluation::JudgedLoop{});
  std::string verdict = "–";
  if (judged.is_true) {
    verdict = *judged.is_true ? "yes" : "NO";
    if (judged.error_m) verdict += fmt::format(", {:.2f} m off", *judged.error_m);
  }
  return {
      std::to_string(frame),
      shown(earlier >= 0, std::to_string(earlier)),
      std::string(enumName(ending)),
      shown(candidate.has_value(), fmt::format("{} ({})", number(best.score), number(best.limit))),
      shown(best.compared >= 0, fmt::format("{} ({})", best.agreeing, best.needed)),
      shown(life.id >= 0, fmt::format("{:.3f} ({:.3g})", life.best.share, life.best.limit)),
      shown(life.id >= 0, std::to_string(life.best.views)),
      shown(judged.residual >= 0, fmt::format("{:.1f}", judged.residual)),
      verdict};
}

Json LoopStory::json() const {
  Json json = {{"frame", frame},
               {"earlier", earlier},
               {"ending", enumName(ending)},
               {"recognition", enumName(recognition)},
               {"text", text()}};
  if (candidate) json["candidate"] = jsonOf(*candidate);
  if (hypothesis) {
    Json& life = json["hypothesis"] = jsonOf(hypothesis->best);
    life["fate"] = enumName(hypothesis->end.fate);
    life["unsupported"] = hypothesis->end.unsupported;
    life["first_frame"] = hypothesis->first_frame;
    life["last_view_frame"] = hypothesis->last_view_frame;
    life["end_frame"] = hypothesis->end_frame;
  }
  if (link) {
    json["link"] = {{"id", link->link},
                    {"rejected", link->rejected},
                    {"residual", link->residual},
                    {"true", link->is_true ? Json(*link->is_true) : Json()},
                    {"apart_m", orNull(link->apart_m)},
                    {"error_m", orNull(link->error_m)},
                    {"error_sigmas", orNull(link->error_sigmas)}};
  }
  return json;
}

LoopRecord readLoops(const record::RunReader& reader, const evaluation::Trajectory& truth,
                     double storey_height) {
  LoopRecord record{must(reader.records<PlaceObservation>()),
                    must(reader.records<Decision>()),
                    {},
                    must(reader.odometry()),
                    must(reader.scaleKnown())};
  record.loops = evaluation::judgeLoops(must(reader.graph()), record.places, truth, storey_height);
  return record;
}

std::vector<LoopStory> storiesOf(const LoopRecord& record) {
  const Stories stories(record);
  std::vector<LoopStory> all;
  for (const evaluation::JudgedLoop& loop : record.loops) all.push_back(stories.of(loop));
  stories.addUndecided(all);
  stories.addUnfamiliar(all);
  std::ranges::stable_sort(
      all, {}, [](const LoopStory& story) { return std::pair(story.ending, distanceOf(story)); });
  return all;
}

std::optional<LoopStory> storyOf(const LoopRecord& record, std::int64_t frame) {
  const auto sees = [&](const PlaceObservation& place) { return place.frame == frame; };
  if (std::ranges::none_of(record.places, sees)) return std::nullopt;
  const Stories stories(record);
  for (const evaluation::JudgedLoop& loop : record.loops) {
    if (loop.frame == frame) return stories.of(loop);
  }
  return stories.at(frame);
}

std::string pairFigure(const LoopStory& story, const Image& earlier, const Image& now) {
  constexpr double kWidth = 480;  // px of each view
  constexpr double kTitle = 20;
  if (earlier.empty() || now.empty()) return "";
  double height = 0;
  for (const Image* view : {&earlier, &now}) {
    height = std::max(height, kWidth * view->height() / view->width());
  }
  Svg svg(2 * kWidth + 10, height + kTitle);
  double left = 0;
  for (const auto& [frame, view] : {std::pair(story.earlier, &earlier), {story.frame, &now}}) {
    Pixels pixels(view->height(), view->width());
    const int channels = bytesPerPixel(view->format());
    for (int r = 0; r < view->height(); ++r) {
      for (int c = 0; c < view->width(); ++c) {
        const std::uint8_t* p = view->row(r) + channels * c;  // blue, green, red, or grey
        const std::uint32_t blue = p[0];
        const std::uint32_t green = channels == 3 ? p[1] : p[0];
        const std::uint32_t red = channels == 3 ? p[2] : p[0];
        pixels(r, c) = 0xff000000U | red << 16U | green << 8U | blue;
      }
    }
    svg.text({left, kTitle - 6}, fmt::format("frame {}", frame));
    svg.image({left, kTitle}, {kWidth, kWidth * view->height() / view->width()}, pngUrl(pixels));
    left += kWidth + 10;
  }
  return svg.take();
}

}  // namespace tolman::report
