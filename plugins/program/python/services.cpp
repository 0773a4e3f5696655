// SPDX-License-Identifier: BSD-3-Clause
#include "services.hpp"

#include <span>

#include "convert.hpp"

namespace tolman::python {
namespace {

py::object logOf(Logger& log) {
  const auto writer = [&log](LogLevel level) {
    return py::cpp_function([&log, level](py::handle text) {
      log.write(level, textFrom(py::str(text), "the text of a log line"));
    });
  };
  const py::object made = py::module_::import("types").attr("SimpleNamespace")();
  for (const LogLevel level :
       {LogLevel::Debug, LogLevel::Info, LogLevel::Warning, LogLevel::Error}) {
    py::setattr(made, std::string(enumName(level)).c_str(), writer(level));
  }
  return made;
}

py::object collectorOf(FindingCollector& findings) {
  return py::cpp_function([&findings](py::handle value) {
    Finding finding;
    fromPython(value, finding, "the finding");
    findings.add(std::move(finding));
  });
}

py::object writerOf(ArtefactWriter& artefacts) {
  return py::cpp_function([&artefacts](const std::string& name, const py::object& content) {
    // Text with lone surrogates has no UTF-8: encode() raises an error that names the first one.
    const bool is_text = PyUnicode_Check(content.ptr()) != 0;
    const std::string bytes{py::bytes(is_text ? content.attr("encode")("utf-8") : content)};
    const Status status = artefacts.write(name, std::as_bytes(std::span(bytes)));
    if (!status.isOk()) throw py::value_error(status.message());
  });
}

}  // namespace

py::object servicesOf(const Context& context) {
  py::dict services;
  services["log"] = logOf(context.log);
  services["add_finding"] = collectorOf(context.findings);
  services["write_artefact"] = writerOf(context.artefacts);
  services["rig"] = toPython(context.rig);
  services["seed"] = py::int_(context.seed);
  services["name"] = toPython(context.instance);
  return services;
}

py::object valuesOf(const ParameterValues& values) {
  py::dict dict;
  for (const auto& value : values) {  // a lambda of clang 14 cannot capture parts of it
    std::visit([&](const auto& held) { dict[toPython(value.first)] = toPython(held); },
               value.second);
  }
  return dict;
}

}  // namespace tolman::python
