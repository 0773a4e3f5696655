// SPDX-License-Identifier: BSD-3-Clause
#include "interpreter.hpp"

#include <dlfcn.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string_view>
#include <vector>

#include "convert.hpp"
#include "stages.hpp"

namespace tolman::python {
namespace fs = std::filesystem;

namespace {

OpenedProgram& theProgram() {
  static auto* const program = new OpenedProgram();  // leaked, as all objects of Python
  return *program;
}

/// Numbers of threads of NumPy's libraries. With several threads sums depend on the number of
/// cores.
constexpr std::array kOneThread = {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"};

/// Sets those of these variables that are not set, while libraries are loaded.
class OneThread {
 public:
  OneThread() {
    for (const char* name : kOneThread) {
      if (std::getenv(name) != nullptr) continue;
      ::setenv(name, "1", 1);
      set_.push_back(name);
    }
  }
  ~OneThread() {
    for (const char* name : set_) ::unsetenv(name);
  }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  std::vector<const char*> set_;
};

fs::path ownFile() {
  Dl_info info{};
  ::dladdr(reinterpret_cast<const void*>(&openProgram), &info);
  return info.dli_fname == nullptr ? fs::path() : fs::path(info.dli_fname);
}

/// The folder of the package `tolman`: of the build tree, or of an installation that Python does
/// not search by itself.
std::string packageFolder() {
  const fs::path here = ownFile().parent_path();
  for (const char* way :
       {"../python", "../../../python3/dist-packages", "../../python3/dist-packages"}) {
    std::error_code error;
    const fs::path folder = here / way;
    if (fs::is_directory(folder / "tolman", error)) return fs::weakly_canonical(folder, error);
  }
  return {};
}

/// Makes the symbols of libpython global: extension modules need them, but a plugin's dependencies
/// are loaded as local.
void showSymbols() {
  Dl_info info{};
  if (::dladdr(reinterpret_cast<const void*>(&Py_IsInitialized), &info) == 0) return;
  ::dlopen(info.dli_fname, RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD);
}

/// Starts Python as the program `python3` does, with the active virtual environment, but without
/// signal handlers and with a fixed hash seed, so that the order of sets is the same in every run.
/// Of the variables PYTHON... only those that say where packages are have an effect: others, such
/// as PYTHONHOME, PYTHONOPTIMIZE and PYTHONINSPECT, are for other programs, and would keep Python
/// from starting or change what a plugin does.
/// Throws std::runtime_error.
void startPython() {
  if (Py_IsInitialized() != 0) return;
  showSymbols();
  PyPreConfig before;
  PyPreConfig_InitPythonConfig(&before);
  before.use_environment = 0;
  before.configure_locale = 0;
  before.utf8_mode = 1;
  Py_PreInitialize(&before);
  PyConfig config;
  PyConfig_InitPythonConfig(&config);
  config.use_environment = 0;
  config.user_site_directory = std::getenv("PYTHONNOUSERSITE") == nullptr ? 1 : 0;
  if (const char* packages = std::getenv("PYTHONPATH"); packages != nullptr) {
    PyConfig_SetBytesString(&config, &config.pythonpath_env, packages);
  }
  config.install_signal_handlers = 0;
  config.use_hash_seed = 1;
  config.hash_seed = 0;
  config.write_bytecode = 0;
  const char* environment = std::getenv("VIRTUAL_ENV");
  const std::string program =
      environment == nullptr ? "/usr/bin/python3" : std::string(environment) + "/bin/python3";
  PyConfig_SetBytesString(&config, &config.program_name, program.c_str());
  const PyStatus status = Py_InitializeFromConfig(&config);
  PyConfig_Clear(&config);
  if (PyStatus_Exception(status) != 0) {
    throw std::runtime_error(std::string("Python does not start: ") +
                             (status.err_msg != nullptr ? status.err_msg : "no reason given"));
  }
  PyEval_SaveThread();  // releases the lock; every call takes it itself
}

ParameterType typeNamed(const std::string& name) {
  static const std::map<std::string, ParameterType> kTypes = {
      {"bool", ParameterType::Bool},    {"integer", ParameterType::Integer},
      {"real", ParameterType::Real},    {"text", ParameterType::Text},
      {"path", ParameterType::Path},    {"choice", ParameterType::Choice},
      {"list", ParameterType::RealList}};
  return kTypes.at(name);
}

ParameterValue valueOf(ParameterType type, py::handle value) {
  switch (type) {
    case ParameterType::Bool:
      return value.cast<bool>();
    case ParameterType::Integer:
      return value.cast<std::int64_t>();
    case ParameterType::Real:
      return value.cast<double>();
    case ParameterType::RealList: {
      std::vector<double> list;
      for (const py::handle item : value) list.push_back(item.cast<double>());
      return list;
    }
    default:
      return value.cast<std::string>();
  }
}

ParameterInfo parameterFrom(py::handle declared) {
  ParameterInfo info;
  info.name = declared["name"].cast<std::string>();
  info.type = typeNamed(declared["type"].cast<std::string>());
  info.default_value = valueOf(info.type, declared["default"]);
  info.required = declared["required"].cast<bool>();
  info.min = declared["min"].cast<double>();
  info.max = declared["max"].cast<double>();
  info.unit = declared["unit"].cast<std::string>();
  info.doc = declared["doc"].cast<std::string>();
  for (const py::handle choice : declared["choices"]) {
    info.choices.push_back(choice.cast<std::string>());
  }
  return info;
}

/// Writes the stack to stderr when a signal ends the process, and at SIGUSR2, which the host sends
/// to a call that does not return. `faulthandler` needs no lock of the interpreter for it.
void writeStackAtFaults() {
  using py::literals::operator""_a;
  const py::object handler = py::module_::import("faulthandler");
  handler.attr("register")(SIGUSR2, "all_threads"_a = false);
  handler.attr("enable")("all_threads"_a = false);
}

void import(const std::string& file, Program& program) {
  const OneThread one_thread;
  writeStackAtFaults();
  if (const std::string folder = packageFolder(); !folder.empty()) {
    py::module_::import("sys").attr("path").attr("insert")(0, folder);
  }
  OpenedProgram& known = theProgram();
  known.host = py::module_::import("tolman._host");
  const py::object about = known.host.attr("open_program")(file);
  known.type = about["class"];
  known.has_arrays = about["arrays"].cast<bool>();
  known.has_descriptions = about["describe"].cast<bool>();
  program.version = about["version"].cast<std::string>();
  program.summary = about["summary"].cast<std::string>();
  for (const py::handle name : about["files"]) program.files.push_back(name.cast<std::string>());
  for (const py::handle declared : about["schema"]) {
    program.schema.push_back(parameterFrom(declared));
  }
  program.descriptor = descriptorOf(about["role"].cast<std::string>());
}

StatusCode codeNamed(const std::string& name) {
  if (name == "InvalidInput") return StatusCode::InvalidInput;
  if (name == "InvalidParameter") return StatusCode::InvalidParameter;
  if (name == "Unsupported") return StatusCode::Unsupported;
  return StatusCode::Failed;
}

/// The failure for an exception. Before the package is imported it is the exception's own text.
Status failureOf(py::error_already_set& error, const char* call, Logger* log) {
  const OpenedProgram& program = theProgram();
  if (!program.host) {
    const std::string hint = error.matches(PyExc_ModuleNotFoundError)
                                 ? "; install python3-numpy and python3-tolman"
                                 : "";
    return Status::failed(textFrom(py::str(error.value()), "the text of an exception") + hint);
  }
  error.restore();
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  if (trace != nullptr) PyException_SetTraceback(value, trace);
  const auto kept = py::reinterpret_steal<py::object>(value);
  Py_XDECREF(type);
  Py_XDECREF(trace);
  const py::tuple words = program.host.attr("described")(kept, call);
  const auto text = words[1].cast<std::string>();
  if (log != nullptr && !text.empty()) log->error(text);
  const auto code = program.host.attr("status_name")(kept).cast<std::string>();
  std::string line = words[0].cast<std::string>();
  if (log == nullptr && !text.empty()) line += "\n" + text;  // no log is open yet
  return {codeNamed(code), line};
}

}  // namespace

const OpenedProgram& opened() { return theProgram(); }

Status inPython(const char* call, Logger* log, const std::function<void()>& work) {
  const py::gil_scoped_acquire lock;
  const pid_t process = ::getpid();
  Status status;
  try {
    work();
  } catch (py::error_already_set& error) {
    try {
      status = failureOf(error, call, log);
    } catch (const std::exception& second) {
      status =
          Status::failed(std::string("raised an exception that cannot be shown: ") + second.what());
    }
  } catch (const std::exception& error) {
    status = Status::failed(error.what());
  }
  if (::getpid() != process) ::_exit(0);
  return status;
}

Status openProgram(const std::string& file, Program& program) {
  startPython();
  return inPython("import", nullptr, [&] { import(file, program); });
}

}  // namespace tolman::python
