#include "runtime/training/learning/kept_spheres.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/runtime/training/learning/test_robot.h"
#include "tests/runtime/training/run/temporary_folder.h"
#include "tests/scoped_environment.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

class KeptSpheresTest : public testing::Test {
 protected:
  // The files of the cache.
  std::vector<fs::path> Files() const {
    std::vector<fs::path> files;
    if (!fs::exists(cache_)) return files;
    for (const auto& entry : fs::directory_iterator(cache_)) files.push_back(entry.path());
    return files;
  }

  const robot::NetDescription& net_ = HumanoidNet("bq3dof60");
  const Spheres packed_ = PackSpheres(net_, 1);
  TemporaryFolder folder_;
  fs::path cache_ = folder_.path() / "cache" / "nets";
  ScopedEnvironment environment_{"TASKC_CACHE", cache_.parent_path().string()};
};

TEST_F(KeptSpheresTest, AreThePackedOnesBitForBit) {
  for (int time = 0; time < 2; ++time) {
    const Spheres spheres = KeptSpheres(net_, 1);
    EXPECT_EQ(spheres.centers, packed_.centers);
    EXPECT_EQ(spheres.radius, packed_.radius);
    EXPECT_EQ(Files().size(), 1);
  }
}

TEST_F(KeptSpheresTest, AreReadTheSecondTime) {
  KeptSpheres(net_, 1);
  const fs::path file = Files().at(0);
  KeptSpheres(net_, 2);
  for (const fs::path& other : Files()) {
    if (other != file) fs::copy_file(other, file, fs::copy_options::overwrite_existing);
  }
  EXPECT_EQ(KeptSpheres(net_, 1).centers, PackSpheres(net_, 2).centers);
}

TEST_F(KeptSpheresTest, OtherNetsAreOtherFiles) {
  robot::NetDescription wider = net_;
  wider.high[0] += 1e-9;
  KeptSpheres(net_, 1);
  KeptSpheres(net_, 2);
  KeptSpheres(wider, 1);
  EXPECT_EQ(Files().size(), 3);
}

TEST_F(KeptSpheresTest, DamageIsRepaired) {
  KeptSpheres(net_, 1);
  const fs::path file = Files().at(0);
  const auto size = fs::file_size(file);
  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(100).put('x');
  EXPECT_EQ(KeptSpheres(net_, 1).centers, packed_.centers);
  fs::resize_file(file, 50);
  EXPECT_EQ(KeptSpheres(net_, 1).centers, packed_.centers);
  EXPECT_EQ(fs::file_size(file), size);
}

TEST_F(KeptSpheresTest, ACacheThatCannotBeWrittenToDoesNotMatter) {
  fs::create_directories(cache_.parent_path());
  std::ofstream(cache_) << "not a folder";
  EXPECT_EQ(KeptSpheres(net_, 1).centers, packed_.centers);
}

// Whoever changes the packing must change kPackingVersion too, or the cache keeps the old spheres.
TEST_F(KeptSpheresTest, TheVersionBelongsToThePacking) {
  EXPECT_EQ(kPackingVersion, 1);
  EXPECT_NEAR(packed_.radius, 0.57139149053086957, 1e-12);
}

}  // namespace
}  // namespace runtime
