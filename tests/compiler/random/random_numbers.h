// Random choices that are the same on every machine: of the standard library only the generator
// itself is that.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

namespace compiler {

class RandomNumbers {
 public:
  explicit RandomNumbers(uint32_t seed) : generator_(seed) {}

  // 0 .. end - 1
  uint32_t Below(size_t end) { return static_cast<uint32_t>(generator_() % end); }
  bool OneIn(uint32_t count) { return Below(count) == 0; }
  int64_t Bits() { return static_cast<int64_t>(uint64_t{generator_()} << 32 | generator_()); }

  template <typename Choice>
  const Choice& OneOf(const std::vector<Choice>& choices) {
    return choices[Below(choices.size())];
  }
  template <typename Choice>
  Choice OneOf(std::initializer_list<Choice> choices) {
    return choices.begin()[Below(choices.size())];
  }

 private:
  std::mt19937 generator_;
};

}  // namespace compiler
