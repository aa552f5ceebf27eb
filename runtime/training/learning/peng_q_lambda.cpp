#include "runtime/training/learning/peng_q_lambda.h"

#include <fmt/format.h>

#include <istream>
#include <limits>
#include <ostream>

#include "runtime/core/module/connections.h"
#include "runtime/training/learning/exponential_schedule.h"
#include "runtime/training/learning/terminal_end.h"

namespace runtime {
namespace {

constexpr const char* kAfterAction = "after_action";
constexpr const char* kImmediate = "immediate";

constexpr double kLowestTemperature = 1e-300;

constexpr const char* kFormat = "peng_q_lambda_1";  // of a checkpoint
constexpr int64_t kMostElements = int64_t{1} << 31;

}  // namespace

PengQLambda::PengQLambda(std::string name, const Context& context)
    : Learner(std::move(name)), random_(context.seed) {
  const auto add = [this](const char* parameter, const char* doc, double* target, double maximum) {
    AddParameter(
        {.name = parameter, .doc = doc, .target = target, .minimum = 0, .maximum = maximum});
  };
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  add("discount", "gamma, per action however long it lasts", &discount_, 1);
  add("trace_decay", "lambda", &trace_decay_, 1);
  add("learning_rate", "alpha in the first episode", &learning_rate_, kNoLimit);
  add("learning_rate_decay", "exponent per finished episode", &learning_rate_decay_, kNoLimit);
  add("learning_rate_min", "alpha does not fall below it", &learning_rate_min_, kNoLimit);
  add("temperature", "of the selection in the first episode; 0 is greedy", &temperature_, kNoLimit);
  add("temperature_decay", "exponent per finished episode", &temperature_decay_, kNoLimit);
  add("trace_max", "upper limit of a trace (replacing traces: 1)", &trace_max_, kNoLimit);
  AddParameter({.name = "episode_end",
                .doc = "when an episode ends, and what its last state is worth",
                .target = &episode_end_,
                .choices = {kAfterAction, kImmediate},
                .former_choices = {{"original", kAfterAction}, {"clean", kImmediate}}});
  AddCurve({"learning_rate", "", "alpha", &episode_learning_rate_});
  AddCurve({"temperature", "", "of the selection; 0 is greedy", &episode_temperature_});
}

void PengQLambda::Start() {
  RequireConnections(*this);
  if (learning_rate_min_ > learning_rate_) {
    throw UserError(fmt::format("`{0}.learning_rate_min` is {1}, more than `{0}.learning_rate` {2}",
                                name(), learning_rate_min_, learning_rate_));
  }
}

bool PengQLambda::ends_at_once() const { return episode_end_ == kImmediate; }

double PengQLambda::learning_rate() const {
  return ExponentialSchedule{learning_rate_, learning_rate_decay_, learning_rate_min_}.At(
      episodes_);
}

double PengQLambda::temperature() const {
  return ExponentialSchedule{temperature_, temperature_decay_, kLowestTemperature}.At(episodes_);
}

void PengQLambda::SelectFirst() {
  const Eigen::VectorXd& features = features_in_();
  PrepareTheta(static_cast<int>(features.size()));
  q_lambda_.StartEpisode(features, temperature(), random_);
}

void PengQLambda::PrepareTheta(int features) {
  const int actions = action_count_in_();
  if (q_lambda_.actions() == 0) q_lambda_ = QLambda(actions, features);
  if (q_lambda_.actions() == actions && q_lambda_.features() == features) return;
  throw UserError(
      fmt::format("`{}` has learned with {} actions and {} features, and the agent has {} and {}: "
                  "continue with the net and the intervals that it was trained with, or start over",
                  name(), q_lambda_.actions(), q_lambda_.features(), actions, features));
}

void PengQLambda::Forget() {
  q_lambda_.Forget();
  episodes_ = 0;
}

void PengQLambda::StopLearning() {
  temperature_ = temperature();
  temperature_decay_ = 0;
  learning_rate_ = 0;
  learning_rate_min_ = 0;
}

void PengQLambda::LearnFromEnd(double reward, const EpisodeEnd& end) {
  if (ends_at_once() && IsTerminal(end.kind)) {
    NoteStep(q_lambda_.EndEpisode(reward, settings(), learning_rate()));
  } else {
    LearnAndSelect(reward);
  }
}

void PengQLambda::FinishEpisode() {
  episode_learning_rate_ = learning_rate();
  episode_temperature_ = temperature();
  ++episodes_;
}

void PengQLambda::LearnAndSelect(double reward) {
  const Eigen::VectorXd& features = features_in_();
  if (features.size() != q_lambda_.features()) PrepareTheta(static_cast<int>(features.size()));
  NoteStep(q_lambda_.Step(reward, settings(), learning_rate(), features, temperature(), random_));
}

void PengQLambda::Save(std::ostream& out) const {
  const QLambda::Matrix& theta = q_lambda_.theta();
  out << kFormat << ' ' << episodes_ << ' ' << theta.rows() << ' ' << theta.cols() << ' ' << random_
      << '\n';
  out.write(reinterpret_cast<const char*>(theta.data()),
            static_cast<std::streamsize>(theta.size() * sizeof(double)));
}

void PengQLambda::Load(std::istream& in) {
  std::string format;
  int64_t episodes = 0, actions = 0, features = 0;
  Random random(0);
  in >> format >> episodes >> actions >> features >> random;
  const bool sound = in && format == kFormat && in.get() == '\n' && episodes >= 0 && actions >= 0 &&
                     features >= 0 && (features == 0 || actions <= kMostElements / features);
  const int64_t size = sound ? actions * features : 0;
  const auto bytes = static_cast<std::streamsize>(size) * static_cast<int>(sizeof(double));
  const bool complete = sound && in.rdbuf()->in_avail() >= bytes;
  QLambda::Matrix theta;
  if (complete) {
    theta.resize(actions, features);
    in.read(reinterpret_cast<char*>(theta.data()), bytes);
  }
  if (!complete || !in) {
    throw UserError(fmt::format("the checkpoint of `{}` is damaged or of another version", name()));
  }
  q_lambda_ = QLambda(std::move(theta));
  random_ = random;
  episodes_ = episodes;
}

}  // namespace runtime
