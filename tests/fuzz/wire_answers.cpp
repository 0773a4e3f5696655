// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the answers of the process of an isolated plugin, as the host reads them: the record
// in a message, and the checks of the contract. The first byte of an input chooses the call, the
// next eight are the size of the message that follows.
#include <algorithm>

#include "base/codec.hpp"
#include "host/child_process.hpp"
#include "host/stages.hpp"
#include "input.hpp"
#include "small_plugins.hpp"

namespace {

using namespace tolman;

/// Reads status and results as ProcessHandle does.
template <class... T>
Status answerTo(Decoder& decoder, T&... results) {
  try {
    const auto status = decoder.next<Status>();
    if (status.isOk()) decoder.getAll(results...);
    if (decoder.remaining() > 0) throw std::domain_error("bytes follow its end");
    return status;
  } catch (const std::domain_error& error) {
    return Status::failed(error.what());
  }
}

/// Every role, with the answers of an input.
class Answers final : public Source, public Odometry, public Place, public Cells, public Map {
 public:
  explicit Answers(Decoder& decoder) : decoder_(decoder) {}
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  Status info(SourceInfo& info) override { return answerTo(decoder_, info); }
  Status next(Frame& frame) override { return answerTo(decoder_, frame); }
  Status track(const Frame&, Motion& motion) override { return answerTo(decoder_, motion); }
  Status observe(const Frame&, const Motion*, PlaceObservation& view) override {
    return answerTo(decoder_, view);
  }
  Status step(const Motion&, const PlaceObservation&, Decision& decision) override {
    return answerTo(decoder_, decision);
  }
  Status update(const Motion&, const Decision&, MapUpdate& update) override {
    return answerTo(decoder_, update);
  }
  Status poseOf(std::int64_t, Eigen::Isometry3d& pose) const override {
    return answerTo(decoder_, pose);
  }
  Status graph(MapGraph& graph) const override { return answerTo(decoder_, graph); }
  Status finish(std::vector<MotionRevision>& revisions) override {
    return answerTo(decoder_, revisions);
  }
  Status finish() override { return answerTo(decoder_); }
  Status finish(const std::vector<MotionRevision>&) override { return answerTo(decoder_); }

 private:
  Decoder& decoder_;
};

template <class RoleType>
std::unique_ptr<host::Instance> instanceOf(Answers& answers) {
  return std::make_unique<host::Instance>(host::Manifest{}, "stage",
                                          PluginObject{static_cast<RoleType*>(&answers)},
                                          [](Plugin*) { return Status::ok(); });
}

template <Record R>
void check(const Status& status, const R& record) {
  if (status.isOk()) fuzz::require(firstInvalidField(record).empty(), "an invalid answer");
}

void askStages(int call, Answers& answers) {
  const Motion motion = fuzz::straightMotion(0);
  const PlaceObservation view = fuzz::seenView(0, Recognition::None, -1);
  Frame frame;
  switch (call) {
    case 0:
      return check(host::SourceStage(instanceOf<Source>(answers)).next(frame), frame);
    case 1: {
      Motion answer;
      return check(host::OdometryStage(instanceOf<Odometry>(answers)).track(frame, answer), answer);
    }
    case 2: {
      PlaceObservation answer;
      return check(host::PlaceStage(instanceOf<Place>(answers)).observe(frame, &motion, answer),
                   answer);
    }
    case 3: {
      Decision answer;
      return check(host::CellsStage(instanceOf<Cells>(answers)).step(motion, view, answer), answer);
    }
    case 4: {
      MapUpdate answer;
      return check(host::MapStage(instanceOf<Map>(answers)).update(motion, {}, answer), answer);
    }
    case 5: {
      MapGraph answer;
      const Status status = host::MapStage(instanceOf<Map>(answers)).graph(answer);
      for (const Link& link : answer.links) {
        if (status.isOk()) (void)answer.isRejected(link);
      }
      return check(status, answer);
    }
    case 6: {
      SourceInfo answer;
      return check(host::SourceStage(instanceOf<Source>(answers)).info(answer), answer.rig);
    }
    case 7: {
      std::vector<MotionRevision> answer;
      (void)host::OdometryStage(instanceOf<Odometry>(answers)).finish(answer);
      return;
    }
    default:
      return;
  }
}

void readOthers(int call, Decoder& decoder) {
  std::vector<NamedArray> arrays;
  std::vector<ArrayInfo> infos;
  std::string text;
  host::Refusal refusal;
  Schema schema;
  bool first = false;
  bool second = false;
  Finding finding;
  if (call == 8) (void)answerTo(decoder, finding);
  if (call == 9) (void)answerTo(decoder, arrays);
  if (call == 10) (void)answerTo(decoder, infos);
  if (call == 11) (void)answerTo(decoder, text);
  if (call == 12) (void)answerTo(decoder, refusal, schema);
  if (call == 13) (void)answerTo(decoder, refusal, first, second);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input({data, size});
  const int call = input.take<std::uint8_t>() % 14;
  const auto claimed = input.take<std::uint64_t>();
  const fuzz::Bytes bytes = input.rest();
  if (claimed > bytes.size()) return 0;
  Decoder decoder(fuzz::asText(bytes).substr(0, claimed));
  Answers answers(decoder);
  if (call < 8) {
    askStages(call, answers);
  } else {
    readOthers(call, decoder);
  }
  return 0;
}
