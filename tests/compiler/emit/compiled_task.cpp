#include "tests/compiler/emit/compiled_task.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <stdexcept>

#include "compiler/toolchain/child_process.h"
#include "compiler/toolchain/cxx_compiler.h"
#include "compiler/toolchain/file_io.h"
#include "tests/compiler/emit/emitted_text.h"

namespace compiler {
namespace {

size_t SizeOf(taskc_int32 scalar) { return scalar == TASKC_BOOL ? 1 : 8; }

void Store(unsigned char* place, taskc_int32 scalar, double value) {
  if (scalar == TASKC_BOOL) {
    *place = value != 0;
  } else if (scalar == TASKC_INT) {
    auto integer = static_cast<taskc_int64>(value);
    std::memcpy(place, &integer, sizeof integer);
  } else {
    std::memcpy(place, &value, sizeof value);
  }
}

double Load(const unsigned char* place, taskc_int32 scalar) {
  if (scalar == TASKC_BOOL) return *place;
  if (scalar == TASKC_INT) {
    taskc_int64 integer = 0;
    std::memcpy(&integer, place, sizeof integer);
    return static_cast<double>(integer);
  }
  double value = 0;
  std::memcpy(&value, place, sizeof value);
  return value;
}

template <class Entry>
size_t IndexOf(const Entry* table, size_t count, const std::string& name) {
  for (size_t i = 0; i < count; ++i) {
    if (name == table[i].name) return i;
  }
  throw std::runtime_error("the plugin has no " + name);
}

void Compile(const std::string& cpp, const std::string& optimization,
             const std::filesystem::path& folder) {
  WriteWholeFile(folder / "plugin.cpp", cpp);
  CxxCompiler cxx = FindCxxCompiler();
  std::vector<std::string> command = cxx.command;
  for (const std::string& flag : PluginFlags()) {
    command.push_back(flag == "-O2" ? optimization : flag);
  }
  // What -w hides from users must not hide from us that the text is sloppy.
  std::erase(command, "-w");
  for (const char* word : {"-Wall", "-Wextra", "-Werror"}) command.emplace_back(word);
  for (std::string word :
       {std::string("-I"), std::string(SOURCE_DIR "/plugins/abi"), std::string("-x"),
        std::string("c++"), std::string("-"), std::string("-o"), (folder / "plugin.so").string()}) {
    command.push_back(word);
  }
  command.insert(command.end(), PluginLibraries().begin(), PluginLibraries().end());
  int status = Run({.command = command,
                    .input = folder / "plugin.cpp",
                    .output = folder / "output.txt",
                    .scratch = folder});
  if (status != 0) {
    throw std::runtime_error(ReadWholeFile(folder / "output.txt").value_or("") + cpp);
  }
}

}  // namespace

CompiledTask::CompiledTask(const std::string& text, const std::string& optimization,
                           const std::string& path) {
  Compile(EmitText(text, path), optimization, folder_.path());
  library_ = dlopen((folder_.path() / "plugin.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library_ == nullptr) throw std::runtime_error(dlerror());
  auto entry = reinterpret_cast<taskc_plugin_entry>(dlsym(library_, TASKC_PLUGIN_ENTRY));
  if (entry == nullptr) throw std::runtime_error("the plugin has no entry");
  plugin_ = entry();
}

CompiledTask::~CompiledTask() { dlclose(library_); }

Instance::Instance(const CompiledTask& task) : plugin_(task.plugin()) {
  for (const taskc_sensor& sensor : std::span(plugin_.sensors, plugin_.sensor_count)) {
    sensors_.emplace_back(sensor.rows * sensor.columns * SizeOf(sensor.scalar));
    sensor_pointers_.push_back(sensors_.back().data());
  }
  for (const taskc_param& param : std::span(plugin_.params, plugin_.param_count)) {
    params_.push_back(param.initial);
  }
  memory_.assign(plugin_.memory_size, 0xEE);  // nothing may rely on zeroes
  terms_.resize(plugin_.term_count);
  metrics_.resize(plugin_.metric_count);
  logs_.resize(plugin_.log_count);
  frame_.sensors = sensor_pointers_.data();
  frame_.params = params_.data();
  frame_.memory = memory_.data();
  frame_.terms = terms_.data();
  frame_.metrics = metrics_.data();
  frame_.logs = logs_.data();
  Initialize();
}

void Instance::Sense(const std::string& name, const std::vector<double>& values) {
  size_t index = IndexOf(plugin_.sensors, plugin_.sensor_count, name);
  const taskc_sensor& sensor = plugin_.sensors[index];
  if (values.size() != sensor.rows * sensor.columns) throw std::runtime_error("wrong count");
  for (size_t i = 0; i < values.size(); ++i) {
    Store(&sensors_[index][i * SizeOf(sensor.scalar)], sensor.scalar, values[i]);
  }
}

void Instance::SetParam(const std::string& name, double value) {
  params_[IndexOf(plugin_.params, plugin_.param_count, name)] = value;
}

void Instance::Fire(int event, double time_step) {
  frame_.time_step = time_step;
  frame_.reward = 0;
  frame_.end = -1;
  frame_.fault = -1;
  frame_.violation = -1;
  if (plugin_.events[event] != nullptr) plugin_.events[event](&frame_);
}

void Instance::ClearTerms() { std::ranges::fill(terms_, 0.0); }

double Instance::Term(const std::string& name) const {
  return terms_[IndexOf(plugin_.terms, plugin_.term_count, name)];
}

double Instance::Metric(const std::string& name) const {
  return metrics_[IndexOf(plugin_.metrics, plugin_.metric_count, name)];
}

const taskc_log_state& Instance::Log(const std::string& name) const {
  return logs_[IndexOf(plugin_.logs, plugin_.log_count, name)];
}

double Instance::Memory(const std::string& name, size_t element) const {
  const taskc_memory& entry = plugin_.memory[IndexOf(plugin_.memory, plugin_.memory_count, name)];
  return Load(&memory_[entry.offset + element * SizeOf(entry.scalar)], entry.scalar);
}

double Instance::Goal(const std::string& name, size_t element) const {
  const taskc_goal& goal = plugin_.goals[IndexOf(plugin_.goals, plugin_.goal_count, name)];
  return Load(&memory_[goal.offset + element * SizeOf(goal.scalar)], goal.scalar);
}

}  // namespace compiler
