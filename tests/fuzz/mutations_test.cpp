// A short run of every fuzzer: whatever the text, the compiler answers soon, in little memory.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <ostream>
#include <string>

#include "fuzz/mutator.h"
#include "fuzz/targets.h"

namespace fuzz {
// In the names of the tests.
void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

namespace {

constexpr int kTexts = 1000;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;  // slower, and with maps of its own as large as all memory
#else
constexpr bool kIsSanitized = false;
#endif
constexpr time_t kSeconds = kIsSanitized ? 10 : 1;  // for one text
constexpr rlim_t kMemory = 200'000'000;             // bytes, beyond what the program has already

rlim_t MemoryInUse() {
  std::ifstream file("/proc/self/statm");
  rlim_t pages = 0;
  file >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void LimitMemory() {
  if (kIsSanitized) return;
  const rlim_t size = MemoryInUse() + kMemory;
  const rlimit limit{size, size};
  setrlimit(RLIMIT_AS, &limit);
}

// A text that takes longer ends the process by a signal.
void LimitTime() {
  const itimerval timer{{0, 0}, {kSeconds, 0}};
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

// Memory that the child process shares with us, so that we know its last text.
class SharedText {
 public:
  SharedText()
      : text_(static_cast<char*>(
            mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0))) {}
  ~SharedText() { munmap(text_, kSize); }
  SharedText(const SharedText&) = delete;
  SharedText& operator=(const SharedText&) = delete;

  void Set(const std::string& text) {
    const size_t size = std::min(text.size(), kSize - sizeof size);
    std::memcpy(text_, &size, sizeof size);
    std::memcpy(text_ + sizeof size, text.data(), size);
  }
  std::string Get() const {
    size_t size = 0;
    std::memcpy(&size, text_, sizeof size);
    return {text_ + sizeof size, size};
  }

 private:
  static constexpr size_t kSize = 1 << 16;
  char* text_;
};

[[noreturn]] void RunAll(const Target& target, SharedText& last) {
  Mutator mutator(target.corpus(), target.words(), 20121);
  target.run(mutator.Next());  // whatever is read only once
  LimitMemory();
  int right = 0;
  for (int i = 0; i < kTexts; ++i) {
    const std::string text = mutator.Next();
    last.Set(text);
    LimitTime();
    right += target.run(text);
  }
  // Of texts that are all refused, what comes behind the refusal was not tried.
  last.Set("(all texts)");
  _exit(right > 0 ? 0 : 1);
}

class Mutations : public testing::TestWithParam<Target> {};

TEST_P(Mutations, AreAnsweredSoonInLittleMemory) {
  SharedText last;
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) RunAll(GetParam(), last);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0) << (WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "") << "\n"
                       << last.Get();
}

INSTANTIATE_TEST_SUITE_P(Targets, Mutations, testing::ValuesIn(Targets()),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace fuzz
