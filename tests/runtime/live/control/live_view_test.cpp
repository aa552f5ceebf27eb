// What those see who watch a run, and that they change nothing of it.
#include "runtime/live/control/live_view.h"

#include <cstring>

#include "tests/runtime/live/control/live_run_test.h"

namespace runtime {
namespace {

using testing::Contains;
using testing::SizeIs;

constexpr size_t kHeader = 7;  // doubles

double HeaderOf(const ViewFrame& frame, size_t index) {
  double number = 0;
  std::memcpy(&number, frame.content->data() + index * sizeof number, sizeof number);
  return number;
}

std::vector<float> NumbersOf(const ViewFrame& frame) {
  const size_t begin = kHeader * sizeof(double);
  std::vector<float> numbers((frame.content->size() - begin) / sizeof(float));
  std::memcpy(numbers.data(), frame.content->data() + begin, numbers.size() * sizeof(float));
  return numbers;
}

// Where the first number of a value lies in a frame.
size_t PlaceOf(const json& layout, const std::string& kind, const std::string& name) {
  size_t place = 3 + 8 * layout["links"].get<size_t>();
  for (const json& value : layout["values"]) {
    if (value["kind"] == kind && value["name"] == name) return place;
    place += value["size"].get<size_t>();
  }
  ADD_FAILURE() << "there is no " << kind << " " << name << " in " << layout.dump();
  return 0;
}

class LiveViewTest : public LiveRunTest {
 protected:
  std::vector<double> Returns(const ViewWish& wish) {
    Trainer& run = Begin(40);
    run.live().Watch(wish);
    run.Ask("resume");
    run.WaitFor("finished");
    frames_ = run.events.frames();
    run.Stop();
    std::vector<double> returns;
    for (const EpisodeRecord& each : run.database().ReadEpisodes()) {
      returns.push_back(each.active.episode_return);
    }
    std::filesystem::remove_all(folder_.path() / "run");
    return returns;
  }

  std::vector<ViewFrame> frames_;
};

TEST_F(LiveViewTest, NothingIsShownToNobody) {
  Returns({});
  EXPECT_THAT(frames_, SizeIs(0));
}

TEST_F(LiveViewTest, AnEpisodeIsShownFromItsStartToItsEnd) {
  const std::vector<double> returns = Returns({.episode = true});
  ASSERT_GT(frames_.size(), 0u);
  const ViewFrame& shown = frames_.front();
  const json layout = json::parse(*shown.layout);
  EXPECT_EQ(layout["module"], "task");
  EXPECT_EQ(HeaderOf(shown, 0), 1);
  EXPECT_EQ(HeaderOf(shown, 2), kStepsOfAnEpisode);
  // Every third step, the start and the end.
  EXPECT_EQ(HeaderOf(shown, 3), 1 + kStepsOfAnEpisode / 3);
  EXPECT_DOUBLE_EQ(HeaderOf(shown, 4), 0.03);
  EXPECT_EQ(HeaderOf(shown, 5), 1);
  const std::vector<float> numbers = NumbersOf(shown);
  const auto size = layout["size"].get<size_t>();
  ASSERT_EQ(numbers.size(), size * (1 + kStepsOfAnEpisode / 3));
  const float* last = &numbers[numbers.size() - size];
  EXPECT_FLOAT_EQ(last[0], 0.12F);
  const auto episode = static_cast<size_t>(HeaderOf(shown, 1));
  EXPECT_FLOAT_EQ(last[1], static_cast<float>(returns[episode - 1]));
}

TEST_F(LiveViewTest, WhoWatchesChangesNothing) {
  const std::vector<double> alone = Returns({});
  EXPECT_EQ(Returns({.instants = true, .episode = true}), alone);
  EXPECT_GT(frames_.size(), 1u);
}

TEST_F(LiveViewTest, WhoComesInAPauseSeesWhereItIs) {
  Trainer& run = Begin(100);
  run.Run(5, "step");
  run.live().Watch({.instants = true});
  while (run.events.frames().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const ViewFrame shown = run.events.frames().back();
  EXPECT_EQ(HeaderOf(shown, 0), 0);
  EXPECT_EQ(HeaderOf(shown, 1), 1);
  EXPECT_EQ(HeaderOf(shown, 2), 5);
  // The numbers are those of the API.
  const json list = run.Ask("list");
  const json layout = json::parse(*shown.layout);
  for (const auto& [name, sum] : list["tasks"][0]["terms"].items()) {
    EXPECT_FLOAT_EQ(NumbersOf(shown)[PlaceOf(layout, "term", name)], sum.get<float>()) << name;
  }
}

TEST_F(LiveViewTest, AnotherTaskHasAnotherLayout) {
  Trainer& run = Begin(100);
  run.live().Watch({.instants = true});
  run.Run(5, "step");
  while (run.events.frames().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const auto before = run.events.frames().back().layout;
  run.Ask("load", {{"file", PluginFile("other").string()}, {"name", "beside"}});
  while (run.events.frames().back().layout == before) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const json layout = json::parse(*run.events.frames().back().layout);
  std::vector<std::string> shadows;
  for (const json& value : layout["values"]) {
    if (value["kind"] == "shadow") shadows.push_back(value["name"]);
  }
  EXPECT_THAT(shadows, Contains("beside"));
}

}  // namespace
}  // namespace runtime
