// SPDX-License-Identifier: BSD-3-Clause
// Source `record`: the frames of a recorded run, bit for bit except for the images, which are not
// recorded.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recorded_answers.hpp"
#include "tolman/extras.hpp"
#include "tolman/roles.hpp"

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

}  // namespace tolman::record_source
