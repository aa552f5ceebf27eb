#include "compiler/emit/unique_names.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace compiler {
namespace {

// Keywords up to C++23, alternative spellings of operators, and macros that some compilers
// predefine.
constexpr std::string_view kKeywords[] = {"alignas",
                                          "alignof",
                                          "and",
                                          "and_eq",
                                          "asm",
                                          "auto",
                                          "bitand",
                                          "bitor",
                                          "bool",
                                          "break",
                                          "case",
                                          "catch",
                                          "char",
                                          "char8_t",
                                          "char16_t",
                                          "char32_t",
                                          "class",
                                          "co_await",
                                          "co_return",
                                          "co_yield",
                                          "compl",
                                          "concept",
                                          "const",
                                          "const_cast",
                                          "consteval",
                                          "constexpr",
                                          "constinit",
                                          "continue",
                                          "decltype",
                                          "default",
                                          "delete",
                                          "do",
                                          "double",
                                          "dynamic_cast",
                                          "else",
                                          "enum",
                                          "explicit",
                                          "export",
                                          "extern",
                                          "false",
                                          "float",
                                          "for",
                                          "friend",
                                          "goto",
                                          "i386",
                                          "if",
                                          "inline",
                                          "int",
                                          "linux",
                                          "long",
                                          "mutable",
                                          "namespace",
                                          "new",
                                          "noexcept",
                                          "not",
                                          "not_eq",
                                          "nullptr",
                                          "operator",
                                          "or",
                                          "or_eq",
                                          "private",
                                          "protected",
                                          "public",
                                          "register",
                                          "reinterpret_cast",
                                          "requires",
                                          "return",
                                          "short",
                                          "signed",
                                          "sizeof",
                                          "static",
                                          "static_assert",
                                          "static_cast",
                                          "struct",
                                          "switch",
                                          "template",
                                          "this",
                                          "thread_local",
                                          "throw",
                                          "true",
                                          "try",
                                          "typedef",
                                          "typeid",
                                          "typename",
                                          "typeof",
                                          "union",
                                          "unix",
                                          "unsigned",
                                          "using",
                                          "virtual",
                                          "void",
                                          "volatile",
                                          "wchar_t",
                                          "while",
                                          "xor",
                                          "xor_eq"};

// What the emitted functions themselves refer to, besides taskc_* and TASKC_*.
constexpr std::string_view kOwnNames[] = {"frame", "memory", "Memory", "reward", "draw", "i"};

bool IsReserved(std::string_view name) {
  for (std::string_view keyword : kKeywords) {
    if (name == keyword) return true;
  }
  for (std::string_view own : kOwnNames) {
    if (name == own) return true;
  }
  return name.starts_with("taskc") || name.starts_with("TASKC");
}

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// Letters, digits and single underscores, a letter first: names with two underscores, or with one
// before a capital, belong to the C++ compiler.
std::string Tidy(std::string_view wanted) {
  std::string name;
  for (char c : wanted) {
    if (IsLetter(c) || IsDigit(c)) {
      name += c;
    } else if (!name.ends_with('_')) {
      name += '_';
    }
  }
  if (name.empty() || !IsLetter(name.front())) name.insert(0, name.starts_with('_') ? "x" : "x_");
  return name;
}

}  // namespace

std::string UniqueNames::Add(std::string_view wanted) {
  std::string name = Tidy(wanted);
  if (IsReserved(name)) name += '_';
  std::string unique = name;
  if (IsTaken(unique)) {
    int& count = next_.try_emplace(name, 2).first->second;
    do {
      unique = fmt::format("{}{}{}", name, name.ends_with('_') ? "" : "_", count++);
    } while (IsTaken(unique));
  }
  taken_.insert(unique);
  added_.push_back({unique, std::move(name)});
  return unique;
}

void UniqueNames::GiveBackTo(size_t mark) {
  for (; added_.size() > mark; added_.pop_back()) {
    taken_.erase(added_.back().unique);
    next_.erase(added_.back().name);
  }
}

bool UniqueNames::IsTaken(const std::string& name) const {
  return taken_.contains(name) || (outer_ != nullptr && outer_->IsTaken(name));
}

}  // namespace compiler
