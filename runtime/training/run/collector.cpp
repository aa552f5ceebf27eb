#include "runtime/training/run/collector.h"

#include <utility>

#include "runtime/base/thread_seconds.h"
#include "runtime/training/run/episode.h"
#include "runtime/training/run/graph_copy.h"

namespace runtime {
namespace {

struct IsUnwanted {};

}  // namespace

Collector::Collector(ModuleGraph graph, EpisodeWatcher* watcher)
    : graph_(std::move(graph)),
      environment_(graph_.FindOnly<Environment>()),
      learner_(graph_.FindOnly<Learner>()),
      tasks_(FindTaskModules(graph_, learner_)),
      watcher_(watcher),
      recorder_(environment_.pose_count(), environment_.time_step()),
      tape_(environment_, learner_) {}

void Collector::Prepare(int64_t episode, const ModuleGraph& graph, const Learner& leader) {
  episode_ = episode;
  failure_ = nullptr;
  CopyParameters(graph, graph_);
  learner_.Follow(leader, episode);
}

void Collector::Run(const std::atomic<bool>& is_unwanted) {
  try {
    const EpisodeModules modules = {environment_, learner_, tasks_};
    const auto after_step = [&](int64_t steps) {
      if (is_unwanted.load(std::memory_order_relaxed)) throw IsUnwanted();
      recorder_.Capture(steps, modules);
      tape_.Note(steps);
      if (watcher_ != nullptr) watcher_->AfterStep(episode_, steps, modules);
    };
    record_ = RunEpisode(episode_, modules, after_step,
                         [&](const auto& drawn) { tape_.StartEpisode(drawn); });
    return;
  } catch (const IsUnwanted&) {
    // Nobody will ask.
  } catch (...) {
    failure_ = std::current_exception();
  }
  if (watcher_ != nullptr) watcher_->BreakOff(environment_);
}

EpisodeRecord Collector::HandOver(const ModuleGraph& graph, Learner& leader) {
  if (failure_ != nullptr) std::rethrow_exception(failure_);
  const double start = ThreadSeconds();
  record_.active.faults -= learner_.passed_over_count();
  leader.TakeOver(learner_);
  for (const UniversalTask* task : graph_.FindAll<UniversalTask>()) {
    graph.FindAs<UniversalTask>(task->name()).TakeOverRun(*task);
  }
  NoteLearner(leader, environment_, record_);
  record_.cpu_seconds += ThreadSeconds() - start;
  return std::move(record_);
}

}  // namespace runtime
