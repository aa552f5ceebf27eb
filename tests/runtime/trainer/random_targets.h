// The least that a learner is: a module that nothing of the program knows.
#pragma once

#include <algorithm>
#include <istream>
#include <ostream>
#include <string>
#include <utility>

#include "runtime/core/module/context.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/learning/random.h"

namespace runtime {

// Chooses joint targets at random, at most `reach` away from 0. It reaches further after an action
// that brought something, and less far after one that cost something.
class RandomTargets : public Learner {
 public:
  static constexpr double kFirstReach = 0.5;

  RandomTargets(std::string name, const Context& context)
      : Learner(std::move(name)),
        random_(context.seed),
        targets_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(context.robot->joints.size()))) {
    AddParameter({.name = "pace", .doc = "how fast the reach changes", .target = &pace_});
    AddCurve({"reach", "rad", "of a target, at most", &episode_reach_});
  }

  void Save(std::ostream& out) const override {
    out << random_ << ' ';
    out.write(reinterpret_cast<const char*>(&reach_), sizeof reach_);
  }
  void Load(std::istream& in) override {
    in >> random_;
    in.ignore();
    in.read(reinterpret_cast<char*>(&reach_), sizeof reach_);
  }

  const double& discount() const override { return discount_; }
  bool ends_at_once() const override { return true; }
  void ForgetCredit() override {}
  void Forget() override { reach_ = kFirstReach; }
  void StopLearning() override { pace_ = 0; }

 private:
  void SelectFirst() override { Select(); }
  void Execute() override { execute_(targets_); }
  void LearnAndSelect(double reward) override {
    Learn(reward);
    Select();
  }
  void LearnFromEnd(double reward, const EpisodeEnd&) override { Learn(reward); }
  void FinishEpisode() override { episode_reach_ = reach_; }

  void Select() {
    for (double& target : targets_) target = reach_ * (2 * random_.Uniform() - 1);
  }
  void Learn(double reward) {
    reach_ = std::clamp(reach_ + (reward > 0 ? pace_ : -pace_), 0.1, 1.0);
  }

  double discount_ = 1;
  double pace_ = 0.01;
  Random random_;
  double reach_ = kFirstReach;
  double episode_reach_ = 0;
  Eigen::VectorXd targets_;
  Signal<const Eigen::VectorXd&> execute_{this, "execute"};
};

}  // namespace runtime
