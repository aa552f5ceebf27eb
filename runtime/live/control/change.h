// A change of a running graph, as it is written down so that it can be repeated.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "runtime/live/control/live_graph.h"
#include "runtime/live/control/schedules.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// {"command": "swap", "name": "task", "task": 2, ...}: the request, with numbers of tasks
// (TaskRecord::id) in the place of files, and values in the place of texts.
class Change {
 public:
  explicit Change(nlohmann::json data) : data_(std::move(data)) {}

  const nlohmann::json& data() const { return data_; }
  std::string kind() const { return data_.at("command").get<std::string>(); }
  // The task that it brings into the graph; 0 for none.
  int64_t task() const { return data_.value("task", int64_t{0}); }
  std::string text(const std::string& name) const { return data_.at(name).get<std::string>(); }
  bool flag(const std::string& name) const { return data_.value(name, false); }

  // For a person: "swap task: crawling (a1b2c3d4)".
  std::string Description(const RunRecord& run) const;

 private:
  nlohmann::json data_;
};

// Does changes, the first time and again.
class ChangeMaker {
 public:
  // `folder`: of the run, with its plugins. All of these outlive this object.
  ChangeMaker(LiveGraph& graph, Schedules& schedules, const RunRecord& run,
              std::filesystem::path folder);

  // `episode`: the first one that a schedule sets. Throws UserError, and changes nothing then;
  // RecordError where a plugin that the run has kept cannot be loaded.
  void Do(const Change& change, int64_t episode);

 private:
  std::unique_ptr<TaskInstance> MakeInstance(int64_t task) const;
  std::shared_ptr<const Plugin> LoadKept(const TaskRecord& task) const;
  void Swap(const Change& change);
  void Rollback(const Change& change);
  void Promote(const Change& change);
  void Set(const Change& change, int64_t episode);
  void AddModule(const Change& change);
  // What was learned from other rewards.
  void SettleLearner(const Change& change, const UniversalTask& task);

  LiveGraph& graph_;
  Schedules& schedules_;
  const RunRecord& run_;
  const std::filesystem::path folder_;
};

}  // namespace runtime
