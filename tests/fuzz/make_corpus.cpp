// SPDX-License-Identifier: BSD-3-Clause
// Writes the binary files of the corpus: images, saved states, messages of isolated plugins, a
// library with a manifest, and databases.
//   fuzz_make_corpus tests/fuzz/corpus
#include <elf.h>

#include <fstream>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "base/codec.hpp"
#include "bayesian_attractor.hpp"
#include "experience_map.hpp"
#include "host/child_process.hpp"
#include "input.hpp"
#include "place_replay.hpp"
#include "seqslam.hpp"
#include "small_plugins.hpp"
#include "support/gray_images.hpp"
#include "support/street_scene.hpp"
#include "tolman/state_stream.hpp"
#include "view_sequences.hpp"
#include "view_templates.hpp"

using namespace tolman;

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, std::string_view bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  fuzz::require(stream.good(), "the corpus cannot be written");
}

void writeImages(const fs::path& folder) {
  cv::Mat grey(12, 20, CV_8U);
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.cols; ++x) {
      grey.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(9 * x + 5 * y);
    }
  }
  cv::Mat colour;
  cv::merge(std::vector<cv::Mat>{grey, 255 - grey, grey * 2}, colour);
  const auto encoded = [](const char* ending, const cv::Mat& image,
                          const std::vector<int>& options = {}) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(ending, image, bytes, options);
    return std::string(bytes.begin(), bytes.end());
  };
  cv::Mat deep;
  grey.convertTo(deep, CV_16U, 257);
  write(folder / "coded_image" / "png_grey", encoded(".png", grey));
  write(folder / "coded_image" / "png_colour", encoded(".png", colour));
  write(folder / "coded_image" / "png_deep", encoded(".png", deep));
  write(folder / "coded_image" / "png_bilevel",
        encoded(".png", grey, {cv::IMWRITE_PNG_BILEVEL, 1}));
  write(folder / "coded_image" / "jpeg_grey",
        encoded(".jpg", grey, {cv::IMWRITE_JPEG_QUALITY, 50}));
  write(folder / "coded_image" / "jpeg_colour",
        encoded(".jpg", colour, {cv::IMWRITE_JPEG_QUALITY, 50}));
  write(folder / "coded_image" / "jpeg_progressive",
        encoded(".jpg", colour, {cv::IMWRITE_JPEG_PROGRESSIVE, 1, cv::IMWRITE_JPEG_QUALITY, 50}));
  write(folder / "coded_image" / "jpeg_restarts",
        encoded(".jpg", grey, {cv::IMWRITE_JPEG_RST_INTERVAL, 2, cv::IMWRITE_JPEG_QUALITY, 50}));
}

/// What is below the envelope.
std::string payloadOf(const StateKeeper& keeper) {
  std::ostringstream stream;
  fuzz::require(keeper.save(stream).isOk(), "a state cannot be saved");
  return stream.str().substr(sizeof(detail::StateHeader));
}

void writeTemplates(const fs::path& folder) {
  fuzz::Small<view_templates::ViewTemplates> place(fuzz::smallTemplates(), test::streetRig());
  write(folder / "state_templates" / "empty", payloadOf(place.plugin));
  for (std::int64_t i = 0; i < 2; ++i) {
    const Eigen::Isometry3d pose(Eigen::Translation3d(0, 0, 6.0 * static_cast<double>(i)));
    PlaceObservation seen;
    fuzz::require(place.plugin.observe(test::streetFrame(i, pose), nullptr, seen).isOk(),
                  "no view");
  }
  write(folder / "state_templates" / "two", payloadOf(place.plugin));
}

void writeSequences(const fs::path& folder) {
  fuzz::Small<view_sequences::ViewSequences> place(fuzz::smallSequences(), test::streetRig());
  write(folder / "state_sequences" / "empty", payloadOf(place.plugin));
  for (std::int64_t i = 0; i < 8; ++i) {
    const Eigen::Isometry3d pose(Eigen::Translation3d(0, 0, static_cast<double>(i % 4)));
    const Motion motion = fuzz::straightMotion(i);
    PlaceObservation seen;
    fuzz::require(place.plugin.observe(test::streetFrame(i, pose), &motion, seen).isOk(),
                  "no view");
  }
  write(folder / "state_sequences" / "driven", payloadOf(place.plugin));
}

void writeSeqSlam(const fs::path& folder) {
  fuzz::Small<seqslam::SeqSlam> place(fuzz::smallSeqSlam());
  write(folder / "state_seqslam" / "empty", payloadOf(place.plugin));
  for (std::int64_t i = 0; i < 9; ++i) {
    RandomStream random(static_cast<std::uint64_t>(i % 5));
    Frame frame;
    frame.frame = i;
    frame.left = test::noise(16, 8, random);
    PlaceObservation seen;
    fuzz::require(place.plugin.observe(frame, nullptr, seen).isOk(), "no view");
  }
  write(folder / "state_seqslam" / "driven", payloadOf(place.plugin));
}

void writeReplay(const fs::path& folder) {
  fuzz::Small<place_replay::PlaceReplay> place(fuzz::smallReplay());
  write(folder / "state_replay" / "empty", payloadOf(place.plugin));
  for (std::int64_t i = 0; i < 24; ++i) {
    const Motion motion = fuzz::straightMotion(i);
    PlaceObservation seen;
    fuzz::require(place.plugin.observe(fuzz::loggedFrame(i), &motion, seen).isOk(), "no view");
  }
  write(folder / "state_replay" / "driven", payloadOf(place.plugin));
}

void writeCells(const fs::path& folder) {
  fuzz::Small<bayesian_attractor::BayesianAttractor> cells({});
  write(folder / "state_cells" / "empty", payloadOf(cells.plugin));
  for (std::int64_t i = 0; i < 40; ++i) {
    Motion motion = fuzz::straightMotion(i);
    motion.T_previous_current = fromPlanar({1, 0, 6.2831853 / 30});
    const bool old = i >= 30;
    const PlaceObservation view =
        i % 10 == 0
            ? fuzz::seenView(i, old ? Recognition::Familiar : Recognition::Novel, i / 10 % 3)
            : fuzz::seenView(i, Recognition::None, -1);
    Decision decision;
    fuzz::require(cells.plugin.step(motion, view, decision).isOk(), "no decision");
    if (i == 12) write(folder / "state_cells" / "begun", payloadOf(cells.plugin));
  }
  write(folder / "state_cells" / "loop", payloadOf(cells.plugin));
}

void writeMap(const fs::path& folder) {
  fuzz::Small<experience_map::ExperienceMap> map({});
  write(folder / "state_map" / "empty", payloadOf(map.plugin));
  for (std::int64_t i = 0; i < 4; ++i) {
    const Motion motion = fuzz::straightMotion(i);
    Decision decision;
    decision.frame = i;
    decision.stamp_ns = motion.stamp_ns;
    decision.action = i < 2 ? Action::CreateExperience : i == 3 ? Action::CloseLoop : Action::Stay;
    decision.experience = i < 2 ? i : i == 3 ? 0 : 1;
    MapUpdate update;
    fuzz::require(map.plugin.update(motion, decision, update).isOk(), "no update");
    if (i == 1) write(folder / "state_map" / "two", payloadOf(map.plugin));
  }
  write(folder / "state_map" / "loop", payloadOf(map.plugin));
}

template <class... T>
std::string encoded(const T&... values) {
  Encoder encoder;
  encoder.putAll(values...);
  return encoder.take();
}

/// As wire_answers reads it.
template <class... T>
void writeAnswer(const fs::path& folder, const char* name, int call, const T&... results) {
  const std::string message = encoded(Status::ok(), results...);
  std::string bytes(1, static_cast<char>(call));
  const std::uint64_t size = message.size();
  bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
  write(folder / "wire_answers" / name, bytes + message);
}

/// As wire_calls reads it.
template <class... T>
void writeCall(const fs::path& folder, const char* name, Role role, host::Call call,
               const T&... arguments) {
  std::string bytes(1, static_cast<char>(role));
  bytes += static_cast<char>(call);
  write(folder / "wire_calls" / name, bytes + encoded(arguments...));
}

Frame frameWithImage() {
  Frame frame = fuzz::loggedFrame(0);
  frame.left =
      Image::create(6, 4, PixelFormat::Gray8, [](std::uint8_t* p) { std::memset(p, 9, 24); });
  return frame;
}

Motion motionWithPoints() {
  Motion motion = fuzz::straightMotion(0);
  motion.points_frame = 0;
  motion.points = Eigen::Matrix<float, 4, 2>::Constant(2);
  motion.revisions = {{0, Eigen::Isometry3d::Identity(), Matrix6d::Identity()}};
  return motion;
}

MapGraph smallGraph() {
  MapGraph graph{1, {{0, 0, 0, Eigen::Isometry3d::Identity()}}, {}, {0}};
  graph.links.resize(1);
  graph.links[0].id = graph.links[0].from = graph.links[0].to = 0;
  graph.links[0].kind = LinkKind::Loop;
  return graph;
}

RunInfo smallRun() {
  RunInfo run{"run", "/runs/run", {"a drive", {6, 4, true, {5, 5, 3, 2}, 0.5}, 10, true}, {}};
  ArrayInfo ring;
  ring.name = "hd.activity";
  ring.axes = {{"heading", "rad", 0, 1, 3, {"a", "b", "c"}}};
  run.arrays = {ring};
  return run;
}

void writeAnswers(const fs::path& folder) {
  Decision decision;
  decision.frame = 0;
  MapUpdate update;
  update.frame = 0;
  const std::vector<NamedArray> arrays = {{"hd.activity", {3}, {1, 2, 3}}};
  Frame frame = frameWithImage();
  frame.left = {};
  writeAnswer(folder, "next", 0, frame);
  writeAnswer(folder, "next_image", 0, frameWithImage());
  writeAnswer(folder, "track", 1, motionWithPoints());
  writeAnswer(folder, "observe", 2, fuzz::seenView(0, Recognition::Novel, 0));
  writeAnswer(folder, "step", 3, decision);
  writeAnswer(folder, "update", 4, update);
  writeAnswer(folder, "graph", 5, smallGraph());
  writeAnswer(folder, "info", 6, smallRun().source);
  writeAnswer(folder, "revisions", 7, motionWithPoints().revisions);
  writeAnswer(folder, "finding", 8, Finding{Finding::Severity::Note, "file:1", "fine", "", {}});
  writeAnswer(folder, "arrays", 9, arrays);
  writeAnswer(folder, "describe", 10, smallRun().arrays);
  writeAnswer(folder, "save", 11, std::string("state"));
  ParameterInfo info;
  info.name = "rate";
  info.default_value = 2.5;
  ParameterInfo list = info;
  list.default_value = std::vector<double>{1, 2};
  writeAnswer(folder, "load", 12, host::Refusal{}, Schema{info, list});
  writeAnswer(folder, "create", 13, host::Refusal{"plugin/x", "message", "remedy"}, true, false);
}

void writeCalls(const fs::path& folder) {
  using host::Call;
  const Frame frame = frameWithImage();
  const Motion motion = motionWithPoints();
  const PlaceObservation view = fuzz::seenView(0, Recognition::Novel, 0);
  const std::vector<NamedArray> cells = {{"hd.activity", {3}, {1, 2, 3}}};
  const std::vector<RunEvent> events = {{0, LogLevel::Info, "place", "new"}};
  writeCall(folder, "next", Role::Source, Call::Next);
  writeCall(folder, "track", Role::Odometry, Call::Track, frame);
  writeCall(folder, "observe", Role::Place, Call::Observe, frame, std::optional(motion));
  writeCall(folder, "step", Role::Cells, Call::Step, motion, view);
  writeCall(folder, "update", Role::Map, Call::Update, motion, Decision());
  writeCall(folder, "pose", Role::Map, Call::PoseOf, std::int64_t{3});
  writeCall(folder, "finish_map", Role::Map, Call::FinishMap, motion.revisions);
  writeCall(folder, "restore", Role::Map, Call::Restore, std::string("state"));
  writeCall(folder, "begin", Role::Observer, Call::Begin, smallRun());
  writeCall(folder, "watch", Role::Observer, Call::Watch, frame, motion, view, Decision(),
            MapUpdate(), cells, std::optional(smallGraph()), StageTimes{}, events);
  writeCall(folder, "finish_observer", Role::Observer, Call::FinishObserver, smallGraph());
  const ParameterValues parameters = {{"rate", 2.5}, {"path", std::string("/data")}, {"on", true}};
  writeCall(folder, "configure", Role::Map, Call::Configure,
            host::ContextMessage{parameters, smallRun().source.rig, 1, "map"});
  writeCall(folder, "load", Role::Map, Call::Load,
            host::LoadMessage{"/plugins/map.so", "map", "", 100, 2});
}

/// A shared library that is nothing but a header, a manifest and their sections.
void writeLibrary(const fs::path& folder) {
  const std::string manifest =
      R"({"id":"toy","role":"odometry","version":"1.0","sdk":"0.2","fingerprint":"x","opencv":"",)"
      R"("schema":"1f","summary":"a toy","extras":"arrays,state"})";
  const std::string contents = manifest + '\0' + manifest + '\0';
  const std::string names(std::string_view("\0.names\0tolman_manifest\0", 24));
  Elf64_Ehdr header{};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_ident[EI_CLASS] = ELFCLASS64;
  header.e_ident[EI_DATA] = ELFDATA2LSB;
  header.e_type = ET_DYN;
  header.e_machine = EM_X86_64;
  header.e_shoff = sizeof header + contents.size() + names.size();
  header.e_shnum = 3;
  header.e_shstrndx = 1;
  Elf64_Shdr none{};
  Elf64_Shdr name_section{};
  name_section.sh_name = 1;
  name_section.sh_offset = sizeof header + contents.size();
  name_section.sh_size = names.size();
  Elf64_Shdr manifest_section{};
  manifest_section.sh_name = 8;
  manifest_section.sh_offset = sizeof header;
  manifest_section.sh_size = contents.size();
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  bytes += contents + names;
  for (const Elf64_Shdr& section : {none, name_section, manifest_section}) {
    bytes.append(reinterpret_cast<const char*>(&section), sizeof section);
  }
  write(folder / "plugin_library" / "two", bytes);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_make_corpus tests/fuzz/corpus\n";
    return 2;
  }
  const fs::path folder = argv[1];
  writeImages(folder);
  writeTemplates(folder);
  writeSequences(folder);
  writeSeqSlam(folder);
  writeReplay(folder);
  writeCells(folder);
  writeMap(folder);
  writeAnswers(folder);
  writeCalls(folder);
  writeLibrary(folder);
  return 0;
}
