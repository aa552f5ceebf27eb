// A learner that the trainer does not have, in a library of its own: augmented random search
// (Mania, Guy and Recht, "Simple random search of static policies is competitive for reinforcement
// learning", 2018; its variant V1-t, without normalized observations).
//
// The policy is a matrix M: action = M (observation, 1). A round tries `directions` random matrices
// D: an episode with M + noise D, another with M - noise D, whose returns are r+ and r-. Then
//
//   M += step / (b s) sum over the b directions with the greatest max(r+, r-) of (r+ - r-) D
//
// with s the standard deviation of the 2 b returns.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <istream>
#include <numeric>
#include <ostream>
#include <vector>

#include "runtime/core/module/connections.h"
#include "runtime/core/module/context.h"
#include "runtime/core/module/module_library.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/learning/random.h"

namespace {

using runtime::In;
using runtime::Signal;

class RandomSearch : public runtime::Learner {
 public:
  RandomSearch(std::string name, const runtime::Context& context)
      : Learner(std::move(name)), random_(context.seed) {
    AddParameter({.name = "step", .doc = "of a round", .target = &step_, .minimum = 0});
    AddParameter({.name = "noise",
                  .doc = "of the policies that are tried",
                  .target = &noise_,
                  .minimum = 0});
    AddParameter({.name = "directions",
                  .doc = "of a round",
                  .target = &directions_,
                  .minimum = 1,
                  .is_live = false});
    AddParameter({.name = "best",
                  .doc = "directions that count",
                  .target = &best_,
                  .minimum = 1,
                  .is_live = false});
    AddCurve({"size", "", "of the policy: the root of the sum of its squares", &size_});
  }

  void Start() override {
    runtime::RequireConnections(*this);
    if (best_ <= directions_) return;
    throw runtime::UserError("`" + name() + ".best` is more than `" + name() + ".directions`");
  }

  const double& discount() const override { return discount_; }
  bool ends_at_once() const override { return true; }
  // What the old task has paid for this round does not count.
  void ForgetCredit() override { returns_.clear(); }
  void Forget() override {
    policy_.setZero();
    returns_.clear();
  }
  void StopLearning() override { learns_ = false; }

  // All that the next episodes depend on, every bit of it.
  void Save(std::ostream& out) const override {
    out << random_ << ' ' << policy_.rows() << ' ' << policy_.cols() << ' ' << returns_.size()
        << ' ' << std::hexfloat;
    for (const double weight : policy_.reshaped()) out << weight << ' ';
    for (const double value : returns_) out << value << ' ';
    out << std::defaultfloat << round_seed_ << ' ';
  }
  void Load(std::istream& in) override {
    Eigen::Index rows = 0, columns = 0;
    size_t returns = 0;
    in >> random_ >> rows >> columns >> returns;
    policy_.resize(rows, columns);
    returns_.resize(returns);
    for (double& weight : policy_.reshaped()) weight = ReadReal(in);
    for (double& value : returns_) value = ReadReal(in);
    in >> round_seed_;
    if (!in) throw runtime::UserError("the checkpoint of `" + name() + "` is damaged");
  }

 private:
  using Policy = Eigen::MatrixXd;

  // The standard's streams write hexadecimal reals and do not read them.
  static double ReadReal(std::istream& in) {
    std::string text;
    in >> text;
    return std::strtod(text.c_str(), nullptr);
  }

  void SelectFirst() override {
    if (policy_.size() == 0) policy_.setZero(action_size_(), observation_().size() + 1);
    if (learns_ && returns_.empty())
      round_seed_ = static_cast<uint64_t>(random_.Uniform() * 0x1p53);
    tried_ = policy_;
    if (learns_) {
      const size_t episode = returns_.size();
      tried_ += (episode % 2 == 0 ? noise_ : -noise_) * Direction(episode / 2);
    }
    Select();
  }

  void Select() {
    action_ = tried_.leftCols(tried_.cols() - 1) * observation_() + tried_.rightCols(1);
  }
  void Execute() override { execute_(action_); }
  void LearnAndSelect(double) override { Select(); }
  void LearnFromEnd(double, const runtime::EpisodeEnd&) override {}

  void FinishEpisode() override {
    size_ = policy_.norm();
    if (!learns_) return;
    const bool counts =
        episode_end().kind != runtime::EndKind::kDiverged && std::isfinite(episode_return());
    returns_.push_back(counts ? episode_return() : 0);
    if (returns_.size() < 2 * static_cast<size_t>(directions_)) return;
    Learn();
    returns_.clear();
  }

  // The same whenever it is asked for in this round, so that nothing else need be kept.
  Policy Direction(size_t number) const {
    runtime::Random random(round_seed_ + number);
    return Policy::NullaryExpr(policy_.rows(), policy_.cols(), [&] { return random.Normal(); });
  }

  void Learn() {
    std::vector<size_t> order(static_cast<size_t>(directions_));
    std::iota(order.begin(), order.end(), size_t{0});
    const auto better = [this](size_t i) { return std::max(returns_[2 * i], returns_[2 * i + 1]); };
    std::ranges::stable_sort(order, std::greater(), better);
    order.resize(static_cast<size_t>(best_));

    double sum = 0, squares = 0;
    Policy change = Policy::Zero(policy_.rows(), policy_.cols());
    for (const size_t i : order) {
      const double plus = returns_[2 * i], minus = returns_[2 * i + 1];
      change += (plus - minus) * Direction(i);
      sum += plus + minus;
      squares += plus * plus + minus * minus;
    }
    const double count = 2.0 * best_;
    const double deviation = std::sqrt(std::max(squares / count - sum * sum / count / count, 0.0));
    if (deviation > 0) policy_ += step_ / (best_ * deviation) * change;
  }

  const double discount_ = 1;  // what counts is the return, a plain sum
  double step_ = 0.02;
  double noise_ = 0.03;
  int directions_ = 8;
  int best_ = 4;

  runtime::Random random_;
  Policy policy_;
  std::vector<double> returns_;  // of this round's episodes, so far
  uint64_t round_seed_ = 0;      // of its directions
  bool learns_ = true;
  Policy tried_;
  Eigen::VectorXd action_;
  double size_ = 0;

  In<Eigen::VectorXd> observation_{this, "observation"};
  In<int> action_size_{this, "action_size"};
  Signal<const Eigen::VectorXd&> execute_{this, "execute"};
};

}  // namespace

TASKC_MODULES(types) { types.Add<RandomSearch>("RandomSearch"); }
