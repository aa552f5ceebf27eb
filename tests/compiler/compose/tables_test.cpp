// Where the files of tables are found, and which of them a task consists of.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compiler/check/check.h"
#include "tests/compiler/compose/file_set.h"

namespace compiler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kRead = "sensor x: real\non end_of_time_step { reward a = t(x) }\n";

struct Read {
  explicit Read(FileSet files) : composed(std::move(files)) {
    if (composed.tree) task = Check(*composed.tree, nullptr, composed.diagnostics);
    EXPECT_TRUE(task) << composed.Messages();
  }

  std::vector<std::string> Files() const {
    std::vector<std::string> files;
    for (const SourceFile& file : composed.sources.files()) files.push_back(file.path());
    return files;
  }
  const CheckedTable& Table() const { return task->tables.at(0); }

  Composed composed;
  std::optional<CheckedTask> task;
};

TEST(TableFiles, AreBesideTheFileThatNamesThem) {
  const Read read({{"main.task", "task a\nimport \"lib/curves.task\"\n" + kRead},
                   {"lib/curves.task", "table t: real = \"data/t.csv\"\n"},
                   {"lib/data/t.csv", "x, y\n0, 1\n1, 2\n"}});
  EXPECT_THAT(read.Files(), ElementsAre("main.task", "lib/curves.task", "lib/data/t.csv"));
  EXPECT_THAT(read.Table().elements, ElementsAre(1, 2));
}

TEST(TableFiles, OfABaseAreLeftOutWhereTheyAreOverridden) {
  const Read read(
      {{"main.task", "task b extends \"base/a.task\"\noverride table t = \"u.csv\"\n"},
       {"base/a.task", "task a\n/// Speeds.\ntable t: real = \"missing.csv\"\n" + kRead},
       {"u.csv", "x, y\n0, 3\n1, 4\n"}});
  EXPECT_THAT(read.Files(), ElementsAre("main.task", "base/a.task", "u.csv"));
  EXPECT_THAT(read.Table().elements, ElementsAre(3, 4));
  EXPECT_EQ(read.Table().doc, "Speeds.");
}

TEST(TableFiles, OfSeveralTablesAreReadOnce) {
  const Read read(
      {{"main.task",
        "task a\ntable t: real = \"a.csv\"\ntable v: vec2 [m] = \"./a.csv\"\nsensor x: real\n"
        "on end_of_time_step { reward a = t(x) + v(x).y / 1 m }\n"},
       {"a.csv", "s, v.x [m], t, v.y [cm]\n0, 1, 2, 3\n1, 4, 5, 6\n"}});
  EXPECT_THAT(read.Files(), ElementsAre("main.task", "a.csv"));
  EXPECT_THAT(read.task->tables.at(0).elements, ElementsAre(2, 5));
  EXPECT_THAT(read.task->tables.at(1).elements, ElementsAre(1, 0.03, 4, 0.06));
}

TEST(TableFiles, ArePartOfWhatATaskIsKnownBy) {
  const auto hash = [](const std::string& number) {
    return Read({{"main.task", "task a\ntable t: real = \"t.csv\"\n" + kRead},
                 {"t.csv", "x, y\n0, 1\n1, " + number + "\n"}})
        .composed.sources.Hash();
  };
  EXPECT_EQ(hash("2"), hash("2"));
  EXPECT_NE(hash("2"), hash("3"));
}

TEST(TableFiles, MayBeLargeButNotTooLarge) {
  const auto messages = [](size_t rows, const std::string& cell) {
    std::string csv = "x, y\n";
    for (size_t i = 0; i < rows; ++i) csv += std::to_string(i) + "," + cell + "\n";
    const Composed composed({{"main.task", "task a\ntable t: real = \"t.csv\"\n"}, {"t.csv", csv}});
    return composed.Messages();
  };
  EXPECT_EQ(messages(50'000, "1"), "");
  EXPECT_THAT(messages(50'001, "1"),
              HasSubstr("error[E0670]: the table has more than 100000 numbers"));
  EXPECT_THAT(messages(20'000, std::string(60, '1')),
              HasSubstr("error[E0670]: the table is larger than 1000000 bytes"));
}

TEST(TableFiles, HaveAFewMessagesOnly) {
  std::string csv = "x, y\n";
  for (int i = 0; i < 1000; ++i) csv += "1, one\n";
  const Composed composed({{"main.task", "task a\ntable t: real = \"t.csv\"\n"}, {"t.csv", csv}});
  EXPECT_EQ(composed.diagnostics.list().size(), 5u);
}

}  // namespace
}  // namespace compiler
