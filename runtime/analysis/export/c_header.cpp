#include "runtime/analysis/export/c_header.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <set>
#include <string_view>

#include "runtime/analysis/export/c_motion.h"
#include "runtime/analysis/export/c_text.h"

namespace runtime {
namespace {

using Value = PolicyGraph::Value;

constexpr const char* kOperations = R"(
static inline void policy_normalize(int size, const float x[], const float mean[],
                                    const float factor[], float y[]) {
  for (int i = 0; i < size; ++i) y[i] = (x[i] - mean[i]) * factor[i];
}

static inline void policy_affine(int inputs, int outputs, const float x[], const float weights[],
                                 const float biases[], float y[]) {
  for (int i = 0; i < outputs; ++i) {
    float sum = biases[i];
    for (int j = 0; j < inputs; ++j) sum += weights[i * inputs + j] * x[j];
    y[i] = sum;
  }
}

static inline void policy_tanh(int size, const float x[], float y[]) {
  for (int i = 0; i < size; ++i) y[i] = tanhf(x[i]);
}

static inline void policy_clamp(int size, const float x[], const float low[], const float high[],
                                float y[]) {
  for (int i = 0; i < size; ++i) y[i] = x[i] < low[i] ? low[i] : x[i] > high[i] ? high[i] : x[i];
}
)";

std::string Enumerator(const std::string& prefix, std::string_view name,
                       std::set<std::string>& taken) {
  std::string word = prefix;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    } else if (!word.ends_with('_')) {
      word += '_';
    }
  }
  if (word.ends_with('_')) word.pop_back();
  std::string unique = word;
  for (int i = 2; !taken.insert(unique).second; ++i) unique = fmt::format("{}_{}", word, i);
  return unique;
}

std::string Enumeration(const char* type, const char* prefix,
                        const std::vector<PolicyElement>& elements) {
  std::string text = fmt::format("enum {} {{\n", type);
  std::set<std::string> taken;
  for (const auto& [name, unit] : elements) {
    text += fmt::format("  {},  // {}{}\n", Enumerator(prefix, name, taken), CComment(name),
                        unit.empty() ? "" : " [" + CComment(unit) + "]");
  }
  return text + "};\n";
}

// The arrays and statements of the steps, from the first to the last.
class Statements {
 public:
  explicit Statements(const PolicyGraph& policy)
      : result_(policy.result.name), names_{"observation"}, sizes_{} {
    sizes_.push_back(static_cast<Eigen::Index>(policy.observation.size()));
    for (const PolicyGraph::Step& step : policy.steps) {
      const Value value = names_.size();
      const bool is_result = value == policy.result.value;
      names_.push_back(is_result ? policy.result.name : fmt::format("value_{}", value));
      std::visit(*this, step);
    }
  }

  const std::string& arrays() const { return arrays_; }
  const std::string& buffers() const { return buffers_; }
  const std::string& calls() const { return calls_; }

  void operator()(const PolicyGraph::Normalize& step) {
    SetSize(step.mean.size());
    Call("normalize",
         {Size(), names_[step.x], Array("mean", step.mean), Array("factor", step.factor)});
  }
  // A row for each element that comes out.
  void operator()(const PolicyGraph::Affine& step) {
    SetSize(step.factors.rows());
    const Eigen::VectorXf rows = step.factors.transpose().reshaped();
    Call("affine", {fmt::to_string(step.factors.cols()), Size(), names_[step.x],
                    Array("weights", rows), Array("biases", step.offsets)});
  }
  void operator()(const PolicyGraph::Tanh& step) {
    SetSize(sizes_[step.x]);
    Call("tanh", {Size(), names_[step.x]});
  }
  void operator()(const PolicyGraph::Clamp& step) {
    SetSize(step.low.size());
    Call("clamp", {Size(), names_[step.x], Array("low", step.low), Array("high", step.high)});
  }

 private:
  // Of the value that the present step makes.
  void SetSize(Eigen::Index size) {
    sizes_.push_back(size);
    if (names_.back() == result_) return;
    buffers_ += fmt::format("  float {}[{}];\n", names_.back(), size);
  }
  std::string Size() const { return fmt::to_string(sizes_.back()); }

  // Returns its name.
  std::string Array(const char* what, const Eigen::VectorXf& elements) {
    const std::string name = fmt::format("policy_{}_{}", what, names_.size() - 1);
    arrays_ += CArray(name, elements);
    return name;
  }

  void Call(const char* operation, const std::vector<std::string>& arguments) {
    calls_ +=
        fmt::format("  policy_{}({}, {});\n", operation, fmt::join(arguments, ", "), names_.back());
  }

  const std::string& result_;
  std::vector<std::string> names_;  // of the values
  std::vector<Eigen::Index> sizes_;
  std::string arrays_;
  std::string buffers_;
  std::string calls_;
};

// How often what is to be called, and what comes of it.
std::string Usage(const ExportedPolicy& policy) {
  const std::string decisions =
      fmt::format("// Call policy_step() every {:.9g} s", policy.seconds_per_decision);
  if (!policy.graph.motion) return decisions + ", and hold the targets until then.";
  return decisions + R"(: it says how far the targets are from a motion.
// Call policy_targets() in each step of the controller, with the time since the motion began, for
// the targets.)";
}

std::string Introduction(const ExportedPolicy& policy) {
  std::string text = "// What a robot has learned, as a function of what it observes.\n//\n";
  for (const auto& [key, value] : policy.facts)
    text += fmt::format("//   {:<10} {}\n", key, CComment(value));
  return text + fmt::format(R"(//
{} All arrays are in
// the order of the enumerations, in these units; observations are as they are measured.
#ifndef TASKC_POLICY_H
#define TASKC_POLICY_H

#include <math.h>

#define POLICY_OBSERVATIONS {}
#define POLICY_TARGETS {}
#define POLICY_SECONDS_PER_DECISION {}

)",
                            Usage(policy), policy.graph.observation.size(),
                            policy.graph.result.elements.size(),
                            CLiteral(static_cast<float>(policy.seconds_per_decision)));
}

}  // namespace

std::string CHeaderOf(const ExportedPolicy& policy) {
  const PolicyGraph& graph = policy.graph;
  const Statements statements(graph);
  return Introduction(policy) +
         Enumeration("policy_observation", "POLICY_OBSERVATION_", graph.observation) + "\n" +
         Enumeration("policy_target", "POLICY_TARGET_", graph.result.elements) +
         statements.arrays() + kOperations +
         fmt::format("\nstatic inline void policy_step(const float observation[], float {}[]) {{\n",
                     graph.result.name) +
         statements.buffers() + statements.calls() + "}\n" +
         (graph.motion ? CMotion(*graph.motion) : "") + "\n#endif\n";
}

}  // namespace runtime
