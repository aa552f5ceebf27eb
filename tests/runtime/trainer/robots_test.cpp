// Robots of a user's own: where they are found, and how they learn.
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/runtime/trainer/trainer_test.h"
#include "tests/scoped_environment.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class RobotsTest : public TrainerTest {
 protected:
  RobotsTest() {
    std::filesystem::create_directories(folder() / "tasks");
    std::ofstream(folder() / "tasks" / "hop.task")
        << "/// As high as it can.\ntask hop for hopper\nmetric max height = base.position.z\n"
           "on end_of_time_step {\n    reward rate up = base.position.z\n"
           "    if time > 0.3 s { truncate_episode \"time is up\" }\n}\n";
  }

  // Puts the robot there, in a folder of this name.
  void AddRobot(const std::filesystem::path& where, const std::string& name = "hopper") const {
    std::filesystem::create_directories(folder() / where / name);
    std::filesystem::copy_file(OTHER_ROBOTS "/hopper/robot.toml",
                               folder() / where / name / "robot.toml");
  }
  std::string Task() const { return (folder() / "tasks" / "hop.task").string(); }
  ProgramResult TrainHopper(std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"train", Task(),  "--profile",      "fast-tree", "--episodes",
                                      "2",     "--out", RunFolder("run"), "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return Trainer(words);
  }
  std::string Folder(const char* name) const { return (folder() / name).string(); }
};

TEST_F(RobotsTest, OneBesideTheTaskLearnsWithoutAnAgentFile) {
  AddRobot("tasks");
  const ProgramResult result = TrainHopper();
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_EQ(RunDatabase::OpenToRead(RunFolder("run")).ReadEpisodes().size(), 2u);
  EXPECT_THAT(Trainer({"agent", "show", Task()}).output,
              AllOf(HasSubstr("type = \"Ppo\""), HasSubstr("dof = \"all\"")));
}

TEST_F(RobotsTest, IsFoundInAGivenFolderAndInTheSearchPath) {
  EXPECT_THAT(TrainHopper().errors, HasSubstr("there is no robot `hopper`"));
  AddRobot("mine");
  const ProgramResult given = TrainHopper({"--robots", Folder("mine")});
  ASSERT_EQ(given.exit_status, 0) << given.errors;
  EXPECT_THAT(Trainer({"show", RunFolder("run")}).output, HasSubstr("--robots " + Folder("mine")));
  std::filesystem::remove_all(RunFolder("run"));
  const ScopedEnvironment robots("TASKC_ROBOT_PATH", Folder("mine"));
  EXPECT_EQ(TrainHopper().exit_status, 0);
}

TEST_F(RobotsTest, AFolderWithAnotherNameIsRefusedAsTheCompilerDoes) {
  AddRobot("tasks", "jumper");
  std::ofstream(folder() / "tasks" / "jump.task") << "task jump for jumper\n"
                                                     "on end_of_time_step {\n    if time > 1 s { "
                                                     "truncate_episode \"time is up\" }\n}\n";
  const ProgramResult trained = Trainer({"train", Folder("tasks/jump.task")});
  EXPECT_NE(trained.exit_status, 0);
  EXPECT_THAT(trained.errors, HasSubstr("the robot in the folder `jumper` is called `hopper`"));
}

TEST_F(RobotsTest, MotionSearchWorksForAnyRobot) {
  AddRobot("tasks");
  const ProgramResult result = TrainHopper({"--agent", "motion_search"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  const std::string agents =
      Trainer({"agent", "list", "--robots", Folder("tasks"), "--robot", "hopper"}).output;
  EXPECT_THAT(agents, AllOf(HasSubstr("motion_search"), HasSubstr("ppo"), HasSubstr("hopper")));
}

TEST_F(RobotsTest, AnAgentFileIncludesWhatComesWithTheTrainer) {
  AddRobot("tasks");
  const std::string agent = Folder("tasks/hopper/agent.toml");
  std::ofstream(agent) << "include = [\"ppo\"]\n[modules.action_space]\ndof = \"1\"\n";
  EXPECT_THAT(Trainer({"agent", "show", Task()}).output, HasSubstr("dof = \"1\""));
  std::ofstream(agent) << "include = [\"robots/humanoid/ppo.agent.toml\"]\n"
                          "[modules.action_space]\ndof = \"all\"\n";
  EXPECT_THAT(Trainer({"agent", "show", Task()}).output, HasSubstr("dof = \"all\""));
  std::ofstream(agent) << "include = [\"pppo\"]\n";
  EXPECT_THAT(Trainer({"agent", "show", Task()}).errors,
              AllOf(HasSubstr("agent.toml:1:12: there is no file `"),
                    HasSubstr("hopper/pppo.agent.toml`")));
}

// The hopper of the tests beside the tasks, changed so.
void Change(const std::filesystem::path& robot, const std::string& what, const std::string& to) {
  std::ifstream in(robot);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::ofstream(robot) << std::regex_replace(text, std::regex(what), to);
}

TEST_F(RobotsTest, ShowChecksARobotInEveryPose) {
  const ProgramResult result = Trainer({"robot", "show", "humanoid", "--profile", "fast-tree"});
  EXPECT_EQ(result.exit_status, 0) << result.errors;
  EXPECT_THAT(result.output,
              AllOf(HasSubstr("17 joints"), ContainsRegex("left_toe +left_foot +0.05 0 -0.01426"),
                    HasSubstr("pose standing, held for 1 s"), HasSubstr("stays: tilts by"),
                    HasSubstr("times real time"), Not(HasSubstr("warning"))));
}

TEST_F(RobotsTest, ShowPrintsJsonAndDrawsThePoses) {
  AddRobot("mine");
  const ProgramResult result =
      Trainer({"robot", "show", "hopper", "--robots", Folder("mine"), "--profile", "fast-tree",
               "--json", "-o", RunFolder("poses.png"), "--height", "24"});
  ASSERT_EQ(result.exit_status, 0) << result.errors;
  const nlohmann::json shown = nlohmann::json::parse(result.output);
  EXPECT_EQ(shown["name"], "hopper");
  EXPECT_EQ(shown["joints"][1]["name"], "knee");
  EXPECT_TRUE(shown["sites"].empty());
  EXPECT_EQ(shown["poses"][0]["profile"], "fast-tree");
  std::ifstream in(RunFolder("poses.png"), std::ios::binary);
  const std::string png{std::istreambuf_iterator<char>(in), {}};
  // Two poses, each at its start and its end.
  EXPECT_EQ(png.substr(0, 24),
            std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x60\0\0\0\x18", 24));
}

TEST_F(RobotsTest, ShowSaysWhatIsWrongSoDoesTheStartOfARun) {
  AddRobot("tasks");
  const std::filesystem::path robot = folder() / "tasks" / "hopper" / "robot.toml";
  Change(robot, "position = \\[0, 0, 0.23\\]", "position = [0, 0, 0.18]");
  const auto in_the_ground =
      AllOf(HasSubstr("warning: `shank` is 50 mm in the ground in pose `upright`"),
            HasSubstr("its z may be more by 0.05 m"));
  EXPECT_THAT(Trainer({"robot", "show", robot.string(), "--profile", "fast-tree"}).output,
              in_the_ground);
  EXPECT_THAT(TrainHopper().errors, in_the_ground);
}

TEST_F(RobotsTest, ShowFailsWhereTheSimulationDiverges) {
  AddRobot("mine");
  const std::filesystem::path robot = folder() / "mine" / "hopper" / "robot.toml";
  Change(robot, "position = \\[0, 0, 0.23\\]", "position = [0, 0, -0.8]");
  const ProgramResult result = Trainer({"robot", "show", robot.string(), "--profile", "fast-tree"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.output, AllOf(HasSubstr("diverges: "), HasSubstr("the simulation diverges")));
}

TEST_F(RobotsTest, ASoundRobotStartsWithoutAWord) {
  AddRobot("tasks");
  const ProgramResult result = TrainHopper();
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_THAT(result.errors, IsEmpty());
}

TEST_F(RobotsTest, ShowNamesRobotsThatThereAre) {
  const ProgramResult result = Trainer({"robot", "show", "humanoit"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("humanoid"));
}

constexpr const char* kUrdf = R"(<robot name="table">
<link name="top">
<inertial><mass value="2"/><inertia ixx="0.02" iyy="0.02" izz="0.03" ixy="0" ixz="0" iyz="0"/></inertial>
<collision><geometry><box size="0.4 0.3 0.1"/></geometry></collision></link>
</robot>)";

TEST_F(RobotsTest, AnImportedRobotIsReadyToLearn) {
  std::ofstream(folder() / "table.urdf") << kUrdf;
  const ProgramResult imported =
      Trainer({"robot", "import", Folder("table.urdf"), "--robots", Folder("tasks")});
  if (!HAS_MUJOCO) {
    EXPECT_EQ(imported.exit_status, 1);
    EXPECT_THAT(imported.errors, HasSubstr("install the package `libmujoco-dev`"));
    return;
  }
  ASSERT_EQ(imported.exit_status, 0) << imported.errors;
  EXPECT_THAT(imported.output, HasSubstr("tasks/table/robot.toml: the robot `table`"));
  EXPECT_THAT(imported.errors, HasSubstr("warning: "));
  const ProgramResult shown =
      Trainer({"robot", "show", "table", "--robots", Folder("tasks"), "--profile", "fast-tree"});
  EXPECT_EQ(shown.exit_status, 0) << shown.errors;
  EXPECT_THAT(shown.output, AllOf(HasSubstr("stays: "), Not(HasSubstr("warning"))));
  EXPECT_EQ(
      Trainer({"robot", "import", Folder("table.urdf"), "--robots", Folder("tasks")}).exit_status,
      1);  // is there already
  const ProgramResult as_json = Trainer({"robot", "import", Folder("table.urdf"), "--robots",
                                         Folder("tasks"), "--name", "other", "--json"});
  EXPECT_EQ(nlohmann::json::parse(as_json.output)["name"], "other");
}

}  // namespace
}  // namespace runtime
