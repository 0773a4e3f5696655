// SPDX-License-Identifier: BSD-3-Clause
#include "record_source.hpp"

namespace tolman::record_source {

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
