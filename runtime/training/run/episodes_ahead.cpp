#include "runtime/training/run/episodes_ahead.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "runtime/training/run/graph_copy.h"

namespace runtime {
namespace {

// For a signal, and for clients.
constexpr std::chrono::milliseconds kBetweenLooks{10};

// The first task that remembers episodes, or null.
const UniversalTask* FindRemembering(const TaskModules& tasks) {
  if (tasks.active->instance().remembers_episodes()) return tasks.active;
  const auto found = std::ranges::find_if(tasks.shadows, [](const UniversalTask* shadow) {
    return shadow->instance().remembers_episodes();
  });
  return found == tasks.shadows.end() ? nullptr : *found;
}

}  // namespace

EpisodesAhead::EpisodesAhead(const ModuleGraph& graph, const ModuleTypes& types,
                             const Context& context, Learner& learner, TrainingHooks& hooks,
                             int jobs)
    : graph_(graph),
      learner_(learner),
      hooks_(hooks),
      policy_number_(learner.policy_number()),
      pool_(jobs, [&graph, &types, &context, watcher = hooks.watcher()] {
        return std::make_unique<Collector>(CopyOf(graph, types, context), watcher);
      }) {}

Collector* EpisodesAhead::Plan(int64_t next, int64_t last, const TaskModules& tasks) {
  last = std::min(last, hooks_.undisturbed_until());
  const bool is_void = learner_.policy_number() != policy_number_ || last < next;
  if (is_void) pool_.FreeAll();
  policy_number_ = learner_.policy_number();
  last = std::min(last, next + learner_.EpisodesAlike() - 1);
  if (last > next && FindRemembering(tasks) == nullptr) {
    for (int64_t episode = next; episode <= last; ++episode) {
      if (pool_.Find(episode) != nullptr) continue;
      Collector* free = pool_.FindFree();
      if (free == nullptr) break;
      Start(episode, *free);
    }
  }
  return pool_.Find(next);
}

void EpisodesAhead::Start(int64_t episode, Collector& collector) {
  collector.Prepare(episode, graph_, learner_);
  hooks_.Anticipate(episode, collector.graph());
  pool_.Start(collector);
}

bool EpisodesAhead::IsDone(const Collector& collector) {
  return pool_.IsDone(collector, kBetweenLooks);
}

EpisodeRecord EpisodesAhead::TakeOver(Collector& collector) {
  return collector.HandOver(graph_, learner_);
}

std::string WhyNotAhead(const Environment& environment, const Learner& learner,
                        const TaskModules& tasks) {
  if (learner.learns_within_episodes()) {
    return fmt::format("`{}` learns within episodes", learner.name());
  }
  if (const UniversalTask* task = FindRemembering(tasks)) {
    return fmt::format("the task `{}` remembers something from episode to episode",
                       task->plugin().name);
  }
  return environment.WhyOnlyOne();
}

}  // namespace runtime
