#include "runtime/live/control/task_loader.h"

#include <gmock/gmock.h>

#include <fstream>
#include <future>

#include "runtime/training/run/run_files.h"
#include "tests/runtime/live/control/small_agent.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class TaskLoaderTest : public testing::Test {
 protected:
  LoadedTask Load(const std::filesystem::path& file) {
    std::promise<LoadedTask> promise;
    loader_.Load(file, [&](LoadedTask task) { promise.set_value(std::move(task)); });
    return promise.get_future().get();
  }
  size_t KeptFiles() const {
    return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(run_.path()), {}));
  }

  TemporaryFolder run_, elsewhere_;
  TaskLoader loader_{run_.path(), {}};
};

TEST_F(TaskLoaderTest, KeepsAPluginInTheFolderOfTheRun) {
  const LoadedTask task = Load(PluginFile("steady"));
  ASSERT_NE(task.plugin, nullptr);
  EXPECT_STREQ(task.plugin->table().name, "steady");
  EXPECT_EQ(task.messages, "");
  EXPECT_TRUE(std::filesystem::exists(FindKeptPlugin(run_.path(), task.kept)));
  EXPECT_EQ(Load(PluginFile("steady")).kept, task.kept);
  EXPECT_EQ(KeptFiles(), 1u);
}

TEST_F(TaskLoaderTest, SaysWhatIsWrongAndKeepsNothing) {
  EXPECT_EQ(Load("/nowhere/none.task").messages, "/nowhere/none.task: there is no such file");
  const std::filesystem::path half = elsewhere_.path() / "half.so";
  std::ofstream(half) << "\x7f"
                         "ELF";
  const LoadedTask task = Load(half);
  EXPECT_EQ(task.plugin, nullptr);
  EXPECT_THAT(task.messages, HasSubstr(half.string()));
  EXPECT_EQ(Load(elsewhere_.path()).plugin, nullptr);  // a folder
  EXPECT_EQ(KeptFiles(), 0u);
}

// The compiler is to lie beside the program, and here it does not.
TEST_F(TaskLoaderTest, WithoutACompilerOnlyPluginsCanBeLoaded) {
  const std::filesystem::path source = elsewhere_.path() / "some.task";
  std::ofstream(source) << "task some for humanoid\n";
  EXPECT_THAT(Load(source).messages, AllOf(HasSubstr("taskc: cannot run the compiler"),
                                           HasSubstr("give a plugin that is built already")));
  EXPECT_EQ(KeptFiles(), 0u);
}

TEST(TaskLoader, AnswersInTheOrderOfTheRequestsAlsoWhereItEnds) {
  TemporaryFolder run;
  std::vector<std::string> answers;
  std::promise<void> has_begun, may_go_on;
  {
    TaskLoader loader(run.path(), {});
    loader.Load(PluginFile("steady"), [&](LoadedTask task) {
      answers.push_back(task.plugin->table().name);
      has_begun.set_value();
      may_go_on.get_future().wait();
    });
    for (int i = 0; i < 2; ++i) {
      loader.Load(PluginFile("other"), [&](LoadedTask task) {
        EXPECT_EQ(task.plugin, nullptr);
        answers.push_back(task.messages);
      });
    }
    has_begun.get_future().wait();
    // The loader ends while the first is being answered and the others still wait.
    std::thread([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      may_go_on.set_value();
    }).detach();
  }
  EXPECT_THAT(answers, ElementsAre("steady", "the trainer has ended", "the trainer has ended"));
}

}  // namespace
}  // namespace runtime
