// Tasks as a program writes them, with slips: what is wrong is asked for as JSON, its fixes are
// applied, and it is asked again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using Json = nlohmann::json;
using Texts = std::map<std::string, std::string>;  // of files, by their names

void Replace(std::string& text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// LINK, SET, POSE and ROBOT stand for what the robot has.
const std::vector<std::string> kTemplates = {
    R"(task NAME for ROBOT
start POSE
param fall_penalty: real = 2 in 0 .. 20
metric distance = base.position.x
on end_of_time_step {
  let speed = base.velocity.x
  reward rate forward = speed / 1 m/s
  if contact[LINK] and time > 0.1 s {
    reward fall = -fall_penalty
    end_episode failure "falls"
  }
  if time > 20 s { truncate_episode "time is up" }
}
)",
    R"(task NAME for ROBOT
start POSE
goal heading: real [rad] = uniform(-90 deg, 90 deg)
observe base.up
observe heading
observe joint.angle
on end_of_time_step {
  let speed = yaw(base.orientation) - heading
  reward rate facing = cos(speed)
  reward rate effort = -norm(joint.velocity) / 1000 rad/s
  if contact[LINK] and time > 0.1 s { end_episode failure "falls" }
  if time > 20 s { truncate_episode "time is up" }
}
)",
    R"(task NAME for ROBOT
start POSE
memory highest: real [m] = 0 m per episode
metric max height = base.position.z
on end_of_time_step {
  let speed = norm(base.velocity.xy)
  highest = max(highest, base.position.z)
  reward rate still = tolerance(speed, 0 m/s, 0.1 m/s, 1 m/s)
  if contact[LINK] and time > 0.1 s { end_episode failure "falls" }
  if any(contact[SET]) and highest > 1 m { end_episode success "has jumped" }
  if time > 20 s { truncate_episode "time is up" }
}
)"};

struct Slip {
  const char* right;
  const char* wrong;
  bool is_mended;  // by the one fix that it has
};
constexpr Slip kSlips[] = {{"let speed", "var speed", true},
                           {" and ", " && ", true},
                           {"time > 20 s", "tme > 20 s", true},
                           {"\"falls\"", "'falls'", true},
                           {"base.", "Base.", true},
                           {"reward rate", "reward rat", true},
                           {"on end_of_time_step", "on end_of_timestep", true},
                           {"contact[LINK]", "contact(LINK)", true},
                           {"failure \"falls\"", "\"falls\"", false},  // or success?
                           {"time > 20 s", "time > 20 kg", false}};

// What the robot has, as the compiler tells it.
Json SpecOf(const TaskcProcess& taskc) {
  return Json::parse(taskc.Run("spec --robot humanoid --json").out);
}

Texts WriteTasks(const Json& spec, bool with_slips = true) {
  const Json& links = spec["parts"][0];
  Texts tasks;
  for (size_t i = 0; i < kTemplates.size(); ++i) {
    for (size_t j = 0; j < std::size(kSlips); ++j) {
      const std::string name = "task_" + std::to_string(i) + "_" + std::to_string(j);
      std::string text = kTemplates[i];
      EXPECT_NE(text.find(kSlips[j].right), std::string::npos) << i << ", " << j;
      if (with_slips) Replace(text, kSlips[j].right, kSlips[j].wrong);
      Replace(text, "NAME", name);
      Replace(text, "ROBOT", spec["robot"]["name"]);
      Replace(text, "POSE", spec["robot"]["poses"][0]);
      Replace(text, "LINK", links["members"][0]);
      Replace(text, "SET", links["sets"].begin().key());
      tasks[name + ".task"] = text;
    }
  }
  return tasks;
}

Json Check(const TaskcProcess& taskc, const Texts& tasks) {
  std::string files;
  for (const auto& [name, text] : tasks) {
    taskc.Write(name, text);
    files += " " + name;
  }
  return Json::parse(taskc.Run("check --format json" + files).out);
}

// Each error's fix where it is the only one, from the last to the first, so that places stay right.
void ApplyFixes(const Json& report, Texts& tasks) {
  const Json& diagnostics = report["diagnostics"];
  for (auto found = diagnostics.rbegin(); found != diagnostics.rend(); ++found) {
    if (found->at("severity") != "error" || found->at("fixes").size() != 1) continue;
    const Json& fix = found->at("fixes")[0];
    const auto begin = fix["offset"].get<size_t>();
    tasks[fix["file"]].replace(begin, fix["end_offset"].get<size_t>() - begin,
                               fix["text"].get<std::string>());
  }
}

std::map<std::string, bool> IsRight(const Json& report) {
  std::map<std::string, bool> is_right;
  for (const Json& task : report["tasks"]) is_right[task["file"]] = task["ok"];
  return is_right;
}

TEST(WrittenTasks, AreRightWithoutTheirSlips) {
  TaskcProcess taskc;
  EXPECT_EQ(Check(taskc, WriteTasks(SpecOf(taskc), false))["errors"], 0);
}

TEST(WrittenTasks, AreMendedByTheFixesOfTheReport) {
  TaskcProcess taskc;
  Texts tasks = WriteTasks(SpecOf(taskc));
  ASSERT_EQ(tasks.size(), 30u);
  Json report = Check(taskc, tasks);
  for (const auto& [name, is_right] : IsRight(report)) EXPECT_FALSE(is_right) << name;
  ApplyFixes(report, tasks);
  report = Check(taskc, tasks);
  size_t count = 0;
  for (const auto& [name, is_right] : IsRight(report)) {
    const auto slip = static_cast<size_t>(name[name.find_last_of('_') + 1] - '0');
    EXPECT_EQ(is_right, kSlips[slip].is_mended) << tasks[name];
    if (is_right) ++count;
  }
  EXPECT_EQ(count, 24u);
}

TEST(WrittenTasks, AreMendedInTheSameWayByTheCompiler) {
  TaskcProcess taskc;
  Texts tasks = WriteTasks(SpecOf(taskc));
  ApplyFixes(Check(taskc, tasks), tasks);
  Check(taskc, WriteTasks(SpecOf(taskc)));
  EXPECT_EQ(taskc.Run("check --fix task_*.task >/dev/null").status, 1);
  for (const auto& [name, text] : tasks) EXPECT_EQ(ReadWholeFile(taskc.path(name)), text);
}

}  // namespace
}  // namespace compiler
