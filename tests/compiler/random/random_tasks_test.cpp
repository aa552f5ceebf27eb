// Random tasks: the evaluator, the plugin without optimization and the plugin as users get it give
// the same bits, whatever the sensors say.
//
// TASKC_RANDOM_TASKS=5000 tries more tasks than usual, and all of them with optimization, too;
// TASKC_RANDOM_SEED=71 tries others.
#include <dlfcn.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>

#include "compiler/emit/emit.h"
#include "compiler/task_tests/side_by_side.h"
#include "compiler/toolchain/child_process.h"
#include "compiler/toolchain/cxx_compiler.h"
#include "compiler/toolchain/file_io.h"
#include "tests/compiler/check/checked_source.h"
#include "tests/compiler/random/random_task.h"
#include "tests/compiler/random/random_values.h"
#include "tests/compiler/temporary_folder.h"

namespace compiler {
namespace {

uint32_t NumberFrom(const char* variable, uint32_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : static_cast<uint32_t>(std::stoul(text));
}

void ReplaceAll(std::string& text, const std::string& what, const std::string& with) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
}

// Several plugins in one library: starting the C++ compiler costs more than most tasks.
class Library {
 public:
  // `cpps`: what was emitted for each task.
  Library(const std::vector<std::string>& cpps, const std::string& optimization) {
    std::string text = "#include <taskc/plugin.h>\n";
    for (size_t i = 0; i < cpps.size(); ++i) text += InNamespace(cpps[i], i);
    Compile(text, optimization);
    library_ = dlopen((folder_.path() / "plugins.so").c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr) throw std::runtime_error(dlerror());
  }
  ~Library() {
    if (library_ != nullptr) dlclose(library_);
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  const taskc_plugin& operator[](size_t i) const {
    const std::string name = fmt::format("{}_{}", TASKC_PLUGIN_ENTRY, i);
    return *reinterpret_cast<taskc_plugin_entry>(dlsym(library_, name.c_str()))();
  }

 private:
  static std::string InNamespace(std::string cpp, size_t number) {
    ReplaceAll(cpp, "#include <taskc/plugin.h>", "");
    ReplaceAll(cpp, TASKC_PLUGIN_ENTRY "()", fmt::format("{}_{}()", TASKC_PLUGIN_ENTRY, number));
    return fmt::format("namespace task_{} {{\n{}\n}}\n", number, cpp);
  }

  void Compile(const std::string& text, const std::string& optimization) {
    WriteWholeFile(folder_.path() / "plugins.cpp", text);
    std::vector<std::string> command = FindCxxCompiler().command;
    for (const std::string& flag : PluginFlags()) {
      if (flag == "-g1") continue;  // lines for debuggers change no code, and take time
      command.push_back(flag == "-O2" ? optimization : flag);
    }
    command.insert(command.end(), {"-I", SOURCE_DIR "/plugins/abi", "-x", "c++", "-", "-o",
                                   folder_.path() / "plugins.so"});
    command.insert(command.end(), PluginLibraries().begin(), PluginLibraries().end());
    const int status = Run({.command = command,
                            .input = folder_.path() / "plugins.cpp",
                            .output = folder_.path() / "output.txt",
                            .scratch = folder_.path()});
    if (status != 0) {
      throw std::runtime_error(ReadWholeFile(folder_.path() / "output.txt").value_or(""));
    }
  }

  TemporaryFolder folder_;
  void* library_ = nullptr;
};

// A task that is built and used in every way.
struct Subject {
  explicit Subject(std::string task_text)
      : text(std::move(task_text)), checked("random.task", text) {
    if (checked.task) cpp = Emit(*checked.task, checked.sources);
  }

  std::string text;
  CheckedSource checked;
  std::string cpp;
};

// From anything that a pose might be.
void DrawStart(const CheckedTask& task, RandomNumbers& random, SideBySide& both) {
  if (task.start.poses.empty()) return;
  both.SetSeed(static_cast<uint64_t>(random.Bits()));
  for (const CheckedStartValue& value : task.start.values)
    both.SetMemory(value.memory, RandomValue(task.memory[value.memory].type, random));
  both.DrawStart(static_cast<uint32_t>(random.Below(3)));
}

// What differs between plugin and evaluator when it is used for a while; nothing if nothing does.
std::optional<std::string> FindDifference(const CheckedTask& task, const taskc_plugin& plugin,
                                          uint32_t seed) {
  RandomNumbers random(seed);
  try {
    SideBySide both(task, plugin);
    for (int call = 0; call < 40; ++call) {
      for (uint32_t i = 0; i < task.sensors.size(); ++i) {
        if (random.OneIn(2)) both.SetSensor(i, RandomValue(task.sensors[i].type, random));
      }
      for (uint32_t i = 0; i < task.params.size(); ++i) {
        if (!random.OneIn(8)) continue;
        const bool is_real = task.params[i].type.scalar == Scalar::kReal;
        both.SetParam(i, is_real ? RandomReal(random) : random.Below(3));
      }
      DrawStart(task, random, both);
      if (random.OneIn(8)) both.SetDiscount(random.OneOf({0.0, 0.9, 1.0}));
      both.Fire(static_cast<EventKind>(random.Below(TASKC_EVENT_COUNT)), RandomReal(random));
    }
  } catch (const Disagreement& found) {
    return found.what();
  }
  return std::nullopt;
}

const std::vector<std::string> kOptimizations = {"-O0", "-O2"};

std::optional<std::string> FindDifference(const std::string& text, uint32_t seed) {
  const Subject subject(text);
  if (!subject.checked.task) return std::nullopt;
  for (const std::string& optimization : kOptimizations) {
    const Library library({subject.cpp}, optimization);
    if (auto found = FindDifference(*subject.checked.task, library[0], seed)) {
      return fmt::format("with {}, {}", optimization, *found);
    }
  }
  return std::nullopt;
}

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = text.find('\n', begin) + 1;
    lines.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return lines;
}

// The same task without the lines that the difference does not need.
std::string Shrink(const std::string& text, uint32_t seed) {
  std::vector<std::string> lines = LinesOf(text);
  const auto without = [&](size_t first, size_t count) {
    std::string rest;
    for (size_t i = 0; i < lines.size(); ++i) {
      if (i < first || i >= first + count) rest += lines[i];
    }
    return rest;
  };
  for (size_t count = lines.size() / 2; count > 0; count /= 2) {
    for (size_t first = 0; first + count <= lines.size();) {
      if (const std::string rest = without(first, count); FindDifference(rest, seed)) {
        lines = LinesOf(rest);
      } else {
        first += count;
      }
    }
  }
  return without(0, 0);
}

void ExpectNoDifference(const Subject& subject, const taskc_plugin& plugin, uint32_t seed) {
  if (!FindDifference(*subject.checked.task, plugin, seed)) return;
  const std::string shrunk = Shrink(subject.text, seed);
  ADD_FAILURE() << "seed " << seed << ": " << FindDifference(shrunk, seed).value_or("") << "\n"
                << shrunk;
}

constexpr uint32_t kBatch = 10;
constexpr uint32_t kParts = 4;  // of the tasks, tried side by side
constexpr const char* kCount = "TASKC_RANDOM_TASKS";

// Optimization takes its time: unless a number of tasks is asked for, it is tried with a fifth.
std::span<const std::string> OptimizationsOf(uint32_t batch) {
  const bool is_optimized = std::getenv(kCount) != nullptr || batch % 5 == 0;
  return std::span(kOptimizations).first(is_optimized ? 2 : 1);
}

// A batch of tasks: those with the seeds from `seed` on.
void ExpectSameToAll(std::string (*make)(uint32_t seed), uint32_t seed,
                     std::span<const std::string> optimizations) {
  std::vector<std::unique_ptr<Subject>> subjects;
  std::vector<std::string> cpps;
  for (uint32_t i = 0; i < kBatch; ++i) {
    subjects.push_back(std::make_unique<Subject>(make(seed + i)));
    const Subject& subject = *subjects.back();
    ASSERT_TRUE(subject.checked.task) << "seed " << seed + i << "\n"
                                      << subject.checked.Messages() << subject.text;
    cpps.push_back(subject.cpp);
  }
  for (const std::string& optimization : optimizations) {
    const Library library(cpps, optimization);
    for (uint32_t i = 0; i < kBatch; ++i) ExpectNoDifference(*subjects[i], library[i], seed + i);
  }
}

class RandomTasksInParts : public testing::TestWithParam<uint32_t> {
 protected:
  // Of every `share` tasks that are wanted one, in this part.
  void ExpectSame(std::string (*make)(uint32_t seed), uint32_t share) {
    const uint32_t first = NumberFrom("TASKC_RANDOM_SEED", 1);
    const uint32_t batches = NumberFrom(kCount, 200) / share / kBatch;
    for (uint32_t i = 0; kParts * i + GetParam() < batches; ++i) {
      ExpectSameToAll(make, first + kBatch * (kParts * i + GetParam()), OptimizationsOf(i));
      if (testing::Test::HasFailure()) return;
    }
  }
};

TEST_P(RandomTasksInParts, AreRightAndMeanTheSameToAll) { ExpectSame(RandomTask, 1); }

TEST_P(RandomTasksInParts, StartTheSameForAll) { ExpectSame(RandomStart, 3); }

INSTANTIATE_TEST_SUITE_P(RandomTasks, RandomTasksInParts, testing::Range(0u, kParts));

}  // namespace
}  // namespace compiler
