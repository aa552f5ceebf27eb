// Texts that are nearly right: what a fuzzer feeds to its target.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace fuzz {

class Mutator {
 public:
  // `corpus`: whole texts to begin with; `dictionary`: pieces that mean something to the target.
  Mutator(std::vector<std::string> corpus, std::vector<std::string> dictionary, uint32_t seed);

  // The same texts for the same seed on every machine.
  std::string Next();
  // `text` with a few changes, at most `largest` bytes long.
  std::string Change(std::string text, size_t largest = kLargest);

 private:
  static constexpr size_t kLargest = 20'000;  // bytes: a mutated text stays quick to read

  size_t Below(size_t end) { return random_() % end; }
  void ChangeOnce(std::string& text);
  const std::string& Word() { return dictionary_[Below(dictionary_.size())]; }
  std::string PieceOfCorpus();
  // Puts one of the text's words, or of the dictionary's, in the place of another.
  void ExchangeWord(std::string& text);

  std::vector<std::string> corpus_;
  std::vector<std::string> dictionary_;
  std::mt19937 random_;
};

}  // namespace fuzz
