// What environments are made of, what they say of themselves, and what they look like.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstddef>

#include "tests/libtaskc_sim/opened_sim.h"

namespace libtaskc_sim {
namespace {

using testing::HasSubstr;

TEST(Sim, SaysWhatItIs) {
  taskc_sim_options options = OptionsOf(CRAWLING, 3);
  options.threads = 8;
  const OpenedSim sim(options);
  const taskc_sim_description& about = sim.description();
  EXPECT_STREQ(about.task->name, "crawling");
  EXPECT_STREQ(about.robot, "humanoid");
  EXPECT_STREQ(about.profile, "fast-tree");
  EXPECT_EQ(about.time_step, 0.005);
  EXPECT_EQ(about.decision_time, 8 * 0.005);
  EXPECT_EQ(about.count, 3U);
  EXPECT_EQ(about.threads, 3U);
  EXPECT_EQ(about.action_size, 5U);
  taskc_uint32 size = 0;
  for (taskc_uint32 i = 0; i < about.observation_count; ++i) size += about.observations[i].size;
  EXPECT_EQ(about.observation_size, size);
  EXPECT_STREQ(about.observations[0].name, "height");
  EXPECT_STREQ(about.observations[0].unit, "m");
  EXPECT_EQ(taskc_sim_abi_version(), TASKC_ABI_VERSION);
}

// What stands beside the task for its agents counts, wherever the plugin is.
TEST(Sim, TheTasksFileBringsItsAgents) {
  taskc_sim_options options = OptionsOf(CRAWLING);
  options.task = TASKS "/turning.task";  // all joints by themselves
  EXPECT_EQ(OpenedSim(options).description().action_size, 17U);
}

TEST(Sim, AnOlderCallerGetsDefaultsForTheRest) {
  taskc_sim_options options;
  taskc_sim_defaults(&options, offsetof(taskc_sim_options, profile));
  EXPECT_EQ(options.struct_size, offsetof(taskc_sim_options, profile));
  options.plugin = CRAWLING;
  options.count = 1'000'000;  // what it does not know of is not looked at
  const OpenedSim sim(options);
  EXPECT_EQ(sim.description().count, 1U);
}

std::string Refusal(const taskc_sim_options& options, taskc_status expected) {
  taskc_sim* sim = nullptr;
  EXPECT_EQ(taskc_sim_new(&options, &sim), expected);
  EXPECT_EQ(sim, nullptr);
  return taskc_sim_error();
}

TEST(Sim, RefusesWhatIsNotThere) {
  taskc_sim_options options = OptionsOf("nowhere.so");
  EXPECT_THAT(Refusal(options, TASKC_ERROR_READ), HasSubstr("nowhere.so"));
  options = OptionsOf(CRAWLING);
  options.profile = "fats";
  EXPECT_THAT(Refusal(options, TASKC_SIM_ERROR_SETUP), HasSubstr("fats"));
  options = OptionsOf(CRAWLING);
  options.agent = "pro";
  EXPECT_THAT(Refusal(options, TASKC_SIM_ERROR_SETUP), HasSubstr("did you mean `ppo`?"));
  options.agent = "paper";
  EXPECT_THAT(Refusal(options, TASKC_SIM_ERROR_SETUP), HasSubstr("nobody else can decide"));
  options = OptionsOf(SWAYING);
  options.robot = "humanoit";
  EXPECT_THAT(Refusal(options, TASKC_SIM_ERROR_SETUP), HasSubstr("did you mean `humanoid`?"));
  options = OptionsOf(CRAWLING, 0);
  EXPECT_THAT(Refusal(options, TASKC_ERROR_OUT_OF_RANGE), HasSubstr("`count` is 0"));
  options = OptionsOf(nullptr);
  EXPECT_THAT(Refusal(options, TASKC_ERROR_NULL), HasSubstr("`plugin` is null"));
  const char* const settings[] = {"action_space.hlod=4"};
  options = OptionsOf(CRAWLING);
  options.settings = settings;
  options.setting_count = 1;
  EXPECT_THAT(Refusal(options, TASKC_SIM_ERROR_SETUP), HasSubstr("hold"));
}

TEST(Sim, IsResetFirst) {
  OpenedSim sim(OptionsOf(CRAWLING));
  EXPECT_EQ(sim.TryStep(), TASKC_ERROR_WRONG_ORDER);
  taskc_sim_episode episode;
  EXPECT_EQ(taskc_sim_last_episode(sim.get(), 0, &episode), TASKC_ERROR_WRONG_ORDER);
  EXPECT_EQ(taskc_sim_last_episode(sim.get(), 1, &episode), TASKC_ERROR_OUT_OF_RANGE);
  std::vector<unsigned char> rgb(size_t{64} * 64 * 3);
  EXPECT_EQ(taskc_sim_render(sim.get(), 0, 64, rgb.data()), TASKC_ERROR_WRONG_ORDER);
}

class Picture {
 public:
  static constexpr int kSize = 64;

  explicit Picture(const OpenedSim& sim) : rgb_(size_t{kSize} * kSize * 3) {
    EXPECT_EQ(taskc_sim_render(sim.get(), 0, kSize, rgb_.data()), TASKC_OK) << taskc_sim_error();
  }
  // Links are blue or orange, all else is gray.
  bool IsRobot(int x, int y) const {
    const unsigned char* pixel = &rgb_[size_t(3 * (y * kSize + x))];
    const auto [low, high] = std::minmax({pixel[0], pixel[1], pixel[2]});
    return high - low > 40;
  }
  // Its columns, from left to right.
  std::pair<int, int> Columns() const {
    std::pair<int, int> columns = {kSize, -1};
    for (int x = 0; x < kSize; ++x) {
      for (int y = 0; y < kSize; ++y) {
        if (IsRobot(x, y)) columns = {std::min(columns.first, x), std::max(columns.second, x)};
      }
    }
    return columns;
  }
  bool operator==(const Picture&) const = default;

 private:
  std::vector<unsigned char> rgb_;
};

TEST(Sim, ShowsTheWholeRobot) {
  OpenedSim sim(OptionsOf(CRAWLING));
  sim.Reset({1});
  const Picture first(sim);
  for (int i = 0; i < 50; ++i) sim.Step();
  const Picture later(sim);
  for (const Picture& picture : {first, later}) {
    const auto [left, right] = picture.Columns();
    EXPECT_GT(left, 0);
    EXPECT_LT(right, Picture::kSize - 1);
    EXPECT_GT(right - left, Picture::kSize / 8);
  }
  EXPECT_FALSE(later == first);
  EXPECT_EQ(taskc_sim_render(sim.get(), 0, 8, nullptr), TASKC_ERROR_NULL);
  unsigned char pixel = 0;
  EXPECT_EQ(taskc_sim_render(sim.get(), 0, 8, &pixel), TASKC_ERROR_OUT_OF_RANGE);
}

}  // namespace
}  // namespace libtaskc_sim
