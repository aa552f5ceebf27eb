#include "compiler/source/sources.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/seal/sha256.h"

namespace compiler {

const SourceFile& Sources::Add(std::string path, std::string text) {
  // The end of a file is no place in the next one.
  const uint32_t first_offset = files_.empty() ? 0 : files_.back().end_offset() + 1;
  return files_.emplace_back(std::move(path), std::move(text), first_offset);
}

std::string Sources::Hash() const {
  if (files_.size() == 1) return seal::Sha256(main().text());
  std::string hashes;
  for (const SourceFile& file : files_) hashes += seal::Sha256(file.text());
  return seal::Sha256(hashes);
}

size_t Sources::IndexOf(Span span) const {
  assert(!files_.empty());
  const auto next = std::ranges::upper_bound(files_, span.begin, {}, &SourceFile::first_offset);
  return static_cast<size_t>(next - files_.begin()) - 1;
}

}  // namespace compiler
