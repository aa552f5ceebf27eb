// Builds and loads tasks beside the thread that trains, one after the other.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <variant>

#include "runtime/base/scratch_folder.h"
#include "runtime/core/task/plugin.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

struct LoadedTask {
  std::shared_ptr<const Plugin> plugin;  // null where something was wrong
  std::string kept;                      // name of the plugin's file in the run's folder
  std::string messages;  // what was wrong, or what the compiler said of a task that it has built
};

// A plugin that nobody has loaded yet.
struct BuiltPlugin {
  std::filesystem::path plugin;  // empty where something was wrong; there until the next is built
  std::string messages;          // as of a LoadedTask
};

class TaskLoader {
 public:
  using Handler = std::function<void(LoadedTask)>;
  using BuiltHandler = std::function<void(const BuiltPlugin&)>;

  // Plugins are kept in `run_folder` (runtime/training/run/run_files.h). Tasks are built for the
  // run's robot as its record has it, wherever the robot's own folder has gone.
  TaskLoader(std::filesystem::path run_folder, const RunRecord& run);
  TaskLoader(const TaskLoader&) = delete;
  TaskLoader& operator=(const TaskLoader&) = delete;
  // Kills the compiler where it is running; the handlers of what is not loaded are called with an
  // error.
  ~TaskLoader();

  // Any thread; returns at once. `file`: a .task file, which is built first, or a plugin. `handler`
  // is called on the loader's thread.
  // `text`: what is built in the place of what the .task file holds; the file need not be there.
  void Load(std::filesystem::path file, Handler handler,
            std::optional<std::string> text = std::nullopt);

  // The same up to where it would be loaded.
  void BuildOnly(std::filesystem::path file, BuiltHandler handler,
                 std::optional<std::string> text = std::nullopt);

  // Stops what a handler waits for, as the loader ends.
  std::stop_token stop_token() const { return stop_.get_token(); }
  // A folder of robots with the run's own.
  const std::filesystem::path& robots_folder() const { return scratch_.path(); }

 private:
  struct Job {
    std::filesystem::path file;
    std::optional<std::string> text;
    std::variant<Handler, BuiltHandler> handler;
  };

  void Run();
  void Add(Job job);
  void Do(const Job& job);
  static void Refuse(const Job& job, const std::string& why);
  BuiltPlugin Build(const Job& job);
  LoadedTask Load(const Job& job, BuiltPlugin built);
  std::filesystem::path BroughtIn(const std::filesystem::path& plugin) const;
  LoadedTask Keep(const std::filesystem::path& plugin, const std::filesystem::path& name);

  const std::filesystem::path run_folder_;
  ScratchFolder scratch_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Job> jobs_;
  bool is_ending_ = false;
  std::stop_source stop_;  // of the compiler
  std::thread thread_;
};

}  // namespace runtime
