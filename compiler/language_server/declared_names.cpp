#include "compiler/language_server/declared_names.h"

#include <algorithm>
#include <array>
#include <utility>

namespace compiler {
namespace {

struct Keyword {
  std::string_view spelling;
  NameKind kind;
};
// What stands before a name that it declares.
constexpr std::array<Keyword, 18> kKeywords = {{{"task", NameKind::kTask},
                                                {"sensor", NameKind::kSensor},
                                                {"param", NameKind::kParam},
                                                {"const", NameKind::kConst},
                                                {"set", NameKind::kSet},
                                                {"table", NameKind::kTable},
                                                {"memory", NameKind::kMemory},
                                                {"goal", NameKind::kGoal},
                                                {"observe", NameKind::kObservation},
                                                {"phase", NameKind::kPhase},
                                                {"metric", NameKind::kMetric},
                                                {"log", NameKind::kLog},
                                                {"reward", NameKind::kTerm},
                                                {"on", NameKind::kEvent},
                                                {"test", NameKind::kTest},
                                                {"fn", NameKind::kFunction},
                                                {"let", NameKind::kLet},
                                                {"for", NameKind::kLoop}}};

bool IsTopLevelWord(std::string_view keyword) {
  constexpr std::array<std::string_view, 18> kTopLevel = {
      "task", "start",   "after_end", "sensor", "param", "const", "set",  "table",  "memory",
      "goal", "observe", "phase",     "metric", "on",    "fn",    "test", "import", "override"};
  return std::ranges::find(kTopLevel, keyword) != kTopLevel.end();
}

class Finder {
 public:
  explicit Finder(const TextTokens& tokens) : tokens_(tokens) {}

  std::vector<DeclaredName> Find() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) Visit();
    while (!blocks_.empty()) CloseBlock(End());
    CloseFunction(End());
    CloseDeclaration(End());
    return std::move(names_);
  }

 private:
  uint32_t End() const { return static_cast<uint32_t>(tokens_.text().size()); }
  uint32_t EndOfLast() const { return at_ == 0 ? 0 : tokens_[at_ - 1].span.end; }

  void Visit() {
    const std::string_view text = tokens_.TextOf(at_);
    if (BeginsStatement() && IsTopLevel() && tokens_.BeginsLine(at_)) BeginDeclaration();
    if (tokens_.IsBlockOpen(at_)) {
      blocks_.push_back(std::exchange(pending_, {}));
      if (loop_ != kNone) names_[loop_].visible.begin = tokens_[at_].span.end;
      loop_ = kNone;
    } else if (text == "}" && !blocks_.empty() && !IsSetClose()) {
      CloseBlock(tokens_[at_].span.begin);
    }
    if (text == "{" && !tokens_.IsBlockOpen(at_)) ++open_sets_;
    if (BeginsStatement()) Declare(text);
  }

  bool IsSetClose() {
    if (open_sets_ == 0) return false;
    --open_sets_;
    return true;
  }

  // Keywords stand at the begin of a line, or behind a brace or another statement; `reward` stands
  // in expressions as well.
  bool BeginsStatement() const {
    const bool is_clear = tokens_.Is(at_, "let") || (tokens_.BeginsLine(at_) && IsTopLevel());
    return is_clear || !(tokens_.ExpectsMore(at_ - 1) || tokens_.Is(at_ - 1, "."));
  }

  bool IsTopLevel() const {
    const bool is_potential = tokens_.Is(at_, "reward") && tokens_.Is(at_ + 1, "potential");
    return is_potential || IsTopLevelWord(tokens_.TextOf(at_));
  }

  // A new declaration ends whatever was left open.
  void BeginDeclaration() {
    if (at_ > 0 && tokens_.Is(at_ - 1, "override")) return;
    while (!blocks_.empty()) CloseBlock(EndOfLast());
    CloseFunction(EndOfLast());
    CloseDeclaration(EndOfLast());
    open_sets_ = 0;
    loop_ = kNone;
    pending_.clear();
    begin_ = tokens_[at_].span.begin;
    is_override_ = tokens_.Is(at_, "override");
  }

  void CloseBlock(uint32_t end) {
    for (const size_t index : blocks_.back()) {
      Span& visible = names_[index].visible;
      visible = {std::min(visible.begin, end), end};
    }
    blocks_.pop_back();
  }
  void CloseFunction(uint32_t end) {
    for (const size_t index : std::exchange(arguments_, {})) names_[index].visible.end = end;
  }
  void CloseDeclaration(uint32_t end) {
    if (declaration_ != kNone) names_[declaration_].whole.end = end;
    declaration_ = kNone;
  }

  void Declare(std::string_view keyword) {
    const auto* found = std::ranges::find(kKeywords, keyword, &Keyword::spelling);
    if (found == kKeywords.end()) return;
    const NameKind kind = found->kind;
    size_t name = at_ + 1;
    // `metric max height`, `reward rate roll`
    const bool has_word =
        kind == NameKind::kMetric || kind == NameKind::kLog || kind == NameKind::kTerm;
    if (has_word && (name >= tokens_.size() || tokens_.KindOf(name) == LexedKind::kSign)) return;
    if (has_word && tokens_.Is(name + 1, "=")) {
      // no word in between
    } else if (has_word && tokens_.IsName(name + 1)) {
      ++name;
    }
    if (kind == NameKind::kLoop && !tokens_.Is(name + 1, "in")) return;
    if (kind == NameKind::kTest ? name >= tokens_.size() : !tokens_.IsName(name)) return;
    if (kind == NameKind::kObservation && !HasOwnName(name)) return;
    Add(kind, name);
  }

  // `observe clock = ...`, and not `observe base.up`.
  bool HasOwnName(size_t name) const {
    while (tokens_.Is(name + 1, ".") && tokens_.IsName(name + 2)) name += 2;
    return tokens_.Is(name + 1, "=");
  }

  void Add(NameKind kind, size_t name) {
    DeclaredName declared{.kind = kind,
                          .name = std::string(tokens_.TextOf(name)),
                          .span = tokens_[name].span,
                          .type = "",
                          .whole = {tokens_[at_].span.begin, tokens_[name].span.end},
                          .visible = {0, End()},
                          .is_override = is_override_};
    const size_t index = names_.size();
    size_t next = name + 1;
    const bool has_dots = kind == NameKind::kSensor || kind == NameKind::kObservation;
    while (has_dots && tokens_.Is(next, ".") && tokens_.IsName(next + 1)) {
      declared.span.end = tokens_[next + 1].span.end;
      declared.name.append(".").append(tokens_.TextOf(next + 1));
      next += 2;
    }
    if (tokens_.Is(next, ":")) declared.type = TypeFrom(next + 1);
    if (kind == NameKind::kFunction) declared.type = SignatureFrom(next);
    if (kind == NameKind::kLet) {
      // Behind its own line.
      const size_t line = tokens_.text().find('\n', declared.span.end);
      declared.visible.begin =
          line == std::string_view::npos ? End() : static_cast<uint32_t>(line) + 1;
      if (!blocks_.empty()) blocks_.back().push_back(index);
    }
    if (kind == NameKind::kLoop) {
      pending_.push_back(index);
      loop_ = index;
    }
    const bool is_local = kind == NameKind::kLet || kind == NameKind::kLoop ||
                          ((kind == NameKind::kTerm || kind == NameKind::kLog) && !blocks_.empty());
    if (!is_local) {
      declared.whole.begin = begin_;
      declaration_ = index;
    }
    names_.push_back(std::move(declared));
    if (kind == NameKind::kFunction) AddArguments(next);
  }

  // What is written from a token to `=`, `,`, `)` or the end of the line.
  std::string TypeFrom(size_t first) const {
    size_t last = first;
    int depth = 0;
    for (; last < tokens_.size(); ++last) {
      const std::string_view text = tokens_.TextOf(last);
      if (tokens_.BeginsLine(last)) break;
      if (depth == 0 && (text == "=" || text == "," || text == ")" || text == "in" || text == "{"))
        break;
      depth += text == "[" ? 1 : text == "]" ? -1 : 0;
    }
    if (last == first) return "";
    return std::string(tokens_.text().substr(
        tokens_[first].span.begin, tokens_[last - 1].span.end - tokens_[first].span.begin));
  }

  // "(a: real [m]) -> real"
  std::string SignatureFrom(size_t open) const {
    size_t arrow = open;
    while (arrow < tokens_.size() && !tokens_.Is(arrow, "->") && !tokens_.Is(arrow, "{")) ++arrow;
    if (!tokens_.Is(open, "(") || !tokens_.Is(arrow, "->")) return "";
    const Span from = tokens_[open].span;
    return std::string(tokens_.text().substr(from.begin, tokens_[arrow].span.end - from.begin)) +
           " " + TypeFrom(arrow + 1);
  }

  void AddArguments(size_t open) {
    if (!tokens_.Is(open, "(")) return;
    for (size_t i = open + 1; i + 1 < tokens_.size() && !tokens_.Is(i, ")"); ++i) {
      if (!tokens_.IsName(i) || !tokens_.Is(i + 1, ":")) continue;
      arguments_.push_back(names_.size());
      names_.push_back({.kind = NameKind::kArgument,
                        .name = std::string(tokens_.TextOf(i)),
                        .span = tokens_[i].span,
                        .type = TypeFrom(i + 2),
                        .whole = tokens_[i].span,
                        .visible = {tokens_[open].span.begin, End()}});
    }
  }

  static constexpr size_t kNone = static_cast<size_t>(-1);

  const TextTokens& tokens_;
  std::vector<DeclaredName> names_;
  size_t at_ = 0;
  std::vector<std::vector<size_t>> blocks_;  // the local names of each open block
  std::vector<size_t> pending_;              // those of the next block
  size_t loop_ = kNone;                      // its variable, whose block has not begun
  std::vector<size_t> arguments_;            // of the current function
  size_t declaration_ = kNone;               // the current one
  size_t open_sets_ = 0;
  uint32_t begin_ = 0;
  bool is_override_ = false;
};

}  // namespace

std::vector<DeclaredName> FindDeclaredNames(const TextTokens& tokens) {
  return Finder(tokens).Find();
}

}  // namespace compiler
