#include "base/cache/entry_name.h"

#include <gtest/gtest.h>

namespace cache {
namespace {

constexpr const char* kKey = "0123456789abcdef0123456789abcdef";

// As mkstemp() and mkdtemp() fill in their pattern.
std::string Made(std::string pattern) { return pattern.replace(pattern.size() - 6, 6, "x7Qp2a"); }

TEST(EntryName, SaysWhatAnEntryIs) {
  for (const char* task : {"crawling", "a", "_very_long_9", "net", "refused", "building"}) {
    EXPECT_EQ(KindOf(PluginName(task, kKey)), EntryKind::kFile) << task;
    EXPECT_EQ(KindOf(RefusalName(task, kKey)), EntryKind::kEvidence) << task;
    EXPECT_EQ(KindOf(DifferenceName(task, kKey)), EntryKind::kEvidence) << task;
    EXPECT_EQ(KindOf(Made(UnfinishedName(task, kKey))), EntryKind::kUnfinished) << task;
  }
  EXPECT_EQ(KindOf(NetName(kKey)), EntryKind::kFile);
}

TEST(EntryName, TellsOursFromThoseOfOthers) {
  const std::string key = kKey;
  for (const std::string& name : {std::string(),
                                  std::string("."),
                                  std::string("libfoo.so"),
                                  std::string("libfoo.so.1.2"),
                                  std::string("building-site"),
                                  std::string("building-blocks"),
                                  std::string("refused-task"),
                                  std::string("net-work"),
                                  key,
                                  key + ".so",
                                  "-" + key + ".so",
                                  "crawling-" + key,
                                  "crawling-" + key + ".so.1",
                                  "crawling-" + key + ".sol",
                                  "crawling-" + key + "0.so",
                                  "crawling-" + key.substr(1) + ".so",
                                  "crawling-" + key.substr(1) + "G.so",
                                  "crawling-" + key.substr(1) + "A.so",
                                  "cra.wling-" + key + ".so",
                                  "my-net-" + key,
                                  "nets-" + key,
                                  "net-" + key + "0",
                                  "refused-" + key,
                                  "refused-a-" + key + "0",
                                  "building-" + key,
                                  "building-a-" + key,
                                  "building-a-" + key + "-12345",
                                  "building-a-" + key + "-12345.",
                                  "building-" + key + "-x7Qp2a"}) {
    EXPECT_EQ(KindOf(name), EntryKind::kForeign) << name;
  }
}

}  // namespace
}  // namespace cache
