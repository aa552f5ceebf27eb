// Whole training runs, as a user starts them. By the processor time of the trainer and all that it
// calls, unless a name says `wall`: that hardly depends on what else the machine does.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/training/simulation/profile.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

// A folder for the runs, removed at the end.
const fs::path& Folder() {
  static const struct Owner {
    Owner() {
      std::string name = (fs::temp_directory_path() / "trainer-bench-XXXXXX").string();
      path = mkdtemp(name.data());
    }
    ~Owner() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
    fs::path path;
  } owner;
  return owner.path;
}

struct Outcome {
  bool ok = false;
  double wall = 0;    // [s]
  double cpu = 0;     // [s]
  double memory = 0;  // at its largest [MB]
};

// Runs the trainer with its output in `output`.
Outcome RunTrainer(const std::vector<std::string>& arguments, const fs::path& output) {
  std::string command = fmt::format("exec '{}'", TRAINER);
  for (const std::string& argument : arguments) command += fmt::format(" '{}'", argument);
  command += fmt::format(" >'{}' 2>/dev/null", output.string());
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {WIFEXITED(status) && WEXITSTATUS(status) == 0, wall.count(),
          seconds(usage.ru_utime) + seconds(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

fs::path RunFolder() {
  const fs::path folder = Folder() / "run";
  fs::remove_all(folder);
  return folder;
}

std::string Task(const std::string& name) {
  return fmt::format("{}/tasks/{}.task", SOURCE_DIR, name);
}

// From the call to the end of a run of one step, whose task is built already.
void StartUp(benchmark::State& state) {
  const fs::path task = Folder() / "instant.task";
  std::ofstream(task) << "task instant for humanoid\n\non end_of_time_step {\n"
                         "  if time >= 0 s { truncate_episode \"at once\" }\n}\n";
  double wall = 0;
  const auto run = [&] {
    return RunTrainer({"train", task.string(), "--profile", "fast", "--episodes", "1", "--out",
                       RunFolder().string()},
                      Folder() / "output");
  };
  run();  // fills the caches
  for (auto _ : state) {
    const Outcome outcome = run();
    if (!outcome.ok) state.SkipWithError("the trainer failed");
    state.SetIterationTime(outcome.cpu);
    wall += outcome.wall;
  }
  state.counters["wall_ms"] = 1e3 * wall / static_cast<double>(state.iterations());
}
BENCHMARK(StartUp)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(10);

// A beginner's first episodes. A minute is one of processor time.
void Train(benchmark::State& state, const std::string& task, const std::string& profile,
           int episodes) {
  for (auto _ : state) {
    const fs::path output = Folder() / "output";
    const Outcome outcome =
        RunTrainer({"train", Task(task), "--profile", profile, "--seed", "1", "--episodes",
                    std::to_string(episodes), "--out", RunFolder().string(), "--json"},
                   output);
    if (!outcome.ok) state.SkipWithError("the trainer failed");
    double simulated = 0;
    double cpu = 0;
    std::ifstream lines(output);
    for (std::string line; std::getline(lines, line);) {
      const nlohmann::json episode = nlohmann::json::parse(line);
      simulated += episode["simulated_seconds"].get<double>();
      cpu += episode["cpu_seconds"].get<double>();
    }
    state.SetIterationTime(outcome.cpu);
    state.counters["episodes_per_minute"] = 60 * episodes / cpu;
    state.counters["x_real_time"] = simulated / cpu;
    state.counters["memory_MB"] = outcome.memory;
  }
}

// The same two runs one after the other and side by side.
void TwoWorkers(benchmark::State& state) {
  const auto run = [](const char* jobs) {
    return RunTrainer({"train", Task("forward_rolling"), "--profile", "fast", "--episodes", "20",
                       "--runs", "2", "--jobs", jobs, "--out", RunFolder().string(), "--quiet"},
                      Folder() / "output");
  };
  for (auto _ : state) {
    const Outcome one = run("1");
    const Outcome two = run("2");
    if (!one.ok || !two.ok) state.SkipWithError("the trainer failed");
    state.SetIterationTime(two.cpu);
    state.counters["wall_ratio"] = one.wall / two.wall;
    state.counters["cpu_ratio"] = one.cpu / two.cpu;
  }
}
BENCHMARK(TwoWorkers)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(1);

void RegisterTraining() {
  for (const char* task :
       {"crawling", "handstanding", "jumping", "forward_rolling", "backward_rolling", "turning"}) {
    for (const Profile& profile : kProfiles) {
      if (!profile.IsBuilt()) continue;
      const bool slow = profile.solver == SolverKind::kOde;
      const int episodes = slow ? 5 : 20;
      benchmark::RegisterBenchmark(fmt::format("Train/{}/{}", task, profile.name).c_str(), Train,
                                   std::string(task), std::string(profile.name), episodes)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond)
          ->Iterations(1);
    }
  }
}

}  // namespace
}  // namespace runtime

int main(int argc, char** argv) {
  runtime::RegisterTraining();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
