// The library beside the trainer: the same decisions, the same episode.
#include <gmock/gmock.h>

#include <utility>

#include "runtime/core/module/connections.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/run/episode.h"
#include "runtime/training/run/task_modules.h"
#include "tests/libtaskc_sim/opened_sim.h"

namespace libtaskc_sim {
namespace {

using runtime::EpisodeEnd;

// A learner of the trainer that decides what ActionElement() says, within the events.
class Script : public runtime::Learner {
 public:
  Script(std::string name, const runtime::Context&) : Learner(std::move(name)) {}

  void Start() override { runtime::RequireConnections(*this); }
  const double& discount() const override { return discount_; }
  bool ends_at_once() const override { return true; }
  void ForgetCredit() override {}
  void Forget() override {}
  void StopLearning() override {}

  const std::vector<double>& rewards() const { return rewards_; }
  // Of each decision, and at the end, one after the other.
  const std::vector<float>& seen() const { return seen_; }

 private:
  void SelectFirst() override {
    rewards_.clear();
    seen_.clear();
    Select();
  }
  void Execute() override { execute_(action_); }
  void LearnAndSelect(double reward) override {
    rewards_.push_back(reward);
    Select();
  }
  void LearnFromEnd(double reward, const EpisodeEnd&) override { rewards_.push_back(reward); }
  void FinishEpisode() override { See(); }

  void See() {
    for (const double number : observation_()) seen_.push_back(static_cast<float>(number));
  }
  void Select() {
    See();
    action_.resize(action_size_());
    const auto step = static_cast<int64_t>(rewards_.size());
    for (Eigen::Index i = 0; i < action_.size(); ++i) action_[i] = ActionElement(0, step, i);
  }

  const double discount_ = 0.99;
  Eigen::VectorXd action_;
  std::vector<double> rewards_;
  std::vector<float> seen_;
  runtime::In<Eigen::VectorXd> observation_{this, "observation"};
  runtime::In<int> action_size_{this, "action_size"};
  runtime::Signal<const Eigen::VectorXd&> execute_{this, "execute"};
};

// `options`: of one environment.
void ExpectTheTrainersEpisode(const taskc_sim_options& options, int64_t number) {
  runtime::TaskOptions task{.task = options.plugin,
                            .profile = options.profile,
                            .agent = "ppo",
                            .robot = "",
                            .settings = {}};
  if (options.robot != nullptr) task.robot = options.robot;
  const runtime::TaskSetup setup(task, options.plugin, options.seed);
  runtime::ModuleTypes types = setup.types;
  types.Add<Script>("Script");
  runtime::Agent script;
  script.modules = {{"learner", "Script", {"test"}, {}}};
  runtime::ModuleGraph graph =
      runtime::BuildGraph(runtime::Changed(setup.agent, script), types, setup.context);
  auto& learner = graph.FindOnly<Script>();
  const runtime::TaskModules tasks = runtime::FindTaskModules(graph, learner);
  graph.Start();
  const runtime::EpisodeRecord record = runtime::RunEpisode(
      number, {graph.FindOnly<runtime::Environment>(), learner, tasks}, [](int64_t) {});

  OpenedSim sim(options);
  sim.Reset({static_cast<taskc_uint64>(number - 1)});
  std::vector<double> rewards;
  std::vector<float> seen = sim.observations;
  do {
    sim.Step();
    rewards.push_back(sim.rewards[0]);
    seen.insert(seen.end(), sim.observations.begin(), sim.observations.end());
  } while (sim.terminated[0] + sim.truncated[0] == 0 && rewards.size() < 100'000);

  EXPECT_GT(rewards.size(), 2U);
  EXPECT_EQ(rewards, learner.rewards());
  EXPECT_EQ(seen, learner.seen());
  const taskc_sim_episode episode = sim.LastEpisode();
  EXPECT_EQ(episode.number, record.number);
  EXPECT_EQ(episode.actions, record.actions);
  EXPECT_EQ(episode.time_steps, record.steps);
  EXPECT_EQ(episode.seconds, record.simulated_seconds);
  EXPECT_EQ(episode.episode_return, record.active.episode_return);
  EXPECT_EQ(episode.reason, record.active.end_reason);
  EXPECT_EQ(std::vector<double>(episode.terms, episode.terms + record.active.terms.size()),
            record.active.terms);
  EXPECT_EQ(std::vector<double>(episode.metrics, episode.metrics + record.active.metrics.size()),
            record.active.metrics);
  EXPECT_EQ(sim.term_sums, record.active.terms);
}

TEST(BesideTheTrainer, CrawlingIsSeenAndPaidTheSame) {
  ExpectTheTrainersEpisode(OptionsOf(CRAWLING), 1);
}

TEST(BesideTheTrainer, SoIsATaskThatDrawsGoals) {
  taskc_sim_options options = OptionsOf(SWAYING);
  options.robot = "humanoid";
  options.profile = "fast";
  options.seed = 5;
  ExpectTheTrainersEpisode(options, 3);
}

}  // namespace
}  // namespace libtaskc_sim
