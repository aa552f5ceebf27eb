// The emitted text itself, reviewed once and compared from then on.
#include "tests/golden.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/compiler/emit/emitted_text.h"

namespace compiler {
namespace {

std::string EmitFile(const std::filesystem::path& file) {
  return EmitText(golden::ReadFile(file), file.filename());
}

// The golden files outlive versions.
std::string WithoutVersion(std::string text) {
  const std::string version = "taskc " TASKC_VERSION;
  for (size_t at = 0; (at = text.find(version)) != std::string::npos;) {
    text.replace(at, version.size(), "taskc VERSION");
  }
  return text;
}

TEST(EmittedText, IsAsReviewed) {
  for (const auto& file : golden::FilesIn(SOURCE_DIR "/tests/compiler/emit/golden", "", ".task")) {
    std::filesystem::path expected = file;
    expected.replace_extension(".cpp.expected");
    golden::Expect(expected, WithoutVersion(EmitFile(file)));
  }
}

TEST(EmittedText, IsTheSameEveryTime) {
  std::filesystem::path file = SOURCE_DIR "/tests/compiler/emit/golden/vectors.task";
  EXPECT_EQ(EmitFile(file), EmitFile(file));
}

// Storeys of vector operations, each on top of the last: the text is linear in their number.
TEST(EmittedText, GrowsInProportionToTheTask) {
  auto size_of_tower = [](int storeys) {
    std::string text =
        "task tower\nsensor v: vec3\nsensor w: vec3\non end_of_action {\nlet x0 = v\n";
    for (int i = 1; i <= storeys; ++i) {
      text += fmt::format(
          "let x{1} = cross(cross(x{0} + w, w - x{0}), w * norm(w * norm(x{0} * 2)))\n", i - 1, i);
    }
    text += fmt::format("reward height = norm(x{})\nend_episode success \"up\" }}\n", storeys);
    return EmitText(text).size();
  };
  size_t base = size_of_tower(1);
  size_t ten = size_of_tower(11) - base;
  size_t twenty = size_of_tower(21) - base;
  EXPECT_LT(twenty, ten * 5 / 2);
}

// What a C++ compiler would take minutes for.
TEST(EmittedText, AsksForNoOptimizationOfALongFunction) {
  const auto text_of_loop = [](int passes) {
    return EmitText(
        fmt::format("task looping\nsensor v: real[9]\non end_of_action {{\n"
                    "  for i in 0..{} {{ reward a = i * norm(v) }}\n"
                    "  end_episode success \"\"\n}}\n",
                    passes));
  };
  const std::string unoptimized = "__attribute__((optimize(\"O0\")))";
  EXPECT_EQ(text_of_loop(50).find(unoptimized), std::string::npos);
  EXPECT_EQ(text_of_loop(50).find("for (int i"), std::string::npos);
  EXPECT_NE(text_of_loop(400).find(unoptimized), std::string::npos);
  EXPECT_NE(text_of_loop(400).find("for (int i"), std::string::npos);
}

TEST(EmittedText, OfNestedVectorOperationsStaysSmall) {
  std::string nested = "v";
  for (int i = 0; i < 12; ++i) nested = fmt::format("cross({}, w) * norm(w)", nested);
  std::string text =
      fmt::format("task nested\nsensor v: vec3\nsensor w: vec3\nmetric size = norm({})\n", nested);
  EXPECT_LT(EmitText(text).size(), 10000u);
}

}  // namespace
}  // namespace compiler
