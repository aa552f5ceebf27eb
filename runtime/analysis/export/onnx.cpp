#include "runtime/analysis/export/onnx.h"

#include <fmt/format.h>

#include <bit>
#include <nlohmann/json.hpp>

#include "runtime/analysis/export/little_endian.h"
#include "runtime/analysis/export/onnx.pb.h"

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;
using Value = PolicyGraph::Value;

constexpr int kFormatVersion = 7;  // the one that came with the set of operators
constexpr int kOperatorSet = 13;
constexpr const char* kInput = "observation";

std::vector<PolicyGraph::Output> OutputsOf(const PolicyGraph& policy) {
  std::vector<PolicyGraph::Output> outputs = {policy.result};
  outputs.insert(outputs.end(), policy.others.begin(), policy.others.end());
  return outputs;
}

class OnnxGraph {
 public:
  explicit OnnxGraph(const PolicyGraph& policy) : names_(policy.steps.size() + 1) {
    names_.front() = kInput;
    const std::vector<PolicyGraph::Output> outputs = OutputsOf(policy);
    for (const PolicyGraph::Output& output : outputs) names_[output.value] = output.name;
    for (const PolicyGraph::Step& step : policy.steps) {
      ++value_;
      if (names_[value_].empty()) names_[value_] = fmt::format("value_{}", value_);
      std::visit(*this, step);
    }
    Describe(kInput, policy.observation.size(), *graph_.add_input());
    for (const PolicyGraph::Output& output : outputs)
      Describe(output.name, output.elements.size(), *graph_.add_output());
  }

  onnx::GraphProto Take() { return std::move(graph_); }

  void operator()(const PolicyGraph::Normalize& step) {
    const std::string difference = names_[value_] + "_difference";
    AddNode("Sub", {names_[step.x], Constant("mean", step.mean)}, difference);
    AddNode("Mul", {difference, Constant("factor", step.factor)}, names_[value_]);
  }
  // A matrix whose columns lie one after the other is, row by row, its transpose: what Gemm wants.
  void operator()(const PolicyGraph::Affine& step) {
    const std::string factors = Constant("weights", {step.factors.cols(), step.factors.rows()},
                                         step.factors.reshaped().eval());
    AddNode("Gemm", {names_[step.x], factors, Constant("biases", step.offsets)}, names_[value_]);
  }
  void operator()(const PolicyGraph::Tanh& step) {
    AddNode("Tanh", {names_[step.x]}, names_[value_]);
  }
  void operator()(const PolicyGraph::Clamp& step) {
    const std::string raised = names_[value_] + "_raised";
    AddNode("Max", {names_[step.x], Constant("low", step.low)}, raised);
    AddNode("Min", {raised, Constant("high", step.high)}, names_[value_]);
  }

 private:
  void AddNode(const char* type, const std::vector<std::string>& inputs,
               const std::string& output) {
    onnx::NodeProto& node = *graph_.add_node();
    node.set_op_type(type);
    node.set_name(output);
    for (const std::string& input : inputs) node.add_input(input);
    node.add_output(output);
  }

  // Returns its name.
  std::string Constant(const char* what, const std::vector<int64_t>& shape,
                       const Eigen::VectorXf& elements) {
    onnx::TensorProto& tensor = *graph_.add_initializer();
    tensor.set_name(fmt::format("{}_{}", names_[value_], what));
    tensor.set_data_type(onnx::TensorProto::FLOAT);
    for (const int64_t size : shape) tensor.add_dims(size);
    for (const float element : elements)
      AppendLittleEndian(std::bit_cast<uint32_t>(element), *tensor.mutable_raw_data());
    return tensor.name();
  }
  std::string Constant(const char* what, const Eigen::VectorXf& elements) {
    return Constant(what, {elements.size()}, elements);
  }

  static void Describe(const std::string& name, size_t size, onnx::ValueInfoProto& value) {
    value.set_name(name);
    onnx::TypeProto::Tensor& type = *value.mutable_type()->mutable_tensor_type();
    type.set_elem_type(onnx::TensorProto::FLOAT);
    type.mutable_shape()->add_dim()->set_dim_param("batch");
    type.mutable_shape()->add_dim()->set_dim_value(static_cast<int64_t>(size));
  }

  onnx::GraphProto graph_;
  std::vector<std::string> names_;  // of the values
  Value value_ = 0;                 // that the present step makes
};

Json ElementsJson(const std::vector<PolicyElement>& elements) {
  Json list = Json::array();
  for (const auto& [name, unit] : elements) list.push_back({{"name", name}, {"unit", unit}});
  return list;
}

Json MotionJson(const PolicyGraph& policy) {
  const PolicyMotion& motion = *policy.motion;
  Json joints = Json::array();
  for (Eigen::Index i = 0; i < motion.shape.rows(); ++i) {
    const Eigen::RowVectorXd row = motion.shape.row(i);
    joints.push_back({{"name", policy.result.elements[static_cast<size_t>(i)].name},
                      {"shape", std::vector<double>(row.begin(), row.end())},
                      {"low", motion.low[i]},
                      {"high", motion.high[i]}});
  }
  return {{"kind", motion.is_periodic ? "periodic" : "one_shot"},
          {"frequency", motion.frequency},
          {"joints", std::move(joints)}};
}

// How the observation is measured, or null.
const PolicyGraph::Normalize* MeasureOf(const PolicyGraph& graph) {
  for (const PolicyGraph::Step& step : graph.steps) {
    const auto* measure = std::get_if<PolicyGraph::Normalize>(&step);
    if (measure != nullptr && measure->x == PolicyGraph::kObservation) return measure;
  }
  return nullptr;
}

// With as many digits as a float has.
double Rounded(float value) { return std::stod(fmt::to_string(value)); }

Json ObservationJson(const PolicyGraph& graph) {
  Json list = ElementsJson(graph.observation);
  const PolicyGraph::Normalize* measure = MeasureOf(graph);
  if (measure == nullptr) return list;
  for (size_t i = 0; i < list.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    list[i]["mean"] = Rounded(measure->mean[index]);
    list[i]["deviation"] = Rounded(1 / measure->factor[index]);
  }
  return list;
}

}  // namespace

std::string OnnxOf(const ExportedPolicy& policy) {
  onnx::ModelProto model;
  model.set_ir_version(kFormatVersion);
  model.set_producer_name("taskc");
  model.set_producer_version(TASKC_VERSION);
  model.add_opset_import()->set_version(kOperatorSet);
  *model.mutable_graph() = OnnxGraph(policy.graph).Take();
  model.mutable_graph()->set_name("policy");
  const auto add = [&](const std::string& key, const std::string& value) {
    onnx::StringStringEntryProto& entry = *model.add_metadata_props();
    entry.set_key(key);
    entry.set_value(value);
  };
  const auto text = [](const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  for (const auto& [key, value] : policy.facts) add(key, value);
  add("decisions_per_second", fmt::format("{:.9g}", 1 / policy.seconds_per_decision));
  add(kInput, text(ObservationJson(policy.graph)));
  for (const PolicyGraph::Output& output : OutputsOf(policy.graph))
    add(output.name, text(ElementsJson(output.elements)));
  if (policy.graph.motion) add("motion", text(MotionJson(policy.graph)));
  return model.SerializeAsString();
}

}  // namespace runtime
