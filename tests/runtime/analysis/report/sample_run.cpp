#include "tests/runtime/analysis/report/sample_run.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <span>

#include "runtime/training/run/body_json.h"
#include "runtime/training/run/compression.h"
#include "runtime/training/run/policy_evaluation.h"
#include "runtime/training/run/recorder.h"
#include "runtime/training/run/run_settings.h"
#include "tests/runtime/analysis/report/moving_humanoid.h"
#include "tests/runtime/analysis/report/sample_timeline.h"

namespace runtime {
namespace {

const robot::RobotDescription& Humanoid() {
  static const robot::RobotDescription robot =
      robot::ReadRobot(SOURCE_DIR "/plugins/humanoid/robot.toml");
  return robot;
}

std::string TextOf(const char* file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string CrawlingSource() { return TextOf(SOURCE_DIR "/tasks/crawling.task"); }

constexpr const char* kAgent = R"([modules.state]
type = "DofState"
dof = "5"

[modules.features]
type = "NgNet"
net = "bq01"

[modules.action_space]
type = "Dcob"
target = "angles"
intervals = [0.075, 0.1, 0.2]

[modules.learner]
type = "PengQLambda"
temperature = 5.0
)";

EpisodeRecord SampleEpisode(int64_t number, int64_t episodes, std::mt19937& random) {
  std::normal_distribution<double> noise;
  const double progress =
      1 - std::exp(-4. * static_cast<double>(number) / static_cast<double>(episodes));
  const double speed = std::max(-0.02, 0.16 * progress + 0.025 * noise(random));
  const double forward = 1000 * speed;
  const double turning = -30 * (1.1 - 0.7 * progress) * std::abs(1 + 0.35 * noise(random));
  const double falls = std::floor(std::max(0., (1 - progress) * 9 + noise(random)));
  EpisodeRecord episode;
  episode.number = number;
  episode.active.task = 1;
  episode.active.terms = {forward, turning, -4 * falls};
  episode.active.episode_return = forward + turning - 4 * falls;
  const bool fails = episode.active.episode_return < -25;
  episode.active.end_kind = fails ? "failure" : "truncated";
  episode.active.end_reason = fails ? "falls too often" : "time is up";
  episode.simulated_seconds = fails ? 8.3 : 20.005;
  episode.wall_seconds = episode.simulated_seconds / 14;
  episode.cpu_seconds = 0.9 * episode.wall_seconds;
  episode.steps = std::lround(episode.simulated_seconds / 0.005);
  episode.actions = episode.steps / 30;
  episode.active.metrics = {speed * episode.simulated_seconds, falls};
  episode.active.logs = {speed};
  episode.learner = {{"temperature", 5 * std::exp(-0.004 * static_cast<double>(number))}};
  return episode;
}

}  // namespace

TaskRecord SampleCrawling() {
  TaskRecord task;
  task.id = 1;
  task.module = "task";
  task.task = "crawling";
  task.task_file = "tasks/crawling.task";
  task.task_hash = "8f2d0c5b7a1e";
  task.compiler = "g++ 12.2.0";
  task.terms = {{"forward", "speed along the body's heading"}, {"turning", ""}, {"fall", ""}};
  task.metrics = {{"distance", "m", "last", ""}, {"falls", "", "sum", "actions with a fall"}};
  task.logs = {{"speed", "m/s", "mean", "of the body, forward"}};
  task.sources = {{task.task_file, CrawlingSource()},
                  {"tasks/shaping.task", "fn double(x: real) -> real = 2 * x\n"}};
  return task;
}

RunRecord SampleRunRecord() {
  RunRecord run;
  run.robot = "humanoid";
  run.agent = kAgent;
  run.profile = "paper";
  run.version = "0.1.0";
  run.robot_description = TextOf(SOURCE_DIR "/plugins/humanoid/robot.toml");
  run.body = BodyJson(Humanoid());
  run.settings = SettingsText({{"task.fall_penalty", "8.0", "--set"}});
  run.call = CallText({"tasks/crawling.task", "--set", "task.fall_penalty=8"});
  run.seed = 1;
  run.episodes_planned = 2000;
  run.record_every = 100;
  run.tasks = {SampleCrawling()};
  return run;
}

Recording SampleRecording(double duration, double speed) {
  constexpr double kInterval = Recorder::kFrameInterval;
  const std::vector<float> poses = CrawlingPoses(Humanoid(), duration, kInterval, speed);
  const size_t frame_size = Humanoid().links.size() * Recorder::kFloatsPerLink;
  return {static_cast<int64_t>(poses.size() / frame_size), kInterval, false,
          Compress(std::as_bytes(std::span(poses))), ""};
}

void WriteSampleRun(const std::filesystem::path& folder, const SampleSize& size) {
  RunDatabase database = RunDatabase::Create(folder, SampleRunRecord());
  database.SetLearnerCurves({{"temperature", "", "", "of the selection"}});
  std::mt19937 random(1);
  double best = -1e300;
  for (int64_t number = 1; number <= size.episodes; ++number) {
    const EpisodeRecord episode = SampleEpisode(number, size.episodes, random);
    std::optional<Recording> recording;
    const bool is_best = episode.active.episode_return > best;
    best = std::max(best, episode.active.episode_return);
    if (size.record_every > 0 && (is_best || number % size.record_every == 0)) {
      recording =
          SampleRecording(size.duration, episode.active.metrics[0] / episode.simulated_seconds);
      recording->is_best = is_best;
      recording->timeline = SampleTimeline(*recording, episode, SampleCrawling());
    }
    database.AddEpisode(episode, recording, std::nullopt);
  }
  database.SetState(RunState::kFinished);
}

namespace {

TaskRecord CarefulTask(std::string module) {
  TaskRecord task = SampleCrawling();
  task.module = std::move(module);
  task.task_file = "tasks/careful.task";
  task.task_hash = "c0ffee5b7a1e";
  task.terms = {{"forward", "speed along the body's heading"}, {"fall", ""}, {"effort", "torque"}};
  task.metrics.push_back({"work", "J", "sum", "of all joints"});
  task.logs.clear();
  task.goals = {{"heading", "vec2", "", "where to go"}};
  task.sources.resize(1);
  std::string& text = task.sources.front().text;  // that it means another thing
  text.replace(text.find("time > 20 s"), 11, "time > 30 s");
  return task;
}

// What the careful task with this id says of an episode of the first task.
Evaluation CarefulEvaluation(int64_t task, const Evaluation& first) {
  Evaluation careful = first;
  careful.task = task;
  careful.terms = {first.terms[0], 2 * first.terms[2], -0.25 * std::abs(first.terms[1])};
  careful.episode_return = careful.terms[0] + careful.terms[1] + careful.terms[2];
  careful.metrics.push_back(1e5 * first.terms[1] - 2.5e6);  // so many digits take room
  careful.logs.clear();
  careful.goals = {{0, 0, {0.6, 0.8}}, {0, 2, {1, 0}}};
  return careful;
}

}  // namespace

void WriteTunedRun(const std::filesystem::path& folder) {
  constexpr int64_t kEpisodes = 400;
  RunRecord run = SampleRunRecord();
  run.episodes_planned = kEpisodes;
  RunDatabase database = RunDatabase::Create(folder, run);
  const int64_t shadow = database.AddTask(CarefulTask("careful"));
  const int64_t active = database.AddTask(CarefulTask("task"));
  for (const ChangeRecord& change :
       {ChangeRecord{0, 101, 0, "2026-01-02T03:04:05Z", LoadShadow{"careful", 2},
                     "load careful: careful.task (c0ffee5b)"},
        ChangeRecord{0, 180, 1250, "2026-01-02T03:09:10Z", SetParameter{"learner.temperature", 0.5},
                     "set learner.temperature = 0.5"},
        ChangeRecord{0, 251, 0, "2026-01-02T03:14:15Z", SwapTask{"task", 3},
                     "swap task: examples/live/careful-with-a-longer-name.task (c0ffee5b)"},
        ChangeRecord{0, 251, 0, "2026-01-02T03:14:16Z", SetParameter{"task.weight", int64_t{2}},
                     "set task.weight = 2"}}) {
    database.AddChange(change);
  }
  std::mt19937 random(2);
  for (int64_t number = 1; number <= kEpisodes; ++number) {
    EpisodeRecord episode = SampleEpisode(number, kEpisodes, random);
    if (number >= 101) episode.shadows = {CarefulEvaluation(shadow, episode.active)};
    if (number >= 251) episode.active = CarefulEvaluation(active, episode.active);
    std::optional<Recording> recording;
    if (number % 100 == 0) {
      recording = SampleRecording(5, 0.1);
      recording->timeline = SampleTimeline(*recording, episode,
                                           number >= 251 ? CarefulTask("task") : SampleCrawling());
    }
    database.AddEpisode(episode, recording, std::nullopt);
  }
  database.SetState(RunState::kFinished);
  PolicyEvaluation evaluation{.profile = "paper-tree",
                              .learned_profile = run.profile,
                              .version = run.version,
                              .checkpoint_episode = kEpisodes,
                              .checkpoint = "0123456789abcdef",
                              .returns = {9, 10, 11},
                              .mean_return = 10,
                              .learned_return = 12.5,
                              .ends = {{"failure", 1}, {"truncated", 2}},
                              .metrics = {},
                              .learned_metrics = {}};
  WriteEvaluation(folder, evaluation);
}

}  // namespace runtime
