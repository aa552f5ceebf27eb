#include "runtime/analysis/export/c_header.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <set>
#include <string_view>

namespace runtime {
namespace {

using Value = PolicyGraph::Value;

constexpr const char* kResult = "joint_targets";  // a parameter of policy_step

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

// What a comment's line can hold: other people's names must neither end it nor go on in the next.
std::string Comment(std::string_view text) {
  std::string safe(text);
  for (char& c : safe) {
    if (static_cast<unsigned char>(c) < 0x20 || c == '\\' || c == '?') c = '_';
  }
  return safe;
}

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
    text += fmt::format("  {},  // {}{}\n", Enumerator(prefix, name, taken), Comment(name),
                        unit.empty() ? "" : " [" + Comment(unit) + "]");
  }
  return text + "};\n";
}

std::string Literal(float value) {
  if (std::isinf(value)) return value > 0 ? "INFINITY" : "-INFINITY";
  std::string text = fmt::to_string(value);  // reads back to the same bits
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "f";
}

// The arrays and statements of the steps, from the first to the last.
class Statements {
 public:
  explicit Statements(const PolicyGraph& policy) : names_{"observation"}, sizes_{} {
    sizes_.push_back(static_cast<Eigen::Index>(policy.observation.size()));
    for (const PolicyGraph::Step& step : policy.steps) {
      const Value value = names_.size();
      const bool is_result = value == policy.joint_targets.value;
      names_.push_back(is_result ? kResult : fmt::format("value_{}", value));
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
    if (names_.back() == kResult) return;
    buffers_ += fmt::format("  float {}[{}];\n", names_.back(), size);
  }
  std::string Size() const { return fmt::to_string(sizes_.back()); }

  // Returns its name.
  std::string Array(const char* what, const Eigen::VectorXf& elements) {
    const std::string name = fmt::format("policy_{}_{}", what, names_.size() - 1);
    arrays_ += fmt::format("\nstatic const float {}[{}] = {{", name, elements.size());
    constexpr size_t kWidth = 100;
    size_t column = kWidth;
    for (const float element : elements) {
      const std::string word = Literal(element) + ",";
      if (column + 1 + word.size() > kWidth) {
        arrays_ += "\n   ";
        column = 3;
      }
      arrays_ += " " + word;
      column += 1 + word.size();
    }
    arrays_ += "\n};\n";
    return name;
  }

  void Call(const char* operation, const std::vector<std::string>& arguments) {
    calls_ +=
        fmt::format("  policy_{}({}, {});\n", operation, fmt::join(arguments, ", "), names_.back());
  }

  std::vector<std::string> names_;  // of the values
  std::vector<Eigen::Index> sizes_;
  std::string arrays_;
  std::string buffers_;
  std::string calls_;
};

std::string Introduction(const ExportedPolicy& policy) {
  std::string text = "// What a robot has learned, as a function of what it observes.\n//\n";
  for (const auto& [key, value] : policy.facts)
    text += fmt::format("//   {:<10} {}\n", key, Comment(value));
  return text + fmt::format(R"(//
// Call policy_step() every {:.9g} s, and hold the targets until then. Both arrays are in the order of
// the enumerations, in these units; observations are as they are measured.
#ifndef TASKC_POLICY_H
#define TASKC_POLICY_H

#include <math.h>

#define POLICY_OBSERVATIONS {}
#define POLICY_TARGETS {}
#define POLICY_SECONDS_PER_DECISION {}

)",
                            policy.seconds_per_decision, policy.graph.observation.size(),
                            policy.graph.joint_targets.elements.size(),
                            Literal(static_cast<float>(policy.seconds_per_decision)));
}

}  // namespace

std::string CHeaderOf(const ExportedPolicy& policy) {
  const Statements statements(policy.graph);
  return Introduction(policy) +
         Enumeration("policy_observation", "POLICY_OBSERVATION_", policy.graph.observation) + "\n" +
         Enumeration("policy_target", "POLICY_TARGET_", policy.graph.joint_targets.elements) +
         statements.arrays() + kOperations + R"(
static inline void policy_step(const float observation[], float joint_targets[]) {
)" + statements.buffers() +
         statements.calls() + "}\n\n#endif\n";
}

}  // namespace runtime
