// The Bradley-Terry model of what a user prefers, as a function of a task's weights.
//
// A term that pays a weight times something pays f times as much where the weight is f times what
// it was. So the sums of the terms, recorded once, tell an episode's return under any weights: the
// sum over terms of sum * exp(loads * x), with the logarithms x of the weights' ratios, new to
// recorded. The terms without a weight fix the scale.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace runtime {

// Two behaviors about which the user has said something.
struct Comparison {
  Eigen::VectorXd difference;  // the better one's sum of each term minus the worse one's
  double outcome = 1;          // 0.5 where the two are equally good

  bool is_tie() const { return outcome == 0.5; }
};

struct PreferenceModel {
  Eigen::MatrixXd loads;  // terms x weights: 1 where the weight scales the term, else 0
  std::vector<Comparison> comparisons;
  double scale = 1;       // of differences of returns: of one scale, 73 % prefer the higher return
  double prior_sd = 1;    // of each x; its mean is 0
  Eigen::VectorXd lower;  // bounds of x
  Eigen::VectorXd upper;
};

// What each term pays, as a multiple of what it paid.
Eigen::VectorXd TermFactors(const Eigen::MatrixXd& loads, const Eigen::VectorXd& x);

// By how many scales the first of two behaviors is better; its logistic function is the
// probability with which a user prefers it. `gradient`: gets the derivatives by x, unless null.
double Advantage(const PreferenceModel& model, const Eigen::VectorXd& difference,
                 const Eigen::VectorXd& x, Eigen::VectorXd* gradient = nullptr);

double Logistic(double advantage);

// Whether the returns say what the user said; equally good are those within a scale of each other.
bool Holds(const Comparison& comparison, double advantage);

// -log(likelihood * prior), but for a constant.
double NegativeLogPosterior(const PreferenceModel& model, const Eigen::VectorXd& x,
                            Eigen::VectorXd* gradient = nullptr);

// Fisher's information of the comparisons at x, and that of the prior: the expected Hessian of
// NegativeLogPosterior, whose inverse is about the covariance of x.
Eigen::MatrixXd Information(const PreferenceModel& model, const Eigen::VectorXd& x);

}  // namespace runtime
