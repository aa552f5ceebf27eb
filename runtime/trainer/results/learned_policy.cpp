#include "runtime/trainer/results/learned_policy.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <variant>

#include "runtime/analysis/export/csv.h"
#include "runtime/core/module/element_names.h"
#include "runtime/core/module/observations.h"
#include "runtime/trainer/results/decision_recorder.h"

namespace runtime {
namespace {

// Whose port this in port reads, or null.
Module* SourceOf(const Module& module, const char* in) {
  const std::vector<Port*> sources = module.FindPort(in).Connections();
  return sources.empty() ? nullptr : &sources.front()->owner();
}

// The learners whose policies can be exported.
std::vector<std::string> ExportableLearners(const KeptRun& kept) {
  std::vector<std::string> exportable;
  for (const std::string& type : kept.types.names()) {
    const std::unique_ptr<Module> module = kept.types.Make(type, type, kept.context);
    const bool is_learner = dynamic_cast<const Learner*>(module.get()) != nullptr;
    if (is_learner && dynamic_cast<const PolicyPart*>(module.get()) != nullptr)
      exportable.push_back(type);
  }
  return exportable;
}

const PolicyPart& LearnersPart(const KeptRun& kept, const Learner& learner) {
  if (const auto* part = dynamic_cast<const PolicyPart*>(&learner)) return *part;
  const auto setting = std::ranges::find(kept.agent.modules, learner.name(), &ModuleSetting::name);
  const std::string type = setting == kept.agent.modules.end() ? "" : ", a " + setting->type + ",";
  throw UserError(fmt::format(
      "the policy of `{}`{} cannot be exported: it is no function of what the robot observes "
      "alone; those of these learners are: {}",
      learner.name(), type, fmt::join(ExportableLearners(kept), ", ")));
}

// The module that makes joint targets of the learner's actions.
Module& FindActionSpace(const Environment& environment, const Learner& learner) {
  Module* space = SourceOf(environment, "joint_targets");
  const bool is_part = dynamic_cast<const PolicyPart*>(space) != nullptr &&
                       space->FindPort("execute").IsConnectedTo(learner.FindPort("execute"));
  if (is_part) return *space;
  throw UserError(fmt::format(
      "the policy of `{}` cannot be exported: what `{}` makes of its actions is no function of "
      "them alone; what a JointOffsets makes is",
      learner.name(), space == nullptr ? "nothing" : space->name()));
}

std::vector<PolicyElement> ObservedElements(const Learner& learner,
                                            const robot::RobotDescription& robot) {
  const Module* source = SourceOf(learner, "observation");
  const std::optional<ObservationLayout> layout = LayoutShownBy(*source);
  if (!layout) {
    throw UserError(fmt::format(
        "`{}.observation` comes from `{}`, which does not say what it consists of: it needs an out "
        "port of the type `{}`",
        learner.name(), source->name(), TypeText<ObservationLayout>::value));
  }
  std::vector<PolicyElement> elements;
  for (const ObservedValue& value : layout->values) {
    for (const std::string& name : ElementNames(value, robot))
      elements.push_back({name, value.unit});
  }
  return elements;
}

bool IsFinite(const PolicyGraph& graph) {
  return std::ranges::all_of(graph.steps, [](const PolicyGraph::Step& step) {
    const auto* affine = std::get_if<PolicyGraph::Affine>(&step);
    return affine == nullptr || (affine->factors.allFinite() && affine->offsets.allFinite());
  });
}

std::vector<std::pair<std::string, std::string>> FactsOf(const std::filesystem::path& folder,
                                                         const LearnedRun& run) {
  const TaskRecord& task = TaskWithId(run.record, run.episodes.back().active.task);
  return {{"task", task.task},
          {"task_hash", task.task_hash},
          {"robot", run.record.robot},
          {"profile", run.record.profile},
          {"run", std::filesystem::weakly_canonical(folder).filename().string()},
          {"seed", fmt::to_string(run.record.seed)},
          {"episode", fmt::to_string(run.checkpoint.episode)},
          {"version", TASKC_VERSION}};
}

void AddColumns(const char* group, const std::vector<PolicyElement>& elements,
                std::vector<std::string>& columns) {
  for (const auto& [name, unit] : elements) {
    columns.push_back(fmt::format("{}/{}{}", group, name, unit.empty() ? "" : " [" + unit + "]"));
  }
}

}  // namespace

LearnedPolicy::LearnedPolicy(const std::filesystem::path& folder, const ModuleTypes& types) {
  RunDatabase database = RunDatabase::OpenToRead(folder);
  LearnedRun run(folder, database, "to export");
  if (run.record.robot.empty()) {
    throw UserError(
        fmt::format("{}: the policy cannot be exported: the run has no robot, whose joint targets "
                    "it would give",
                    folder.string()));
  }
  Progress progress(ProgressStyle::kQuiet, run.record, stdout, stderr);
  const StopRequest stop;
  performer_ =
      std::make_unique<Performer>(folder, run, database, run.record.profile, progress, stop, types);
  const KeptRun& kept = performer_->kept();
  const Environment& environment = performer_->environment();
  const Learner& learner = performer_->learner();
  const PolicyPart& part = LearnersPart(kept, learner);
  action_space_ = &FindActionSpace(environment, learner);
  // Motions begin where the robot does.
  if (!kept.graph.FindAll<MotionPart>().empty()) performer_->RunEpisode(1, [](int64_t) {});

  PolicyGraph& graph = exported_.graph;
  graph.observation = ObservedElements(learner, kept.robot);
  const PolicyGraph::Value action = part.AddTo(graph, PolicyGraph::kObservation);
  const auto& space = dynamic_cast<const PolicyPart&>(*action_space_);
  graph.result.value = space.AddTo(graph, action);
  graph.result.name = graph.motion ? "joint_offsets" : "joint_targets";
  for (const robot::Joint& joint : kept.robot.joints)
    graph.result.elements.push_back({joint.name, "rad"});
  if (!IsFinite(graph)) {
    throw UserError(fmt::format("{}: what `{}` has learned is not finite: its run has diverged",
                                folder.string(), learner.name()));
  }
  exported_.seconds_per_decision = graph.time_steps * environment.time_step();
  exported_.facts = FactsOf(folder, run);
}

std::vector<Port*> LearnedPolicy::ResultPorts() const {
  std::vector<Port*> ports = {&action_space_->FindPort("joint_targets")};
  if (exported_.graph.motion)
    ports.insert(ports.begin(), &action_space_->FindPort(exported_.graph.result.name));
  return ports;
}

std::string LearnedPolicy::RunEpisode() {
  DecisionRecorder recorder(performer_->environment(), performer_->learner(), ResultPorts());
  performer_->RunEpisode(1, [](int64_t) {});
  const PolicyGraph& graph = exported_.graph;
  std::vector<std::string> columns = {"time [s]"};
  AddColumns("observation", graph.observation, columns);
  for (const PolicyGraph::Output& output : graph.others)
    AddColumns(output.name.c_str(), output.elements, columns);
  for (const Port* port : ResultPorts())
    AddColumns(port->name().c_str(), graph.result.elements, columns);
  return CsvOf(columns, recorder.decisions());
}

}  // namespace runtime
