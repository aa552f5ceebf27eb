#include "runtime/training/run/run_files.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// The superuser may write everywhere.
class AsNobody {
 public:
  AsNobody() {
    if (is_superuser_) Become(65534);
  }
  ~AsNobody() {
    if (is_superuser_) Become(0);
  }

 private:
  static void Become(uid_t user) { EXPECT_EQ(seteuid(user), 0); }

  const bool is_superuser_ = geteuid() == 0;
};

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
              AllOf(HasSubstr("a.so: cannot make this folder"), HasSubstr("--out")));
  std::filesystem::create_directory(parent.path() / "ro");
  std::filesystem::permissions(parent.path() / "ro", std::filesystem::perms::owner_read |
                                                         std::filesystem::perms::owner_exec);
  const AsNobody nobody;
  EXPECT_THAT(
      ErrorOf([&] { MakeRunFolder(parent.path() / "ro" / "x"); }),
      AllOf(HasSubstr("ro/x: cannot make this folder: Permission denied"), HasSubstr("--out")));
}

}  // namespace
}  // namespace runtime
