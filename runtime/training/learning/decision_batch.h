#pragma once

#include <Eigen/Core>
#include <iosfwd>
#include <vector>

namespace runtime {

// The decisions of some episodes, until they are learned from: what was observed, what was done,
// and what it brought. A column is a decision, or the last observation of an episode, which
// follows its decisions and has no action.
class DecisionBatch {
 public:
  struct Episode {
    int first = 0;             // column
    int decisions = 0;         // in the columns from there on; then comes the last observation
    bool is_terminal = false;  // nothing is worth anything after it
  };

  DecisionBatch() = default;
  DecisionBatch(int observation_size, int action_size)
      : observations_(observation_size, 0), actions_(action_size, 0) {}

  void Add(const Eigen::VectorXf& observation, const Eigen::VectorXf& action, double reward);
  // What was added since the last episode's end is an episode.
  void EndEpisode(const Eigen::VectorXf& last_observation, bool is_terminal);
  // The episodes that have ended in `other`, whose decisions have the same sizes, after those here.
  // Precondition: all that was added here is part of an episode.
  void Append(const DecisionBatch& other);
  // What was added since then is no part of any.
  void DropUnfinished() { columns_ = finished_columns_; }
  void Clear();

  // Whether decisions have the same sizes.
  bool IsLike(const DecisionBatch& other) const {
    return observations_.rows() == other.observations_.rows() &&
           actions_.rows() == other.actions_.rows();
  }
  int decisions() const { return decisions_; }  // of the episodes that have ended
  const std::vector<Episode>& episodes() const { return episodes_; }

  // Columns, also those of an episode that has not ended.
  auto observations() const { return observations_.leftCols(columns_); }
  auto actions() const { return actions_.leftCols(columns_); }
  const std::vector<double>& rewards() const { return rewards_; }

  // The episodes that have ended.
  void Save(std::ostream& out) const;
  // The stream has failed where it holds something else than decisions of these sizes.
  void Load(std::istream& in);

 private:
  void AppendColumn(const Eigen::VectorXf& observation);
  // Room for as many columns, at least.
  void MakeRoom(int columns);

  Eigen::MatrixXf observations_;
  Eigen::MatrixXf actions_;
  std::vector<double> rewards_;  // one for each column that there is room for
  std::vector<Episode> episodes_;
  int columns_ = 0;
  int finished_columns_ = 0;
  int decisions_ = 0;
};

}  // namespace runtime
