#include <gmock/gmock.h>
#include <taskc/host.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "tests/libtaskc/opened_task.h"

namespace libtaskc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::string HandWritten(const std::string& name) {
  return std::string(HAND_WRITTEN) + "/" + name + ".so";
}

struct Refusal {
  std::string file;
  taskc_status status;
  std::string message;
};

TEST(Open, RefusesWhatTheTrainerRefusesWithACodeForEachKind) {
  const std::string text = testing::TempDir() + "libtaskc_text.so";
  std::ofstream(text) << "task each\n";
  const std::string cut = testing::TempDir() + "libtaskc_cut.so";
  std::filesystem::copy_file(PluginFile("each"), cut,
                             std::filesystem::copy_options::overwrite_existing);
  std::filesystem::resize_file(cut, std::filesystem::file_size(cut) - 1);
  const Refusal refusals[] = {
      {"/nowhere.so", TASKC_ERROR_READ, "cannot be read: No such file or directory"},
      {text, TASKC_ERROR_NOT_A_TASK, "is not a shared object; build the task with `taskc build`"},
      {HandWritten("no_entry"), TASKC_ERROR_NOT_A_TASK, "does not export `taskc_plugin_get`"},
      {cut, TASKC_ERROR_UNSEALED, "has no seal"},
      {HandWritten("null_table"), TASKC_ERROR_DAMAGED, "its table is damaged"},
      {HandWritten("previous_abi"), TASKC_ERROR_OTHER_ABI,
       "built for ABI 4, but this program needs 5: build it again with `taskc build`"}};
  for (const Refusal& refusal : refusals) {
    taskc_task* task = nullptr;
    EXPECT_EQ(taskc_open(refusal.file.c_str(), &task), refusal.status) << refusal.file;
    EXPECT_EQ(task, nullptr);
    EXPECT_THAT(taskc_error(), HasSubstr(refusal.message));
  }
}

TEST(Open, EachThreadHasItsOwnMessage) {
  taskc_task* task = nullptr;
  EXPECT_EQ(taskc_open(nullptr, &task), TASKC_ERROR_NULL);
  EXPECT_STREQ(taskc_error(), "the name of the file is null");
  std::string other = "unset";
  std::thread([&] { other = taskc_error(); }).join();
  EXPECT_EQ(other, "");
}

TEST(Describe, SaysWhatTheTaskReadsPaysAndMeasures) {
  const OpenedTask task("each");
  const taskc_plugin& table = task.table();
  ASSERT_EQ(table.sensor_count, 4u);
  EXPECT_STREQ(table.sensors[0].name, "place");
  EXPECT_STREQ(table.sensors[0].doc, "Where it is.");
  EXPECT_STREQ(table.sensors[0].unit, "m");
  EXPECT_EQ(table.sensors[0].rows, 3u);
  EXPECT_EQ(table.sensors[0].maximum, 10);
  EXPECT_EQ(table.link_count, 0u);
  EXPECT_EQ(taskc_abi_version(), TASKC_ABI_VERSION);
}

TEST(Describe, NamesLinksAndJointsOfTheRobot) {
  const OpenedTask task("crawling");
  const taskc_plugin& table = task.table();
  ASSERT_EQ(table.link_count, 18u);
  EXPECT_STREQ(table.links[0].name, "body");
  ASSERT_EQ(table.joint_count, 17u);
  EXPECT_STREQ(table.joints[0].name, "neck_yaw");
  EXPECT_THAT(table.sensors[2].doc, HasSubstr("world frame"));
}

TEST(Close, LeavesInstancesAlone) {
  taskc_task* task = nullptr;
  ASSERT_EQ(taskc_open(PluginFile("each").c_str(), &task), TASKC_OK);
  taskc_instance* instance = nullptr;
  ASSERT_EQ(taskc_new_instance(task, &instance), TASKC_OK);
  taskc_close(task);
  World world;
  Bind(instance, world);
  EXPECT_EQ(taskc_start_episode(instance, 1, nullptr), TASKC_OK);
  taskc_delete_instance(instance);
  taskc_close(nullptr);
  taskc_delete_instance(nullptr);
}

// Each thread with an instance of its own.
TEST(Instances, RunSideBySide) {
  const OpenedTask task("each");
  std::vector<double> returns(4);
  std::vector<std::thread> threads;
  for (size_t i = 0; i < returns.size(); ++i) {
    threads.emplace_back([&, i] {
      const Instance instance(task);
      World world;
      Bind(instance, world);
      world.place[0] = static_cast<double>(i);
      taskc_start_episode(instance, 1, nullptr);
      for (int step = 0; step < 1000; ++step)
        taskc_event(instance, TASKC_END_OF_TIME_STEP, 0.5, nullptr);
      returns[i] = taskc_return(instance);
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(returns, ElementsAre(0, 1000, 2000, 3000));
}

}  // namespace
}  // namespace libtaskc
