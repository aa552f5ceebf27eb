#include "runtime/training/learning/decision_batch.h"

#include <algorithm>
#include <istream>
#include <ostream>

#include "runtime/training/learning/saved_matrix.h"

namespace runtime {

void DecisionBatch::MakeRoom(int columns) {
  constexpr int kLeastRoom = 1024;
  if (columns <= observations_.cols()) return;
  const Eigen::Index room = std::max({kLeastRoom, columns, 2 * columns_});
  observations_.conservativeResize(Eigen::NoChange, room);
  actions_.conservativeResize(Eigen::NoChange, room);
  rewards_.resize(static_cast<size_t>(room));
}

void DecisionBatch::AppendColumn(const Eigen::VectorXf& observation) {
  MakeRoom(columns_ + 1);
  observations_.col(columns_) = observation;
  ++columns_;
}

void DecisionBatch::Add(const Eigen::VectorXf& observation, const Eigen::VectorXf& action,
                        double reward) {
  AppendColumn(observation);
  actions_.col(columns_ - 1) = action;
  rewards_[static_cast<size_t>(columns_ - 1)] = reward;
}

void DecisionBatch::EndEpisode(const Eigen::VectorXf& last_observation, bool is_terminal) {
  const int count = columns_ - finished_columns_;
  if (count == 0) return;
  AppendColumn(last_observation);
  actions_.col(columns_ - 1).setZero();
  rewards_[static_cast<size_t>(columns_ - 1)] = 0;
  episodes_.push_back({finished_columns_, count, is_terminal});
  finished_columns_ = columns_;
  decisions_ += count;
}

void DecisionBatch::Append(const DecisionBatch& other) {
  const int count = other.finished_columns_;
  MakeRoom(columns_ + count);
  observations_.middleCols(columns_, count) = other.observations_.leftCols(count);
  actions_.middleCols(columns_, count) = other.actions_.leftCols(count);
  std::copy_n(other.rewards_.begin(), count, rewards_.begin() + columns_);
  for (Episode episode : other.episodes_) {
    episode.first += columns_;
    episodes_.push_back(episode);
  }
  columns_ += count;
  finished_columns_ = columns_;
  decisions_ += other.decisions_;
}

void DecisionBatch::Clear() {
  episodes_.clear();
  columns_ = 0;
  finished_columns_ = 0;
  decisions_ = 0;
}

void DecisionBatch::Save(std::ostream& out) const {
  out << episodes_.size() << ' ';
  for (const Episode& episode : episodes_) {
    out << episode.decisions << ' ' << episode.is_terminal << ' ';
  }
  SaveMatrix(out, observations_.leftCols(finished_columns_).cast<double>());
  SaveMatrix(out, actions_.leftCols(finished_columns_).cast<double>());
  SaveMatrix(out, Eigen::Map<const Eigen::VectorXd>(rewards_.data(), finished_columns_));
}

void DecisionBatch::Load(std::istream& in) {
  Clear();
  size_t episodes = 0;
  in >> episodes;
  for (size_t i = 0; i < episodes && in; ++i) {
    Episode& episode = episodes_.emplace_back();
    in >> episode.decisions >> episode.is_terminal;
    episode.first = columns_;
    if (episode.decisions < 1 ||
        episode.decisions > std::numeric_limits<int>::max() - columns_ - 1) {
      return in.setstate(std::ios::failbit);
    }
    decisions_ += episode.decisions;
    columns_ += episode.decisions + 1;
  }
  const Eigen::MatrixXd observations = LoadMatrix(in);
  const Eigen::MatrixXd actions = LoadMatrix(in);
  const Eigen::MatrixXd rewards = LoadMatrix(in);
  if (observations.rows() != observations_.rows() || observations.cols() != columns_ ||
      actions.rows() != actions_.rows() || actions.cols() != columns_ ||
      rewards.size() != columns_) {
    return in.setstate(std::ios::failbit);
  }
  observations_ = observations.cast<float>();
  actions_ = actions.cast<float>();
  rewards_.assign(rewards.data(), rewards.data() + rewards.size());
  finished_columns_ = columns_;
}

}  // namespace runtime
