// The largest file costs little memory, whatever stands in it.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "compiler/source/sources.h"
#include "compiler/syntax/parse.h"

namespace compiler {
namespace {

// `piece` again and again between `begin` and `end`, as often as fits into a file.
std::string LargestFile(const std::string& begin, const std::string& piece,
                        const std::string& end) {
  std::string text = begin;
  while (text.size() + piece.size() + end.size() <= SourceFile::kMaxSize) text += piece;
  return text + end;
}

// What a process of its own needs at most for parsing the text and showing what is wrong with it.
long PeakMegabytes(const std::string& text) {
  const pid_t child = fork();
  if (child == 0) {
    Sources sources;
    const SourceFile& source = sources.Add("large.task", text);
    Diagnostics diagnostics;
    Parse(source, diagnostics);
    Render(sources, diagnostics, false);
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  EXPECT_EQ(wait4(child, &status, 0, &usage), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  return usage.ru_maxrss / 1024;
}

TEST(MemoryLimit, HoldsForTheLargestFiles) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer needs memory of its own";
#endif
  constexpr long kMost = 200;  // about twice what is needed
  const std::string event = "task t\non end_of_action {\n";
  std::string brackets = "a";
  for (uint32_t i = 0; i + 2 < kMaxNesting; ++i) brackets = "(" + brackets + ")";
  EXPECT_LT(PeakMegabytes(LargestFile(event, "n=1\n", "}\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile(event, "if a{}", "}\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile(event, "for i in{0}{}", "}\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile("task t\nmetric d=max(1", ",1", ")\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile("task t\nmetric d=max(1", ",1", ",)\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile("task t\nmetric d=c[a", ",{a}", "]\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile("task t\nmetric d=max(a", "," + brackets, ")\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile("task t\nfn f(a:b", ",a:b", ")->b=1\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile("task t\ntest \"a\"{", "given a=1 ", "}\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile(event, "n=1 1\n", "}\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile(event, "if\n", "\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile("task t\n", "\"\n", "\n")), kMost);
  EXPECT_LT(PeakMegabytes(LargestFile("task t\n", "@", "\n")), kMost);
}

}  // namespace
}  // namespace compiler
