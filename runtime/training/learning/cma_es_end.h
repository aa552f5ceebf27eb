#pragma once

#include <iosfwd>
#include <vector>

#include "runtime/training/learning/cma_es.h"

namespace runtime {

// Whether a search with CMA-ES has come to its end, by the criteria in the tutorial's appendix B.3:
//
//   narrow       all candidates are within `least_step` of each other (TolX)
//   flat         no costs differ by more than 1e-12: the best ones of the last 10 + 30 n / lambda
//                generations, and all of the last one (TolFun)
//   stagnating   over the last fifth of the generations, at least 120 + 30 n / lambda, neither best
//                nor median costs became less
//   stretched    candidates are spread 10^7 times as far along one axis as along another
//                (ConditionCov)
//   diverging    they are spread 10^4 times as far as at first (TolXUp)
class CmaEsEnd {
 public:
  // A generation of `search` is over. Allocates now and then.
  void Note(const CmaEs& search);

  bool IsReached(const CmaEs& search, double first_sigma, double least_step) const;

  void Save(std::ostream& out) const;
  // The stream has failed where it holds something else; then nothing has changed.
  void Load(std::istream& in);

 private:
  bool IsFlat(const CmaEs& search) const;
  bool IsStagnating(const CmaEs& search) const;

  std::vector<double> best_;    // cost of each generation
  std::vector<double> median_;  // the same
};

}  // namespace runtime
