// SPDX-License-Identifier: BSD-3-Clause
// The stages that a program in Python provides.
//
// What the roles have in common: parameters, reset, arrays, state.
#pragma once

#include <pybind11/pybind11.h>

#include <istream>
#include <iterator>
#include <ostream>
#include <string>

#include "convert.hpp"
#include "interpreter.hpp"
#include "tolman/context.hpp"
#include "tolman/plugin.hpp"

namespace tolman::python {

// The services of a context as Python objects. They refer to those of the context, which must
// outlive them.

/// A dict with log, write_artefact, rig, seed and name.
py::object servicesOf(const Context& context);
/// A dict from names to values.
py::object valuesOf(const ParameterValues& values);

/// An answer without frame and time gets those of the question.
template <class Answer, class Question>
void address(Answer& answer, const Question& question) {
  if (answer.frame < 0) {
    answer.frame = question.frame;
    answer.stamp_ns = question.stamp_ns;
  }
}

template <class RoleType>
class PythonStage : public RoleType,
                    public ArraySource,
                    public ArrayDescriptions,
                    public StateKeeper {
 public:
  ~PythonStage() noexcept(false) override {
    if (Py_IsInitialized() == 0) return;
    const py::gil_scoped_acquire lock;
    object_ = services_ = values_ = py::object();
  }

  Status configure(const Context& context) override {
    log_ = &context.log;
    return work("start", [&] {
      services_ = servicesOf(context);
      values_ = valuesOf(context.parameters);
      make();
    });
  }
  Status reset() override {
    return work("start", [&] { make(); });
  }
  void arrays(std::vector<NamedArray>& arrays) const override {
    const Status status = work("arrays", [&] {
      auto more = arraysFrom(object_.attr("arrays")(), "arrays()");
      arrays.insert(arrays.end(), std::make_move_iterator(more.begin()),
                    std::make_move_iterator(more.end()));
    });
    if (!status.isOk()) throw std::runtime_error(status.message());
  }
  Status describe(std::vector<ArrayInfo>& arrays) const override {
    if (!opened().has_descriptions) return Status::ok();
    return work("describe", [&] {
      std::vector<ArrayInfo> more;
      fromPython(object_.attr("describe")(), more, "describe()");
      arrays.insert(arrays.end(), more.begin(), more.end());
    });
  }
  Status save(std::ostream& stream) const override {
    return work("save", [&] {
      const std::string bytes = py::bytes(opened().host.attr("save")(object_));
      stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
  }
  Status load(std::istream& stream) override {
    const std::string bytes(std::istreambuf_iterator<char>(stream), {});
    Status status = work("load", [&] {
      make();  // a fresh object: the state may not contain all attributes
      opened().host.attr("load")(object_, py::bytes(bytes));
    });
    if (!status.isOk()) (void)reset();
    return status;
  }

 protected:
  Status work(const char* call, const std::function<void()>& body) const {
    return inPython(call, log_, body);
  }
  /// Calls a method of the Python object.
  template <class... Arguments>
  py::object ask(const char* method, const Arguments&... arguments) const {
    return object_.attr(method)(toPython(arguments)...);
  }
  /// Calls a method and takes its answer as a record or a list of them.
  template <class Answer, class... Arguments>
  void answer(Answer& record, const char* method, const Arguments&... arguments) const {
    fromPython(ask(method, arguments...), record, std::string(method) + "()");
  }
  py::handle object() const { return object_; }

 private:
  void make() { object_ = opened().host.attr("make")(opened().type, services_, values_); }

  Logger* log_ = nullptr;
  py::object object_;
  py::object services_;
  py::object values_;
};

// The six roles, each passing its calls to an object of the program's class.

/// The descriptor of a role, with static storage. Throws std::out_of_range for an unknown role.
const PluginDescriptor* descriptorOf(const std::string& role);

}  // namespace tolman::python
