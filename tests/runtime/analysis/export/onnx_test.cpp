#include "runtime/analysis/export/onnx.h"

#include <gmock/gmock.h>

#include <map>

#include "runtime/analysis/export/onnx.pb.h"
#include "tests/runtime/analysis/export/sample_policy.h"

namespace runtime {
namespace {

using testing::ElementsAre;

onnx::ModelProto SampleModel() {
  onnx::ModelProto model;
  EXPECT_TRUE(model.ParseFromString(OnnxOf(SamplePolicy())));
  return model;
}

// That ONNX Runtime computes with such a file what the robot does is tested in
// tests/runtime/trainer/export_test.cpp.
TEST(Onnx, SaysWhatItsNumbersAre) {
  const onnx::ModelProto model = SampleModel();
  std::map<std::string, std::string> metadata;
  for (const onnx::StringStringEntryProto& entry : model.metadata_props())
    metadata[entry.key()] = entry.value();
  EXPECT_EQ(metadata["task"], "balance");
  EXPECT_EQ(metadata["decisions_per_second"], "25");
  EXPECT_EQ(metadata["observation"],
            R"([{"name":"tilt.pitch","unit":"rad","mean":0.25,"deviation":0.5},)"
            R"({"name":"tilt.pitch","unit":"rad/s","mean":0.0,"deviation":2.0}])");
  EXPECT_EQ(metadata["action"], R"([{"name":"left","unit":""}])");
  EXPECT_EQ(metadata["joint_targets"],
            R"([{"name":"left","unit":"rad"},{"name":"right*/","unit":"rad"}])");
}

TEST(Onnx, HoldsTheMotionThatItsPolicyStandsOn) {
  ExportedPolicy policy = SamplePolicy();
  policy.graph.motion = SampleMotion();
  onnx::ModelProto model;
  ASSERT_TRUE(model.ParseFromString(OnnxOf(policy)));
  const auto& entries = model.metadata_props();
  EXPECT_EQ(entries.rbegin()->key(), "motion");
  EXPECT_EQ(entries.rbegin()->value(),
            R"({"kind":"periodic","frequency":0.5,"joints":[)"
            R"({"name":"left","shape":[0.25,1.0,0.5],"low":-1.0,"high":1.0},)"
            R"({"name":"right*/","shape":[0.0,0.0,-0.5],"low":-0.25,"high":0.25}]})");
}

TEST(Onnx, TakesManyObservationsAtOnce) {
  const onnx::ModelProto model = SampleModel();
  const onnx::ValueInfoProto& input = model.graph().input(0);
  EXPECT_EQ(input.name(), "observation");
  const onnx::TensorShapeProto& shape = input.type().tensor_type().shape();
  EXPECT_EQ(shape.dim(0).dim_param(), "batch");
  EXPECT_EQ(shape.dim(1).dim_value(), 2);
  EXPECT_EQ(model.graph().output(0).name(), "joint_targets");
  EXPECT_EQ(model.graph().output(1).name(), "action");
}

TEST(Onnx, AMatrixHasAColumnForEachNumberThatComesOut) {
  const onnx::ModelProto model = SampleModel();
  std::map<std::string, std::vector<int64_t>> shapes;
  for (const onnx::TensorProto& tensor : model.graph().initializer())
    shapes[tensor.name()] = {tensor.dims().begin(), tensor.dims().end()};
  EXPECT_THAT(shapes["value_3_weights"], ElementsAre(2, 1));
  EXPECT_THAT(shapes["value_5_weights"], ElementsAre(1, 2));
}

}  // namespace
}  // namespace runtime
