// A target without libFuzzer: mutated texts, one after the other. Call it as libFuzzer is called,
//
//     fuzz_parse [-runs=N] [-max_total_time=SECONDS] [-seed=N] [file...]
//
// With files it runs only those, once each: a text that failed. The text at work is always in the
// file `last-input`, so that a crash leaves it there.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "fuzz/mutator.h"
#include "fuzz/targets.h"

namespace {

constexpr const char* kLastInput = "last-input";

struct Options {
  long runs = -1;
  long seconds = -1;
  uint32_t seed = 1;
  std::vector<std::string> files;
};

Options ParseOptions(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    const char* value = std::strchr(argv[i], '=');
    if (value == nullptr) {
      options.files.emplace_back(argument);
    } else if (argument.starts_with("-runs=")) {
      options.runs = std::atol(value + 1);
    } else if (argument.starts_with("-max_total_time=")) {
      options.seconds = std::atol(value + 1);
    } else if (argument.starts_with("-seed=")) {
      options.seed = static_cast<uint32_t>(std::atol(value + 1));
    }
  }
  return options;
}

bool RunAndRemember(const fuzz::Target& target, const std::string& text) {
  const int file = open(kLastInput, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0 || write(file, text.data(), text.size()) < 0) std::perror(kLastInput);
  close(file);
  const auto begin = std::chrono::steady_clock::now();
  const bool is_right = target.run(text);
  const auto took = std::chrono::steady_clock::now() - begin;
  constexpr std::chrono::seconds kTooLong(10);  // with sanitizers, on a busy machine
  if (took < kTooLong) return is_right;
  std::fprintf(stderr, "fuzz: this text took too long\n");
  std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = ParseOptions(argc, argv);
  const fuzz::Target& target = fuzz::FindTarget(FUZZ_TARGET);
  for (const std::string& name : options.files) {
    std::ifstream file(name, std::ios::binary);
    RunAndRemember(target,
                   {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
  }
  if (!options.files.empty()) return 0;

  fuzz::Mutator mutator(target.corpus(), target.words(), options.seed);
  const auto begin = std::chrono::steady_clock::now();
  long run = 0, right = 0;
  for (; options.runs < 0 || run < options.runs; ++run) {
    const auto passed = std::chrono::steady_clock::now() - begin;
    if (options.seconds >= 0 && passed > std::chrono::seconds(options.seconds)) break;
    right += RunAndRemember(target, mutator.Next());
  }
  std::remove(kLastInput);
  std::printf("%s: %ld texts, %ld of them right, nothing found\n", target.name, run, right);
}
