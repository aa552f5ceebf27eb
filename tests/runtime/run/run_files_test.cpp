#include "runtime/run/run_files.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/runtime/run/error_of.h"
#include "tests/runtime/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(RunFiles, NamesAPluginByItsContent) {
  const TemporaryFolder parent;
  std::ofstream(parent.path() / "a.so") << "abc";
  const std::filesystem::path folder = parent.path() / "runs" / "run";
  const std::string name = KeepPlugin(parent.path() / "a.so", folder);
  EXPECT_EQ(name, "plugin-ba7816bf8f01cfea.so");  // SHA-256 of "abc", FIPS 180-2
  EXPECT_EQ(ReadText(FindKeptPlugin(folder, name)), "abc");
}

TEST(RunFiles, RefuseAPluginThatIsGoneOrChanged) {
  const TemporaryFolder parent;
  std::ofstream(parent.path() / "a.so") << "abc";
  const std::string name = KeepPlugin(parent.path() / "a.so", parent.path());
  std::ofstream(parent.path() / name, std::ios::app) << "d";
  EXPECT_THAT(ErrorOf([&] { FindKeptPlugin(parent.path(), name); }),
              AllOf(HasSubstr(name), HasSubstr("was changed")));
  std::filesystem::remove(parent.path() / name);
  EXPECT_THAT(ErrorOf([&] { FindKeptPlugin(parent.path(), name); }),
              AllOf(HasSubstr(name), HasSubstr("is gone"), HasSubstr("trainer train")));
}

TEST(RunFiles, SayWhatCannotBeReadOrWritten) {
  const TemporaryFolder parent;
  EXPECT_THAT(ErrorOf([&] { KeepPlugin(parent.path() / "none.so", parent.path()); }),
              AllOf(HasSubstr("none.so"), HasSubstr("No such file")));
  std::ofstream(parent.path() / "a.so") << "abc";
  EXPECT_THAT(ErrorOf([&] { KeepPlugin(parent.path() / "a.so", parent.path() / "a.so"); }),
              AllOf(HasSubstr("a.so/plugin-"), HasSubstr("cannot write")));
}

}  // namespace
}  // namespace runtime
