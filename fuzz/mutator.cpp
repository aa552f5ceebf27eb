#include "fuzz/mutator.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace fuzz {
namespace {

bool IsOfWord(char character) {
  return std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '_';
}

// Where the word around or behind `place` begins and ends.
std::pair<size_t, size_t> WordAt(const std::string& text, size_t place) {
  const auto at = [&](size_t i) { return text.begin() + static_cast<std::ptrdiff_t>(i); };
  size_t begin = static_cast<size_t>(std::find_if(at(place), text.end(), IsOfWord) - text.begin());
  const size_t end =
      static_cast<size_t>(std::find_if_not(at(begin), text.end(), IsOfWord) - text.begin());
  while (begin > 0 && IsOfWord(text[begin - 1])) --begin;
  return {begin, end};
}

}  // namespace

Mutator::Mutator(std::vector<std::string> corpus, std::vector<std::string> dictionary,
                 uint32_t seed)
    : corpus_(std::move(corpus)), dictionary_(std::move(dictionary)), random_(seed) {}

std::string Mutator::Next() { return Change(corpus_[Below(corpus_.size())]); }

std::string Mutator::Change(std::string text, size_t largest) {
  for (size_t i = 0, count = 1 + Below(3); i < count; ++i) ChangeOnce(text);
  if (text.size() > largest) text.resize(largest);
  return text;
}

std::string Mutator::PieceOfCorpus() {
  const std::string& text = corpus_[Below(corpus_.size())];
  const size_t begin = Below(text.size() + 1);
  return text.substr(begin, Below(80));
}

void Mutator::ExchangeWord(std::string& text) {
  const auto [begin, end] = WordAt(text, Below(text.size() + 1));
  const auto [other_begin, other_end] = WordAt(text, Below(text.size() + 1));
  const std::string other =
      Below(4) == 0 ? Word() : text.substr(other_begin, other_end - other_begin);
  text.replace(begin, end - begin, other);
}

void Mutator::ChangeOnce(std::string& text) {
  // A text that can still be parsed shows more of what comes behind the parser.
  if (Below(2) == 0) return ExchangeWord(text);
  const size_t place = Below(text.size() + 1);
  const size_t length = std::min(text.size() - place, Below(24));
  switch (Below(9)) {
    case 0:
      text.erase(place, length);
      break;
    case 1:
      text.insert(place, text.substr(place, length));
      break;
    case 2:
      text.insert(place, " " + Word() + " ");
      break;
    case 3:
      text.replace(place, length, Word());
      break;
    case 4:
      text.insert(place, PieceOfCorpus());
      break;
    case 5:  // what stands here in another place as well
      text.insert(Below(text.size() + 1), text.substr(place, 4 * length));
      break;
    case 6:
      if (place < text.size()) text[place] = static_cast<char>(Below(256));
      break;
    case 7: {  // many of one thing: deep nesting, long chains, large numbers
      const std::string piece = Below(2) == 0 ? Word() : text.substr(place, length);
      for (size_t i = 0, count = Below(300); i < count; ++i) text.insert(place, piece);
      break;
    }
    default:
      if (Below(8) == 0) text.erase(place);
      break;
  }
}

}  // namespace fuzz
