// How far two scores put the same things in the same order.
#pragma once

#include <vector>

namespace runtime {

struct RankCorrelation {
  double spearman = 0;  // rho: of the ranks, equal scores at the mean of theirs
  double kendall = 0;   // tau-b: of the pairs
};

// From -1, the reverse order, to 1, the same. Not a number where there are fewer than two, or where
// all scores of one kind are equal. Precondition: as many of both, all finite.
RankCorrelation RankCorrelationOf(const std::vector<double>& first,
                                  const std::vector<double>& second);

// The place of each among all, the greatest score first, from 1; equal ones have the mean of their
// places.
std::vector<double> RanksOf(const std::vector<double>& scores);

}  // namespace runtime
