// A target under libFuzzer, which comes with clang. Its own mutations and ours take turns.
#include <cstdint>
#include <cstring>

#include "fuzz/corpus.h"
#include "fuzz/mutator.h"
#include "fuzz/targets.h"

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);

namespace {

const fuzz::Target& Target() {
  static const fuzz::Target& target = fuzz::FindTarget(FUZZ_TARGET);
  return target;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Target().run(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size,
                                          unsigned seed) {
  static const std::vector<std::string> corpus = Target().corpus();
  static const std::vector<std::string> words = Target().words();
  static fuzz::Mutator mutator(corpus, words, seed);
  if (seed % 4 == 0) return LLVMFuzzerMutate(data, size, max_size);
  // libFuzzer begins with nothing unless it is given a folder of texts.
  std::string text = size < 4 ? mutator.Next() : std::string(data, data + size);
  text = mutator.Change(std::move(text), max_size);
  if (text.size() > max_size) text.resize(max_size);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}
