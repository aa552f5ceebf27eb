// A run that can be talked to while it learns.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "runtime/live/control/change_maker.h"
#include "runtime/live/control/command_table.h"
#include "runtime/live/control/journal.h"
#include "runtime/live/control/live_graph.h"
#include "runtime/live/control/live_view.h"
#include "runtime/live/control/request.h"
#include "runtime/live/control/request_queue.h"
#include "runtime/live/control/schedules.h"
#include "runtime/live/control/task_loader.h"
#include "runtime/training/run/progress.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/stop_request.h"
#include "runtime/training/run/training_hooks.h"

namespace runtime {

// What a run is made of. All of it outlives the LiveRun.
struct RunParts {
  std::filesystem::path folder;
  RunRecord& record;
  RunDatabase& database;
  ModuleGraph& graph;  // started
  const ModuleTypes& types;
  const Context& context;
};

// Requests come on any thread, wait in a queue, and are done by the thread that trains, where
// nothing of the run is running. All of TrainingHooks is called there.
class LiveRun : public RequestHandler, public TrainingHooks {
 public:
  // What becomes of the trainer when all planned episodes are done.
  enum class WhenDone { kEnd, kWait };

  // Throws UserError where the record holds what cannot be done again.
  // `progress` and `stop` outlive this object.
  LiveRun(const RunParts& run, Progress& progress, WhenDone when_done, const StopRequest& stop);
  ~LiveRun() override;  // refuses the requests that still wait

  // Null, or an object that outlives this one. Before the training begins.
  void PublishTo(EventSink* events) {
    events_ = events;
    view_.ShowTo(events);
  }

  // By what recorded episodes are judged by another task: the words, program included, of one that
  // prints what docs/trainer.md says of `trainer rescore --json`. Before the training begins.
  using RescoreWords =
      std::function<std::vector<std::string>(const std::filesystem::path& plugin, int64_t episode)>;
  void RescoreBy(RescoreWords words) { rescore_words_ = std::move(words); }

  void Handle(Request request, ReplyHandler reply) override;
  // Where the run's robot is, for programs that read tasks.
  const std::filesystem::path& robots_folder() const { return loader_.robots_folder(); }
  void Watch(const ViewWish& wish) override { view_.Wish(wish); }

  std::set<std::string> BeforeRestore(int64_t episode) override;
  void AfterRestore(const ReturnStatistics& statistics) override { statistics_ = statistics; }
  bool AtSafePoint(int64_t episode, int64_t step) override;
  int64_t undisturbed_until() const override;
  void Anticipate(int64_t episode, ModuleGraph& copy) const override;
  EpisodeWatcher* watcher() override { return &view_; }
  void AfterEpisode(const EpisodeRecord& episode, const ReturnStatistics& statistics,
                    bool checkpoint_was_saved) override;
  void OnWarning(const std::string& text) override;
  bool wants_checkpoint() const override { return !waiting_for_checkpoint_.empty(); }
  bool wants_stop() const override { return stop_was_asked_for_; }
  bool PlanMore(int64_t episodes_done) override;

  // The graph has failed. If a change of the last two episodes can be blamed for it, this change
  // is put into quarantine, so that the run can go on from its checkpoint without it.
  bool BlameLastChange(const std::string& why);

 private:
  enum class State { kRunning, kPaused, kFinished };
  enum class StepUnit { kStep, kEpisode };

  void SetState(State state);
  bool stops() const { return stop_was_asked_for_ || stop_.signal() != 0; }
  void Publish(const nlohmann::json& event);

  void WaitInPause();

  // What was done from outside in an episode that need not be run again. Writes nothing.
  void RepeatEpisode(const EpisodeRecord& episode);
  void RepeatPast(const RunPosition& position);
  void NoteNotAgain(const ChangeRecord& change);
  // Does what is due here.
  void DoDueChanges();
  // Where it cannot be done, says so and returns why.
  std::optional<std::string> TryAgain(const DueChange& due);
  void Do(const DueChange& due);
  void NoteDone(const ChangeRecord& record);
  // On the loader's thread.
  Reply DoAside(AsideHandler handler, const nlohmann::json& arguments, const BuiltPlugin& task);
  void ServeQueue();
  void Serve(const QueuedRequest& request);

  // Handlers of all commands.
#define LOOK(handler, ...) nlohmann::json handler(const nlohmann::json& arguments) const;
#define ASIDE(handler, ...) \
  nlohmann::json handler(const nlohmann::json& arguments, const BuiltPlugin& task);
#define CHANGE(handler, ...) nlohmann::json handler(const QueuedRequest& request);
#define CHANGE_LATER(handler, ...) void handler(const QueuedRequest& request);
#include "runtime/live/control/command_table.def"
  friend const CommandHandler& HandlerOf(const CommandSpec& command);

  nlohmann::json StatusJson() const;
  void CheckEpisodesAreLeft() const;
  void CheckIsGood(const TaskRecord& task) const;
  // The record of a task, which may be an older one of the same version.
  const TaskRecord& RecordTask(TaskRecord task);
  // What the module will have where a change takes effect, `now` or as the next episode starts.
  int64_t TaskToCome(const std::string& module, bool now) const;
  // The reply to a change that brings another task into a module that is there. Unless something is
  // to be forgotten as well, it is not done where it would change nothing.
  nlohmann::json Exchange(const Change& change, std::shared_ptr<const Plugin> plugin, bool forget,
                          bool now);
  // Writes a change down, and does it then if it is to take effect here. `plugin`: of the task that
  // it brings, where it is loaded already. Returns "now" or "episode 13". Throws UserError where it
  // cannot be written or done; then it is neither.
  std::string Make(const Change& change, bool now, std::shared_ptr<const Plugin> plugin = nullptr);
  // Does it here; returns the reply's value.
  nlohmann::json MakeNow(const Change& change);
  void CountDown();

  RunParts run_;
  Progress& progress_;
  const WhenDone when_done_;
  const StopRequest& stop_;
  LiveGraph graph_;
  Schedules schedules_;
  Journal journal_;
  ChangeMaker maker_;
  RequestQueue queue_;
  TaskLoader loader_;
  RescoreWords rescore_words_;
  EventSink* events_ = nullptr;
  LiveView view_;

  RunPosition position_;
  bool graph_has_changed_ = false;  // since the training was told last
  State state_ = State::kRunning;
  std::optional<StepUnit> counts_;  // what is left of `step`
  int64_t steps_left_ = 0;
  bool stop_was_asked_for_ = false;
  std::vector<ReplyHandler> waiting_for_checkpoint_;
  std::vector<ChangeRecord> recent_;  // done in this episode or the one before
  std::set<std::string> not_again_;   // modules that came or went with a change not done again

  int64_t episodes_done_ = 0;
  // Of simulation, in each second of the last episodes; 0 before the first one.
  double speed() const { return wall_seconds_ > 0 ? simulated_seconds_ / wall_seconds_ : 0; }
  double simulated_seconds_ = 0, wall_seconds_ = 0;
  ReturnStatistics statistics_;
};

}  // namespace runtime
