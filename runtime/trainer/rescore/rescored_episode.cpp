#include "runtime/trainer/rescore/rescored_episode.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "runtime/base/user_error.h"
#include "runtime/core/module/end_kind_name.h"
#include "runtime/training/run/compression.h"
#include "runtime/training/run/recorder.h"
#include "runtime/training/run/tape.h"

namespace runtime {
namespace {

// Each of them reaches the tasks before the player, as in training.
constexpr std::array kEnvironmentEvents = {"start_of_episode", "start_of_time_step",
                                           "start_of_physics_step", "end_of_physics_step",
                                           "end_of_time_step"};
constexpr std::array kPlayerEvents = {"start_of_action", "end_of_action"};

Judgment JudgmentOf(const UniversalTask& task, double end_time) {
  const taskc_plugin& plugin = task.plugin();
  Judgment judgment{.episode_return = task.episode_return(),
                    .end_kind = std::string(EndKindName(task.end().kind)),
                    .end_reason = task.end().reason,
                    .end_time = end_time,
                    .terms = {},
                    .metrics = {}};
  for (size_t i = 0; i < task.term_sums().size(); ++i)
    judgment.terms[plugin.terms[i].name] = task.term_sums()[i];
  for (size_t i = 0; i < task.metrics().size(); ++i)
    judgment.metrics[plugin.metrics[i].name] = task.metrics()[i];
  return judgment;
}

double SumOf(const UniversalTask& task, const std::string& term) {
  for (size_t i = 0; i < task.term_sums().size(); ++i)
    if (term == task.plugin().terms[i].name) return task.term_sums()[i];
  return 0;
}

// The first term of the two tasks, by name, that one has paid for and not the other, or otherwise.
std::string DifferentTerm(const UniversalTask& first, const UniversalTask& second) {
  for (const UniversalTask* task : {&first, &second}) {
    for (size_t i = 0; i < task->term_sums().size(); ++i) {
      const std::string term = task->plugin().terms[i].name;
      if (SumOf(first, term) != SumOf(second, term)) return term;
    }
  }
  return "return";
}

class Watch {
 public:
  Watch(const RobotEnvironment& environment, const UniversalTask& old_task,
        const UniversalTask& new_task)
      : environment_(environment), old_task_(old_task), new_task_(new_task) {}

  void Look() {
    const double time = environment_.time();
    if (!old_has_ended_) old_end_ = time;
    if (!new_has_ended_) new_end_ = time;
    old_has_ended_ = old_task_.has_ended();
    new_has_ended_ = new_task_.has_ended();
    if (difference_) return;
    if (old_task_.episode_return() != new_task_.episode_return()) {
      difference_ = {time, DifferentTerm(old_task_, new_task_)};
    } else if (old_has_ended_ != new_has_ended_) {
      difference_ = {time, "end"};
    }
  }

  double old_end() const { return old_end_; }
  double new_end() const { return new_end_; }
  const std::optional<RescoredEpisode::Difference>& difference() const { return difference_; }

 private:
  const RobotEnvironment& environment_;
  const UniversalTask& old_task_;
  const UniversalTask& new_task_;
  bool old_has_ended_ = false;
  bool new_has_ended_ = false;
  double old_end_ = 0;
  double new_end_ = 0;
  std::optional<RescoredEpisode::Difference> difference_;
};

// The frames of a recording, against which a simulation is held.
class Frames {
 public:
  Frames(const Recording& recording, const RobotEnvironment& environment)
      : bytes_(Decompress(recording.poses, "its data")),
        steps_per_frame_(
            std::max(1L, std::lround(recording.frame_interval / environment.time_step()))),
        frame_(static_cast<size_t>(environment.pose_count()) * Recorder::kFloatsPerLink) {}

  // Whether the robot is as in the recording after so many time steps.
  bool Fit(size_t steps, const RobotEnvironment& environment) {
    const auto interval = static_cast<size_t>(steps_per_frame_);
    const size_t size = frame_.size() * sizeof(float);
    if (steps % interval != 0 || (steps / interval + 1) * size > bytes_.size()) return true;
    environment.CapturePose(frame_);
    return std::memcmp(frame_.data(), bytes_.data() + steps / interval * size, size) == 0;
  }

 private:
  const std::string bytes_;
  const long steps_per_frame_;
  std::vector<float> frame_;
};

}  // namespace

Rescorer::Rescorer(const robot::RobotDescription& robot, const std::string& profile, uint64_t seed,
                   std::shared_ptr<const Plugin> old_task, std::shared_ptr<const Plugin> new_task) {
  const Context context{&robot, old_task, seed};
  environment_ = &static_cast<RobotEnvironment&>(
      graph_.Add(std::make_unique<RobotEnvironment>("environment", context)));
  environment_->Set("profile", profile);
  old_task_ = &Add("old", robot, std::move(old_task), seed);
  new_task_ = &Add("new", robot, std::move(new_task), seed);
  player_ = &static_cast<TapePlayer&>(graph_.Add(std::make_unique<TapePlayer>("player")));
  for (const UniversalTask* task : {old_task_, new_task_}) {
    const std::string slot = task->name() + ".on_";
    for (const char* event : kEnvironmentEvents)
      graph_.Connect(std::string("environment.") + event, slot + event);
    for (const char* event : kPlayerEvents)
      graph_.Connect(std::string("player.") + event, slot + event);
    graph_.Connect("player.episode_over", slot + "end_of_episode");
  }
  for (const char* event :
       {"start_of_episode", "start_of_time_step", "end_of_time_step", "end_of_episode"})
    graph_.Connect(std::string("environment.") + event, std::string("player.") + event);
  graph_.Connect("player.joint_targets", "environment.joint_targets");
  for (UniversalTask* task : {old_task_, new_task_}) {
    UniversalTask::CheckCanLoad(*task->instance().plugin(), *task, graph_);
    task->ConnectSensors(graph_);
    task->FollowDiscount(player_->discount());
  }
  graph_.Start();
}

UniversalTask& Rescorer::Add(const char* name, const robot::RobotDescription& robot,
                             std::shared_ptr<const Plugin> plugin, uint64_t seed) {
  return static_cast<UniversalTask&>(graph_.Add(std::make_unique<UniversalTask>(
      name, robot, std::make_unique<TaskInstance>(std::move(plugin)), seed)));
}

RescoredEpisode Rescorer::Rescore(const EpisodeRecord& episode, const Recording& recording,
                                  const std::string& packed) {
  if (packed.empty())
    throw UserError(
        fmt::format("episode {} was recorded without what it was driven by", episode.number));
  const Tape tape = Unpack(packed);
  const auto role = tape.ends_at_once ? UniversalTask::Role::kShadowEndsAtOnce
                                      : UniversalTask::Role::kShadowEndsWithAction;
  for (UniversalTask* task : {old_task_, new_task_}) {
    task->SetRole(role);
    task->SetNextEpisode(episode.number);
  }
  player_->Insert(tape);
  Frames frames(recording, *environment_);
  Watch watch(*environment_, *old_task_, *new_task_);
  environment_->SetNextEpisode(episode.number);
  environment_->Set("start_pose", tape.start_pose);
  environment_->StartEpisode(tape.start);
  bool fits = frames.Fit(0, *environment_);
  for (size_t step = 1; fits && !player_->is_over(); ++step) {
    environment_->RunTimeStep();
    watch.Look();
    fits = frames.Fit(step, *environment_);
  }
  if (!fits)
    throw UserError(fmt::format(
        "episode {}: simulated again, the robot moves otherwise than it did: the recording is of "
        "another version of the trainer, or robot and world were made random in the run",
        episode.number));
  return {.number = episode.number,
          .recorded_return = episode.active.episode_return,
          .old_task = JudgmentOf(*old_task_, watch.old_end()),
          .new_task = JudgmentOf(*new_task_, watch.new_end()),
          .first_difference = watch.difference()};
}

}  // namespace runtime
