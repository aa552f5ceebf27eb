#include "compiler/language_server/cursor_place.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>

namespace compiler {
namespace {

bool IsWordCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// What is expected behind a keyword that begins a statement or declaration.
const std::map<std::string_view, Expected>& AfterKeyword() {
  static const std::map<std::string_view, Expected> expected = {
      {"task", Expected::kAnyText},        {"sensor", Expected::kAnyText},
      {"param", Expected::kAnyText},       {"memory", Expected::kAnyText},
      {"const", Expected::kAnyText},       {"set", Expected::kAnyText},
      {"table", Expected::kAnyText},       {"goal", Expected::kAnyText},
      {"redraw", Expected::kGoal},         {"observe", Expected::kObserved},
      {"phase", Expected::kAnyText},       {"next", Expected::kPhase},
      {"let", Expected::kAnyText},         {"fn", Expected::kAnyText},
      {"test", Expected::kAnyText},        {"import", Expected::kAnyText},
      {"extends", Expected::kAnyText},     {"on", Expected::kEvent},
      {"start", Expected::kPose},          {"per", Expected::kScope},
      {"metric", Expected::kReduction},    {"log", Expected::kReduction},
      {"reward", Expected::kTerm},         {"end_episode", Expected::kOutcome},
      {"given", Expected::kTarget},        {"fire", Expected::kEvent},
      {"expect", Expected::kExpectation},  {"allow", Expected::kWarningCode},
      {"override", Expected::kOverridden}, {"truncate_episode", Expected::kAnyText},
      {"after_end", Expected::kAfterEnd}};
  return expected;
}

class PlaceFinder {
 public:
  PlaceFinder(const TextTokens& tokens, uint32_t offset) : tokens_(tokens), offset_(offset) {}

  CursorPlace Find() {
    place_.word = Word();
    count_ = tokens_.CountBefore(place_.word.begin);
    place_.expected = Expect();
    return place_;
  }

 private:
  Span Word() const {
    uint32_t begin = offset_;
    while (begin > 0 && IsWordCharacter(tokens_.text()[begin - 1])) --begin;
    return {begin, offset_};
  }

  bool IsInComment() const {
    const uint32_t begin = count_ == 0 ? 0 : tokens_[count_ - 1].span.end;
    const std::string_view gap = tokens_.text().substr(begin, offset_ - begin);
    const size_t line = gap.find_last_of("\r\n");
    return gap.find("//", line == std::string_view::npos ? 0 : line) != std::string_view::npos;
  }

  // In a text: inside of its quotes, or behind one that is not closed.
  bool IsInText() const {
    for (size_t i = count_; i < tokens_.size() && tokens_[i].span.begin < offset_; ++i) {
      if (tokens_.KindOf(i) == LexedKind::kText) return true;
    }
    if (count_ == 0 || tokens_.KindOf(count_ - 1) != LexedKind::kText) return false;
    const std::string_view text = tokens_.TextOf(count_ - 1);
    const bool is_closed = text.size() > 1 && text.ends_with('"');
    return !is_closed && tokens_[count_ - 1].span.end == offset_;
  }

  std::string_view Last() const { return count_ == 0 ? "" : tokens_.TextOf(count_ - 1); }

  // Does the word begin a line?
  bool IsOnNewLine() const {
    if (count_ == 0) return true;
    const uint32_t begin = tokens_[count_ - 1].span.end;
    return tokens_.text().substr(begin, place_.word.begin - begin).find('\n') !=
           std::string_view::npos;
  }

  // The innermost bracket that is open at the cursor, or nothing.
  std::optional<size_t> OpenBracket() const {
    int depth = 0;
    for (size_t i = count_; i-- > 0;) {
      const std::string_view text = tokens_.TextOf(i);
      if (text == ")" || text == "]" || (text == "}" && depth > 0)) ++depth;
      if (text == "}" && depth == 0) {
        if (!IsSetClose(i)) return std::nullopt;
        ++depth;
      }
      if (text != "(" && text != "[" && text != "{") {
        if (depth == 0 && IsStatementKeyword(i)) return std::nullopt;
        continue;
      }
      if (depth > 0) {
        --depth;
      } else if (text == "{") {
        if (tokens_.IsBlockOpen(i)) return std::nullopt;  // else a set: look around it
      } else {
        return i;
      }
    }
    return std::nullopt;
  }

  // `{body, head}` has nothing but names, commas and signs between its braces.
  bool IsSetClose(size_t close) const {
    for (size_t i = close; i-- > 0;) {
      if (tokens_.Is(i, "{")) return !tokens_.IsBlockOpen(i);
      if (tokens_.Is(i, "}") || tokens_.Is(i, "=")) return false;
    }
    return false;
  }

  bool IsStatementKeyword(size_t i) const {
    return tokens_.KindOf(i) == LexedKind::kKeyword && tokens_.BeginsLine(i) &&
           (AfterKeyword().contains(tokens_.TextOf(i)) || tokens_.Is(i, "if"));
  }

  // The first token of the statement in which the cursor is; count_ where none has begun.
  size_t StatementBegin() const {
    size_t i = count_;
    while (i > 0) {
      const bool ends_before = tokens_.Is(i - 1, "}") || tokens_.IsBlockOpen(i - 1);
      if (ends_before && !(tokens_.Is(i - 1, "}") && IsSetClose(i - 1))) break;
      const bool is_new_line = i == count_ ? IsOnNewLine() : tokens_.BeginsLine(i);
      if (is_new_line && !tokens_.ExpectsMore(i - 1)) break;
      --i;
    }
    return i;
  }

  bool IsInStart(size_t word) const {
    return tokens_.BeginsLine(word) || (word > 0 && tokens_.Is(word - 1, "override"));
  }

  // What the block in which the cursor is consists of.
  Expected InBlock() const {
    int depth = 0;
    bool is_nested = false;
    for (size_t i = count_; i-- > 0;) {
      if (tokens_.Is(i, "}")) ++depth;
      if (!tokens_.Is(i, "{")) continue;
      if (depth > 0) {
        --depth;
        continue;
      }
      if (!tokens_.IsBlockOpen(i)) continue;
      is_nested = false;
      for (size_t k = i; k-- > 0 && !tokens_.Is(k, "{") && !tokens_.Is(k, "}");) {
        if (tokens_.Is(k, "test") && tokens_.BeginsLine(k)) return Expected::kTestStatement;
        if (tokens_.Is(k, "fn")) return Expected::kBodyStatement;
        if (tokens_.Is(k, "start") && IsInStart(k)) return Expected::kStartStatement;
        is_nested = tokens_.Is(k, "if") || tokens_.Is(k, "else") || tokens_.Is(k, "for");
        if (is_nested || tokens_.Is(k, "on")) break;
      }
      if (!is_nested) return Expected::kStatement;
    }
    return is_nested ? Expected::kStatement : Expected::kDeclaration;
  }

  // "joint.angle" in front of a token.
  std::string PathBefore(size_t index) const {
    std::string path;
    while (index > 0 && tokens_.IsName(index - 1)) {
      path = std::string(tokens_.TextOf(index - 1)) + path;
      if (index < 3 || !tokens_.Is(index - 2, ".")) break;
      path = "." + path;
      index -= 2;
    }
    return path;
  }

  bool IsTypeBefore(size_t bracket) const {
    if (bracket < 2) return false;
    if (tokens_.Is(bracket - 1, "]")) {  // real[4] [N]
      const size_t open = BeforeIndex(bracket);
      return open >= 2 && IsTypeBefore(open);
    }
    return tokens_.Is(bracket - 2, ":") || tokens_.Is(bracket - 2, "->");
  }

  // The token at which an index begins that ends before `end`; `end` where there is none.
  size_t BeforeIndex(size_t end) const {
    if (end == 0 || !tokens_.Is(end - 1, "]")) return end;
    size_t open = end - 1;
    while (open > 0 && !tokens_.Is(open, "[")) --open;
    return open;
  }

  Expected InSquareBrackets(size_t bracket) {
    if (IsTypeBefore(bracket)) {
      return tokens_.Is(bracket - 1, "]") ? Expected::kUnit : Expected::kTypeIndex;
    }
    place_.path = PathBefore(bracket);
    const bool follows_operand =
        count_ - 1 > bracket && !tokens_.ExpectsMore(count_ - 1) && !tokens_.Is(count_ - 1, "{");
    return follows_operand ? Expected::kOperator : Expected::kIndex;
  }

  Expected Expect() {
    if (IsInText()) return InText();
    if (IsInComment()) return Expected::kAnyText;
    const bool begins_with_digit =
        place_.word.begin < offset_ &&
        std::isdigit(static_cast<unsigned char>(tokens_.text()[place_.word.begin])) != 0;
    if (begins_with_digit) return Expected::kAnyText;
    if (Last() == ".") {
      place_.path = PathBefore(BeforeIndex(count_ - 1));
      return place_.path.empty() ? Expected::kAnyText : Expected::kMember;
    }
    const auto bracket = OpenBracket();
    if (bracket && tokens_.Is(*bracket, "[")) return InSquareBrackets(*bracket);
    if (!bracket && StatementBegin() == count_) return InBlock();
    return InStatement(bracket.has_value());
  }

  Expected InText() {
    const bool is_before = count_ > 0 && tokens_.KindOf(count_ - 1) == LexedKind::kText;
    const size_t text = is_before ? count_ - 1 : count_;
    const bool is_of_table = IsFileOfTable(tokens_, text);
    const bool is_of_task =
        text > 0 && (tokens_.Is(text - 1, "import") || tokens_.Is(text - 1, "extends"));
    const bool is_of_world = text > 0 && tokens_.Is(text - 1, "in");
    if (!is_of_table && !is_of_task && !is_of_world) return Expected::kAnyText;
    place_.word.begin = tokens_[text].span.begin + 1;
    if (is_of_world) return Expected::kWorldFile;
    return is_of_table ? Expected::kTableFile : Expected::kFile;
  }

  Expected InStatement(bool is_in_parentheses) {
    const size_t begin = StatementBegin();
    const std::string_view first = tokens_.TextOf(begin);
    const std::string_view last = Last();
    if (last == ":" || last == "->") return Expected::kType;
    if (first == "fn" && is_in_parentheses && !HasToken(begin, "=")) return Expected::kAnyText;
    if (tokens_.KindOf(count_ - 1) == LexedKind::kNumber && !IsOnNewLine()) return Expected::kUnit;
    if (count_ - 1 == begin || last == "per" || last == "extends") {
      if (first == "for") return Expected::kAnyText;
      if (last == "reward" && InBlock() == Expected::kDeclaration) return Expected::kPotential;
      const auto found = AfterKeyword().find(last);
      if (found != AfterKeyword().end()) return found->second;
    }
    const bool is_start =
        first == "start" || (first == "override" && tokens_.Is(begin + 1, "start"));
    if (is_start && last == "or") return Expected::kPose;
    if (first == "override" && count_ - 2 == begin) return AfterOverride(last);
    if (last == "for") return first == "task" ? Expected::kRobot : Expected::kAnyText;
    if (first == "fire")
      return tokens_.ExpectsMore(count_ - 1) ? Expected::kEvent : Expected::kOperator;
    if (first == "allow" && last == ",") return Expected::kWarningCode;
    if (NamesPhase(begin)) return Expected::kPhase;
    const bool is_set =
        first == "for" || first == "set" || (first == "override" && tokens_.Is(begin + 1, "set"));
    if (is_set && (tokens_.ExpectsMore(count_ - 1) || last == "{")) return Expected::kIndex;
    if (!tokens_.ExpectsMore(count_ - 1) && last != "{") return Expected::kOperator;
    const bool is_goal = first == "goal" || (first == "override" && tokens_.Is(begin + 1, "goal"));
    const bool draws = is_goal || InBlock() == Expected::kStartStatement;
    return draws ? Expected::kGoalValue : Expected::kValue;
  }

  // Behind `phase ==`, `given phase =` and `phase lift within 3 s else`.
  bool NamesPhase(size_t begin) const {
    const bool is_compared = tokens_.Is(count_ - 1, "==") || tokens_.Is(count_ - 1, "!=");
    const bool is_given = tokens_.Is(count_ - 1, "=") && tokens_.Is(begin, "given");
    if (is_compared || is_given) return count_ > 1 && tokens_.Is(count_ - 2, "phase");
    const bool is_head = tokens_.Is(begin, "phase") ||
                         (tokens_.Is(begin, "override") && tokens_.Is(begin + 1, "phase"));
    return is_head && tokens_.Is(count_ - 1, "else");
  }

  static Expected AfterOverride(std::string_view what) {
    if (what == "param") return Expected::kParamName;
    if (what == "const") return Expected::kConstName;
    if (what == "set") return Expected::kSetName;
    if (what == "table") return Expected::kTableName;
    if (what == "goal") return Expected::kGoalName;
    if (what == "observe") return Expected::kObservationName;
    if (what == "phase") return Expected::kPhaseName;
    if (what == "metric") return Expected::kMetricName;
    if (what == "fn") return Expected::kFunctionName;
    const auto found = AfterKeyword().find(what);
    return found == AfterKeyword().end() ? Expected::kAnyText : found->second;
  }

  bool HasToken(size_t from, std::string_view spelling) const {
    for (size_t i = from; i < count_; ++i) {
      if (tokens_.Is(i, spelling)) return true;
    }
    return false;
  }

  const TextTokens& tokens_;
  uint32_t offset_;
  size_t count_ = 0;  // of the tokens before the word
  CursorPlace place_;
};

}  // namespace

bool IsFileOfTable(const TextTokens& tokens, size_t text) {
  if (text == 0 || !tokens.Is(text - 1, "=")) return false;
  size_t first = text - 1;
  while (first > 0 && (!tokens.BeginsLine(first) || tokens.ExpectsMore(first - 1))) --first;
  return tokens.Is(tokens.Is(first, "override") ? first + 1 : first, "table");
}

CursorPlace FindCursorPlace(const TextTokens& tokens, uint32_t offset) {
  return PlaceFinder(tokens, offset).Find();
}

OpenCall FindOpenCall(const TextTokens& tokens, uint32_t offset) {
  OpenCall call;
  int depth = 0;
  for (size_t i = tokens.CountBefore(offset); i-- > 0;) {
    const std::string_view text = tokens.TextOf(i);
    if (text == ")" || text == "]") ++depth;
    if (text == "=" || tokens.IsBlockOpen(i)) return {};
    if (text == "," && depth == 0) ++call.argument;
    if (text != "(" && text != "[" && !(text == "{" && depth == 0)) continue;
    if (depth > 0) {
      --depth;
      continue;
    }
    const bool is_call = text == "(" && i > 0 && tokens.KindOf(i - 1) != LexedKind::kSign;
    if (is_call && !(i > 1 && tokens.Is(i - 2, "fn"))) {
      call.function = tokens.TextOf(i - 1);
      return call;
    }
    call.argument = 0;  // a list of its own
  }
  return {};
}

PathAtCursor FindPath(const TextTokens& tokens, uint32_t offset) {
  // The token around the offset, or the one that ends there.
  size_t at = tokens.CountBefore(offset);
  if (at >= tokens.size() || tokens[at].span.begin > offset ||
      tokens.KindOf(at) == LexedKind::kSign) {
    if (at == 0 || tokens[at - 1].span.end != offset) return {};
    --at;
  }
  if (tokens.KindOf(at) == LexedKind::kSign) return {};
  PathAtCursor found{std::string(tokens.TextOf(at)), tokens[at].span, tokens[at].span};
  for (size_t i = at; i >= 2 && tokens.Is(i - 1, ".") && tokens.IsName(i - 2); i -= 2) {
    found.path = std::string(tokens.TextOf(i - 2)) + "." + found.path;
    found.span.begin = tokens[i - 2].span.begin;
  }
  return found;
}

}  // namespace compiler
