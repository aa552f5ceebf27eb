#include "runtime/analysis/probe/probe_page.h"

#include <gmock/gmock.h>

#include "tests/runtime/analysis/report/report_page.h"
#include "tests/runtime/analysis/study/sample_study.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::SizeIs;
using testing::StartsWith;

TEST(ProbePage, HasAllThatIsKnownOfTheFinds) {
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> runs;
  for (const uint64_t seed : {1u, 2u}) {
    runs.push_back(folder.path() / ("seed" + std::to_string(seed)));
    WriteStudyRun(runs.back(),
                  {.seed = seed, .speed = 0.3 * static_cast<double>(seed), .is_best = true});
  }
  const std::filesystem::path page = folder.path() / "probe.html";
  WriteProbePage(ReadProbe(folder.path(), runs), page);
  const json data = DataOfPage(page);
  EXPECT_EQ(data["title"], "crawling – what it pays for");
  EXPECT_EQ(data["searches"], 2);
  EXPECT_THAT(data["body"], SizeIs(18));
  ASSERT_THAT(data["finds"], SizeIs(2));
  const json& find = data["finds"][0];
  EXPECT_EQ(find["seed"], 2);
  EXPECT_EQ(find["recording"]["episode"], 40);
  const size_t frames = find["recording"]["frames"];
  EXPECT_THAT(Floats(find["recording"]["poses"]), SizeIs(frames * 18 * 7));
  EXPECT_THAT(find["strip"]["times"], SizeIs(8));
  EXPECT_TRUE(find["repetition"].is_null());  // no motion that is repeated
  EXPECT_THAT(find["strip"]["png"].get<std::string>(), StartsWith("iVBORw0KGgo"));  // of any PNG
}

}  // namespace
}  // namespace runtime
