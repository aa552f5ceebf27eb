#include "runtime/core/task/plugin.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "base/seal/seal.h"
#include "tests/runtime/core/task/test_plugins.h"

namespace runtime {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class PluginTest : public testing::Test {
 protected:
  PluginTest() {
    std::string name = testing::TempDir() + "plugin_test_XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~PluginTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path CopyOf(const std::string& plugin, const std::string& name) const {
    const std::filesystem::path copy = folder_ / name;
    std::filesystem::copy_file(PluginFile(plugin), copy,
                               std::filesystem::copy_options::overwrite_existing);
    return copy;
  }

  std::string MessageOfLoading(const std::filesystem::path& file) const {
    std::string message = MessageOf([&] { Plugin plugin(file); });
    const std::string folder = folder_.string() + "/";
    if (message.starts_with(folder)) message.erase(0, folder.size());
    return message;
  }

  std::filesystem::path folder_;
};

TEST_F(PluginTest, GivesTheTable) {
  const Plugin plugin(PluginFile("walking"));
  EXPECT_STREQ(plugin.table().name, "walking");
  EXPECT_EQ(plugin.table().sensor_count, 5u);
  EXPECT_EQ(plugin.name(), PluginFile("walking"));
}

TEST_F(PluginTest, FileRenamedOverALoadedOneGivesTheNewCode) {
  const std::filesystem::path file = CopyOf("walking", "task.so");
  const Plugin old_one(file);
  std::filesystem::rename(CopyOf("empty", "task.so.new"), file);
  const Plugin new_one(file);
  EXPECT_STREQ(old_one.table().name, "walking");
  EXPECT_STREQ(new_one.table().name, "test");
}

TEST_F(PluginTest, LoadedOneSurvivesThatItsFileIsOverwrittenInPlace) {
  const std::filesystem::path file = CopyOf("walking", "task.so");
  const Plugin plugin(file);
  std::ofstream(file, std::ios::trunc) << "gone";
  EXPECT_STREQ(plugin.table().metrics[2].name, "highest");
  taskc_int64 memory[8] = {};
  taskc_frame frame{};
  frame.memory = memory;
  plugin.table().initialize(&frame);
  EXPECT_EQ(memory[1], 100);
}

TEST_F(PluginTest, WhatWasLoadedCanBeReadWhateverBecomesOfItsFile) {
  const auto bytes = [](const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  };
  const Plugin plugin(CopyOf("walking", "task.so"));
  CopyOf("strolling", "task.so");
  EXPECT_TRUE(bytes(plugin.copy()) == bytes(PluginFile("walking")));
}

TEST_F(PluginTest, CanBeLoadedAndUnloadedManyTimes) {
  for (int round = 0; round < 200; ++round) {
    const char* name = round % 2 == 0 ? "walking" : "empty";
    const Plugin plugin(PluginFile(name));
    ASSERT_STREQ(plugin.table().name, round % 2 == 0 ? "walking" : "test");
  }
}

TEST_F(PluginTest, LibraryThatStaysLoadedIsNotMistakenForTheNextOne) {
  { const Plugin plugin(PluginFile("stays_loaded")); }
  const Plugin next(PluginFile("empty"));
  EXPECT_STREQ(next.table().name, "test");
}

TEST_F(PluginTest, LeavesNoDescriptorOpen) {
  const auto count = [] {
    const std::filesystem::directory_iterator open_files("/proc/self/fd");
    return std::distance(begin(open_files), end(open_files));
  };
  const auto before = count();
  { const Plugin plugin(PluginFile("walking")); }
  EXPECT_THROW(Plugin(PluginFile("other_abi")), UserError);
  EXPECT_THROW(Plugin(PluginFile("unresolved")), UserError);
  EXPECT_EQ(count(), before);
}

TEST_F(PluginTest, EveryCutIsRefused) {
  const std::filesystem::path file = CopyOf("walking", "cut.so");
  for (auto size = std::filesystem::file_size(file); size-- > 0;) {
    std::filesystem::resize_file(file, size);
    ASSERT_THROW(Plugin{file}, UserError) << "cut at " << size;
  }
}

TEST_F(PluginTest, FileThatDoesNotFitItsSealIsRefused) {
  const std::filesystem::path file = CopyOf("walking", "changed.so");
  std::ofstream(file, std::ios::app) << "\ntaskc sha-256 " << std::string(64, '0');
  EXPECT_EQ(MessageOfLoading(file),
            "changed.so: is damaged: it has changed since it was built; build the task with `taskc "
            "build`");
}

// The code of `runs_on_load` would end this process.
TEST_F(PluginTest, CodeWithoutASealIsNotRun) {
  const std::filesystem::path file = CopyOf("runs_on_load", "unsealed.so");
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - seal::kSize);
  EXPECT_EQ(MessageOfLoading(file),
            "unsealed.so: has no seal: taskc has not built it, and its code is not run; build the "
            "task with `taskc build`, or, if you trust it, seal it with `taskc seal`");
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
  EXPECT_THROW(Plugin{file}, UserError);
  EXPECT_EXIT(Plugin(PluginFile("runs_on_load")), testing::ExitedWithCode(7), "");
}

TEST_F(PluginTest, MissingFileIsRefused) {
  EXPECT_EQ(MessageOfLoading(folder_ / "nowhere.so"),
            "nowhere.so: cannot be read: No such file or directory");
}

TEST_F(PluginTest, WhatIsNoFileIsRefused) {
  std::filesystem::create_directory(folder_ / "folder.so");
  EXPECT_EQ(MessageOfLoading(folder_ / "folder.so"),
            "folder.so: cannot be read: it is a folder; name a regular file");
  ASSERT_EQ(mkfifo((folder_ / "pipe.so").c_str(), 0600), 0);
  EXPECT_EQ(MessageOfLoading(folder_ / "pipe.so"),
            "pipe.so: cannot be read: it is a named pipe; name a regular file");
}

TEST_F(PluginTest, WhatIsNoSharedObjectIsRefused) {
  std::ofstream(folder_ / "text.so") << "task crawling for humanoid\n";
  EXPECT_EQ(MessageOfLoading(folder_ / "text.so"),
            "text.so: is not a shared object; build the task with `taskc build`");
  std::ofstream(folder_ / "empty.so");
  EXPECT_EQ(MessageOfLoading(folder_ / "empty.so"),
            "empty.so: is not a shared object; build the task with `taskc build`");
}

TEST_F(PluginTest, GiantFileIsRefusedUnread) {
  std::ofstream(folder_ / "giant.so");
  std::filesystem::resize_file(folder_ / "giant.so", uintmax_t{1} << 40);
  EXPECT_EQ(MessageOfLoading(folder_ / "giant.so"), "giant.so: is too large for a compiled task");
}

TEST_F(PluginTest, WhatTheLoaderRefusesIsRefused) {
  const std::string message = MessageOfLoading(PluginFile("unresolved"));
  EXPECT_THAT(message, StartsWith("unresolved.so: cannot be loaded: "));
  EXPECT_THAT(message, HasSubstr("defined_nowhere"));
}

TEST_F(PluginTest, LibraryWithoutTheEntryIsRefused) {
  EXPECT_EQ(
      MessageOfLoading(PluginFile("no_entry")),
      "no_entry.so: is not a compiled task: it does not export `taskc_plugin_get`; build the task "
      "with `taskc build`");
}

TEST_F(PluginTest, TableOfAnotherSizeIsRefused) {
  const std::string size = std::to_string(sizeof(taskc_plugin));
  const std::string other_size = std::to_string(sizeof(taskc_plugin) - 8);
  EXPECT_EQ(MessageOfLoading(PluginFile("other_size")),
            "other_size.so: its table is damaged: it has " + other_size + " bytes, and ABI 5 has " +
                size + "; build it again with `taskc build`");
}

struct BadTable {
  const char* plugin;
  const char* message;
};

void PrintTo(const BadTable& table, std::ostream* out) { *out << table.plugin; }

class BadTableTest : public testing::TestWithParam<BadTable> {};

TEST_P(BadTableTest, IsRefused) {
  const BadTable& bad = GetParam();
  EXPECT_EQ(MessageOf([&] { Plugin plugin(PluginFile(bad.plugin)); }),
            std::string(bad.plugin) + ".so: " + bad.message);
}

#define DAMAGED(what) "its table is damaged: " what "; build it again with `taskc build`"

INSTANTIATE_TEST_SUITE_P(
    Plugin, BadTableTest,
    testing::Values(
        BadTable{"gives_null", "returns no table; build it again with `taskc build`"},
        BadTable{"other_abi",
                 "built for ABI 6, but this program needs 5: build it again with `taskc build`"},
        BadTable{"previous_abi",
                 "built for ABI 4, but this program needs 5: build it again with `taskc build`"},
        BadTable{"null_text", DAMAGED("one of its strings is null")},
        BadTable{"null_source", DAMAGED("a source has no name or text")},
        BadTable{"no_source", DAMAGED("it has no source")},
        BadTable{"unknown_place", DAMAGED("the reward term `fall` is in source 2 of 1")},
        BadTable{"null_table", DAMAGED("it has 3 sensors, at null")},
        BadTable{"huge_count", DAMAGED("it claims 4000000000 metrics")},
        BadTable{"null_name", DAMAGED("a reward term has no name")},
        BadTable{"same_name", DAMAGED("there are two reward terms `fall`")},
        BadTable{"param_out_of_range", DAMAGED("the param `gain` is 5, not within 0 .. 4")},
        BadTable{"param_not_finite", DAMAGED("the param `gain` is nan, not within -inf .. inf")},
        BadTable{"fractional_int_param", DAMAGED("the param `count` is 2.5, not an integer")},
        BadTable{"memory_outside", DAMAGED("the variable `sums` lies outside the memory")},
        BadTable{"memory_not_initialized", DAMAGED("nothing initializes its memory")},
        BadTable{"unknown_scalar", DAMAGED("`time` has an unknown scalar type")},
        BadTable{"unknown_reader", DAMAGED("the sensor `time` is read by unknown events")},
        BadTable{"unknown_reduction", DAMAGED("the metric `height` has an unknown reduction")},
        BadTable{"metrics_not_measured", DAMAGED("nothing measures its metrics")},
        BadTable{"log_without_unit", DAMAGED("the log `speed` has no text or unit")},
        BadTable{"log_of_unknown_reduction", DAMAGED("the log `speed` has an unknown reduction")},
        BadTable{"same_log", DAMAGED("there are two logs `speed`")},
        BadTable{"null_requirement", DAMAGED("a requirement has no reason")},
        BadTable{"misplaced_requirement",
                 DAMAGED("the requirement `it stands` is in source 8 of 1")},
        BadTable{"unknown_end", DAMAGED("the end `over` is of an unknown kind")}),
    [](const auto& bad) { return std::string(bad.param.plugin); });

}  // namespace
}  // namespace runtime
