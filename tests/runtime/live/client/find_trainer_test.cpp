#include "runtime/live/client/find_trainer.h"

#include <gmock/gmock.h>

#include <fstream>

#include "runtime/live/server/control_socket.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A folder in which somebody listens, for as long as this object lives.
class ListeningRun {
 public:
  explicit ListeningRun(const std::filesystem::path& path)
      : folder_(MadeFolder(path)), socket_(folder_, path) {}

 private:
  static Descriptor MadeFolder(const std::filesystem::path& path) {
    std::filesystem::create_directories(path);
    std::ofstream(path / "run.db") << "of a run";
    return OpenRunFolder(path);
  }

  Descriptor folder_;
  ControlSocket socket_;
};

TEST(FindTrainer, TakesTheOnlyOneHoweverDeep) {
  const TemporaryFolder root;
  std::filesystem::create_directories(root.path() / "finished");
  const ListeningRun run(root.path() / "study" / "crawling-fast" / "seed1");
  EXPECT_EQ(FindTrainer(root.path()), root.path() / "study" / "crawling-fast" / "seed1");
}

TEST(FindTrainer, PassesOverWhoServesAFolderOfRuns) {
  const TemporaryFolder root;
  const ListeningRun many(root.path());
  std::filesystem::remove(root.path() / "run.db");
  const ListeningRun run(root.path() / "seed1");
  EXPECT_EQ(FindTrainer(root.path()), root.path() / "seed1");
}

TEST(FindTrainer, NamesThemAllWhereThereAreSeveral) {
  const TemporaryFolder root;
  const ListeningRun second(root.path() / "many" / "seed2");
  const ListeningRun first(root.path() / "many" / "seed1");
  EXPECT_THAT(ErrorOf([&] { FindTrainer(root.path()); }),
              AllOf(HasSubstr("several trainers are running"),
                    HasSubstr("seed1\n  --run " + (root.path() / "many" / "seed2").string())));
}

TEST(FindTrainer, KnowsWhichAnswer) {
  const TemporaryFolder root;
  // Nobody listens to a socket whose descriptor is closed.
  Descriptor folder = OpenRunFolder(root.path());
  ControlSocket left(folder, root.path());
  left.TakeListener();
  const std::string error = ErrorOf([&] { FindTrainer(root.path()); });
  EXPECT_THAT(error, AllOf(HasSubstr("no trainer is running"), HasSubstr("--run DIR")));
  const ListeningRun living(root.path() / "living");
  EXPECT_EQ(FindTrainer(root.path()), root.path() / "living");
}

TEST(FindTrainer, NeedsNoFolder) {
  EXPECT_THAT(ErrorOf([] { FindTrainer("/nowhere/at/all"); }), HasSubstr("no trainer is running"));
}

}  // namespace
}  // namespace runtime
