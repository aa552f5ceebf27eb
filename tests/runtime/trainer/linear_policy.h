// The least that learns from what it sees: a module that nothing of the program knows.
#pragma once

#include <Eigen/Core>
#include <istream>
#include <limits>
#include <ostream>
#include <string>
#include <utility>

#include "runtime/core/module/connections.h"
#include "runtime/core/module/context.h"
#include "runtime/core/module/observations.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/learning/random.h"

namespace runtime {

// Joint targets that are linear in what is observed: in each episode other factors, near the best
// ones so far, which they replace where they earn more.
class LinearPolicy : public Learner {
 public:
  LinearPolicy(std::string name, const Context& context)
      : Learner(std::move(name)),
        random_(context.seed),
        targets_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(context.robot->joints.size()))) {
    AddParameter({.name = "step", .doc = "from the best factors", .target = &step_});
    AddCurve({"seen", "", "the length of what was seen last", &seen_});
  }

  void Start() override {
    RequireConnections(*this);
    const auto size = static_cast<Eigen::Index>(layout_().size());
    if (best_.size() == 0) best_ = Eigen::MatrixXd::Zero(targets_.size(), size);
  }

  void Save(std::ostream& out) const override {
    out << random_ << ' ';
    const Eigen::Index shape[] = {best_.rows(), best_.cols()};
    out.write(reinterpret_cast<const char*>(shape), sizeof shape);
    out.write(reinterpret_cast<const char*>(best_.data()), SizeOf(best_));
    out.write(reinterpret_cast<const char*>(&best_return_), sizeof best_return_);
  }
  void Load(std::istream& in) override {
    in >> random_;
    in.ignore();
    Eigen::Index shape[2] = {};
    in.read(reinterpret_cast<char*>(shape), sizeof shape);
    best_.resize(shape[0], shape[1]);
    in.read(reinterpret_cast<char*>(best_.data()), SizeOf(best_));
    in.read(reinterpret_cast<char*>(&best_return_), sizeof best_return_);
  }

  const double& discount() const override { return discount_; }
  bool ends_at_once() const override { return true; }
  void ForgetCredit() override {}
  void Forget() override {
    best_.setZero();
    best_return_ = -std::numeric_limits<double>::infinity();
  }
  void StopLearning() override { step_ = 0; }

 private:
  static std::streamsize SizeOf(const Eigen::MatrixXd& matrix) {
    return static_cast<std::streamsize>(matrix.size() * static_cast<Eigen::Index>(sizeof(double)));
  }

  void SelectFirst() override {
    factors_ = best_;
    for (double& factor : factors_.reshaped()) factor += step_ * (2 * random_.Uniform() - 1);
    Select();
  }
  void Execute() override { execute_(targets_); }
  void LearnAndSelect(double) override { Select(); }
  void LearnFromEnd(double, const EpisodeEnd&) override {}
  void FinishEpisode() override {
    if (step_ == 0 || episode_return() <= best_return_) return;
    best_ = factors_;
    best_return_ = episode_return();
  }

  void Select() {
    const Eigen::VectorXd& observed = observation_();
    seen_ = observed.norm();
    targets_ = (factors_ * observed).array().tanh();
  }

  const double discount_ = 1;
  double step_ = 0.1;
  Random random_;
  Eigen::MatrixXd best_;
  double best_return_ = -std::numeric_limits<double>::infinity();
  Eigen::MatrixXd factors_;  // of this episode
  Eigen::VectorXd targets_;
  double seen_ = 0;
  In<Eigen::VectorXd> observation_{this, "observation"};
  In<ObservationLayout> layout_{this, "layout"};
  Signal<const Eigen::VectorXd&> execute_{this, "execute"};
};

}  // namespace runtime
