#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"
#include "runtime/training/learning/gaussian_net.h"

namespace runtime {

// Features of an observation, by a grid over all of its elements: `counts` points along each,
// evenly spaced from `low` to `high`, ends included; the first element varies fastest.
//
//   kind "gaussian"  a normalized Gaussian network with its centers in the points (gaussian_net.h)
//   kind "table"     1 for the nearest point, 0 for all others: a table has an entry for each
//
//   in   observation
//   out  features: one for each point
//        net: the network; for a table the one that it would be
class GridFeatures : public Module {
 public:
  GridFeatures(std::string name, const Context& context);

  void Start() override { Net(); }

 private:
  // Made when it is first asked for: modules may be started in any order.
  const GaussianNet& Net();
  const Eigen::VectorXd& Features();

  void CheckParameters() const;
  Eigen::Index NearestPoint(const Eigen::VectorXd& observation) const;

  std::string kind_;
  std::vector<double> counts_, low_, high_, deviations_;
  bool max_norm_ = false;

  GaussianNet net_;
  Eigen::VectorXd features_;
  Eigen::Index entry_ = 0;  // of a table: the one that is 1

  In<Eigen::VectorXd> observation_in_{this, "observation"};
  Out<Eigen::VectorXd> features_out_{this, "features", Bind<&GridFeatures::Features>{}};
  Out<GaussianNet> net_out_{this, "net", Bind<&GridFeatures::Net>{}};
};

}  // namespace runtime
