// SPDX-License-Identifier: BSD-3-Clause
// Source `record`: the frames of a recorded run, bit for bit except for the images, which are not
// recorded.
#include "tolman/plugin.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include "recorded_answers.hpp"

namespace tolman::record_source {

struct RecordSourceParameters {
  std::string path;

  static constexpr auto declaration() {
    return parameters(parameter("path", &RecordSourceParameters::path)
                          .path()
                          .required()
                          .doc("Run directory, of a run with `record.replay: true`."));
  }
};

class RecordSource final : public Source, public ArrayDescriptions {
 public:
  using Parameters = RecordSourceParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status info(SourceInfo& info) override;
  Status next(Frame& frame) override;
  Status describe(std::vector<ArrayInfo>& arrays) const override;

 private:
  std::string path_;
  recorded_answers::RecordedAnswers reader_;
  Status ready_ = Status::failed("configure() was not called");
  std::int64_t next_ = 0;
};

Status RecordSource::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return ready_ = bound.status();
  path_ = bound.value().path;
  ready_ = reader_.open(path_);
  if (!reader_.part().empty())
    context.findings.add({Finding::Severity::Warning, path_, reader_.part()});
  return ready_;
}

Status RecordSource::reset() {
  next_ = 0;
  return ready_;
}

Status RecordSource::info(SourceInfo& info) {
  if (ready_.isOk()) info = reader_.source();
  return ready_;
}

Status RecordSource::next(Frame& frame) {
  if (!ready_.isOk()) return ready_;
  if (next_ >= reader_.frames()) return Status::endOfStream();
  return reader_.read(next_++, frame);
}

Status RecordSource::describe(std::vector<ArrayInfo>& arrays) const {
  arrays.insert(arrays.end(), reader_.sensors().begin(), reader_.sensors().end());
  return Status::ok();
}

}  // namespace tolman::record_source

TOLMAN_PLUGIN(record, tolman::record_source::RecordSource, "0.1.0",
              "The frames of a run that was made with record.replay, without images.");
