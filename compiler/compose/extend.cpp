#include "compiler/compose/extend.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/nearest_name.h"
#include "compiler/compose/copy_expression.h"
#include "compiler/compose/declared.h"
#include "compiler/compose/rewards_in.h"

namespace compiler {
namespace {

// An override that overrides nothing, as a declaration that can be checked. Which events pay an
// overridden term is not known.
Declaration WithoutBase(Declaration declaration) {
  declaration.override_span.reset();
  if (auto* event = std::get_if<EventDeclaration>(&declaration.node)) event->is_known = false;
  auto* changed = std::get_if<RewardOverride>(&declaration.node);
  if (changed == nullptr) return declaration;
  if (changed->is_potential) {
    RewardStatement own = std::move(changed->reward);
    declaration.node =
        PotentialDeclaration{std::move(own.doc), std::move(own.name), std::move(own.value)};
    return declaration;
  }
  EventDeclaration event{"", EventKind::kEndOfTimeStep, changed->reward.name, {}};
  event.is_known = false;
  event.body.push_back({declaration.span, std::move(changed->reward)});
  declaration.node = std::move(event);
  return declaration;
}

class Extension {
 public:
  Extension(SyntaxTree base, SyntaxTree own, Diagnostics& diagnostics)
      : base_(std::move(base)), own_(std::move(own)), diagnostics_(diagnostics) {}

  SyntaxTree Merge() {
    std::erase_if(base_.declarations, [](const Declaration& declaration) {
      return std::holds_alternative<TestDeclaration>(declaration.node);
    });
    inherited_ = base_.declarations.size();
    for (Declaration& declaration : own_.declarations)
      if (declaration.override_span && IsFirst(declaration)) Override(declaration);
    for (Declaration& declaration : own_.declarations)
      if (!declaration.override_span) Add(std::move(declaration));
    return Header();
  }

 private:
  // The header of the merged tree, around the merged declarations.
  SyntaxTree Header() {
    SyntaxTree merged = std::move(base_);
    merged.doc = std::move(own_.doc);
    merged.task = std::move(own_.task);
    if (own_.robot) merged.robot = std::move(own_.robot);
    if (own_.world) merged.world = std::move(own_.world);
    merged.base.reset();
    std::erase_if(merged.allowances, [&](const Allowance& allowance) {
      return std::ranges::any_of(removed_, [&](Span span) {
        return span.begin <= allowance.covers.begin && allowance.covers.begin < span.end;
      });
    });
    std::ranges::move(own_.allowances, std::back_inserter(merged.allowances));
    std::erase_if(merged.declarations, [&](const Declaration& declaration) {
      return std::ranges::any_of(redeclared_, [&](const auto& other) {
        return other.first == KindOf(declaration) && other.second == NameOf(declaration).text;
      });
    });
    // The base's header is read for its robot alone.
    if (own_.robot) merged.lost.has_header = false;
    AddLost(std::move(own_.lost), merged.lost);
    return merged;
  }

  // ---- Overrides ----

  bool IsFirst(const Declaration& declaration) {
    const auto [first, is_new] =
        overrides_.emplace(DescriptionOf(declaration), *declaration.override_span);
    if (is_new) return true;
    Diagnostic diagnostic =
        MakeDiagnostic(code::kRepeatedOverride, *declaration.override_span,
                       fmt::format("the {} is overridden already", first->first));
    diagnostic.labels = {{first->second, "first overridden here"}};
    diagnostic.help = "remove one of the two";
    diagnostics_.Add(std::move(diagnostic));
    return false;
  }

  void Override(Declaration& declaration) {
    if (auto* reward = std::get_if<RewardOverride>(&declaration.node)) {
      if (!OverrideReward(declaration, *reward)) {
        ReportNothing(declaration, TermNames());
        base_.declarations.push_back(WithoutBase(std::move(declaration)));
      }
      return;
    }
    if (!IsKnown(declaration)) return base_.declarations.push_back(std::move(declaration));
    if (const auto* event = std::get_if<EventDeclaration>(&declaration.node))
      event_names_[event->event] = event->name.span;
    Declaration* overridden = FindInherited(declaration);
    if (overridden == nullptr) {
      ReportNothing(declaration, InheritedNames(KindOf(declaration)));
      base_.declarations.push_back(WithoutBase(std::move(declaration)));
    } else if (auto* param = std::get_if<ParamOverride>(&declaration.node)) {
      OverrideParam(*param, std::get<ParamDeclaration>(overridden->node));
    } else if (auto* goal = std::get_if<GoalOverride>(&declaration.node)) {
      std::get<GoalDeclaration>(overridden->node).draw = std::move(goal->draw);
    } else if (auto* table = std::get_if<TableOverride>(&declaration.node)) {
      std::get<TableDeclaration>(overridden->node).source = std::move(table->source);
    } else if (auto* constant = std::get_if<ConstOverride>(&declaration.node)) {
      std::get<ConstDeclaration>(overridden->node).value = std::move(constant->value);
    } else {
      Replace(std::move(declaration), *overridden);
    }
  }

  // The type and the unit stay; the range stays unless another one is given.
  static void OverrideParam(ParamOverride& changed, ParamDeclaration& param) {
    param.initial = std::move(changed.initial);
    if (!changed.minimum) return;
    param.minimum = std::move(changed.minimum);
    param.maximum = std::move(changed.maximum);
  }

  // The new one in place of the old one, whose documentation stays where there is no new one.
  void Replace(Declaration changed, Declaration& overridden) {
    removed_.push_back(overridden.span);
    std::string doc = std::visit([](auto& node) { return DocIn(node); }, overridden.node);
    changed.override_span.reset();
    overridden = std::move(changed);
    std::visit(
        [&](auto& node) {
          if constexpr (requires { node.doc; })
            if (node.doc.empty()) node.doc = std::move(doc);
        },
        overridden.node);
  }

  template <typename Node>
  static std::string DocIn(const Node& node) {
    if constexpr (requires { node.doc; }) return node.doc;
    return "";
  }

  // In place of every statement of the term, or of its potential. True if there was one.
  bool OverrideReward(const Declaration& declaration, RewardOverride& changed) {
    const RewardStatement& model = changed.reward;
    if (Declaration* inherited = FindPotential(model.name.text)) {
      OverridePotential(declaration, changed, *inherited);
      return true;
    }
    std::vector<Statement*> statements;
    ForEachReward(base_, [&](Statement& statement) {
      if (PaidBy(statement).name.text == model.name.text) statements.push_back(&statement);
    });
    if (changed.is_potential) {
      if (!statements.empty()) ReportOtherKind(declaration, model, PaidBy(*statements.front()));
      return !statements.empty();
    }
    CheckKind(declaration, model, statements);
    for (Statement* statement : statements) {
      removed_.push_back(statement->span);
      statement->span = declaration.span;
      const std::string& doc = model.doc.empty() ? PaidBy(*statement).doc : model.doc;
      statement->node = RewardStatement{doc, model.is_rate, model.name, CopyOf(model.value)};
    }
    return !statements.empty();
  }

  Declaration* FindPotential(const std::string& name) {
    for (size_t i = 0; i < inherited_; ++i) {
      Declaration& inherited = base_.declarations[i];
      const bool is_potential = std::holds_alternative<PotentialDeclaration>(inherited.node);
      if (is_potential && NameOf(inherited).text == name) return &inherited;
    }
    return nullptr;
  }

  void OverridePotential(const Declaration& declaration, RewardOverride& changed,
                         Declaration& inherited) {
    auto& potential = std::get<PotentialDeclaration>(inherited.node);
    if (!changed.is_potential) return ReportPotential(declaration, changed.reward, potential);
    removed_.push_back(inherited.span);
    inherited.span = declaration.span;
    RewardStatement& own = changed.reward;
    if (!own.doc.empty()) potential.doc = std::move(own.doc);
    potential.name = std::move(own.name);
    potential.value = std::move(own.value);
  }

  // What the base has as a potential is overridden as something else.
  void ReportPotential(const Declaration& declaration, const RewardStatement& own,
                       const PotentialDeclaration& potential) {
    Diagnostic diagnostic = MakeDiagnostic(
        code::kOtherKindOfReward, own.name.span,
        fmt::format("the base pays `{}` as a potential, not {}", own.name.text, WayOf(own)));
    diagnostic.labels = {{potential.name.span, "declared here"}};
    diagnostic.help = WriteInstead({declaration.override_span->begin, own.name.span.end},
                                   "override reward potential " + own.name.text);
    diagnostics_.Add(std::move(diagnostic));
  }

  // What the base pays in an event is overridden as a potential.
  void ReportOtherKind(const Declaration& declaration, const RewardStatement& own,
                       const RewardStatement& inherited) {
    const std::string way = WayOf(inherited);
    Diagnostic diagnostic = MakeDiagnostic(
        code::kOtherKindOfReward, own.name.span,
        fmt::format("the base pays `{}` {}, not as a potential", own.name.text, way));
    diagnostic.labels = {{inherited.name.span, fmt::format("paid {} here", way)}};
    diagnostic.note =
        "to make it a potential, override the block without it, and declare the potential";
    diagnostic.help = WriteInstead(
        {declaration.override_span->begin, own.name.span.end},
        fmt::format("override reward {}{}", inherited.is_rate ? "rate " : "", own.name.text));
    diagnostics_.Add(std::move(diagnostic));
  }

  static const RewardStatement& PaidBy(const Statement& statement) {
    return std::get<RewardStatement>(statement.node);
  }

  // Does the override pay at once, or per second, where the base does?
  void CheckKind(const Declaration& declaration, const RewardStatement& own,
                 const std::vector<Statement*>& statements) {
    const auto is_same = [&](const Statement* statement) {
      return PaidBy(*statement).is_rate == own.is_rate;
    };
    const auto other = std::ranges::find_if_not(statements, is_same);
    if (other == statements.end()) return;
    const RewardStatement& inherited = PaidBy(**other);
    const bool is_mixed = std::ranges::any_of(statements, is_same);
    const std::string base_way = is_mixed ? "both at once and per second" : WayOf(inherited);
    Diagnostic diagnostic =
        MakeDiagnostic(code::kOtherKindOfReward, own.name.span,
                       fmt::format("the base pays `{}` {}{}", own.name.text, base_way,
                                   is_mixed ? "" : fmt::format(", not {}", WayOf(own))));
    diagnostic.labels = {{inherited.name.span, fmt::format("paid {} here", WayOf(inherited))}};
    if (is_mixed) {
      diagnostic.help = "override the blocks in which it is paid";
    } else {
      diagnostic.note = "to pay it in another way, override the block in which it is paid";
      diagnostic.help = WriteInstead(
          {declaration.override_span->begin, own.name.span.end},
          fmt::format("override reward {}{}", inherited.is_rate ? "rate " : "", own.name.text));
    }
    diagnostics_.Add(std::move(diagnostic));
  }

  static std::string WayOf(const RewardStatement& reward) {
    return reward.is_rate ? "per second" : "at once";
  }

  Declaration* FindInherited(const Declaration& declaration) {
    for (size_t i = 0; i < inherited_; ++i)
      if (AreOfTheSame(base_.declarations[i], declaration)) return &base_.declarations[i];
    return nullptr;
  }

  void ReportNothing(const Declaration& declaration, const std::vector<std::string>& names) {
    const Identifier& name = NameOf(declaration);
    if (base_.lost.has_anything || base_.lost.words.contains(name.text)) return;
    own_.lost.words.insert(name.text);
    Diagnostic diagnostic =
        MakeDiagnostic(code::kNothingToOverride, name.span,
                       fmt::format("the base has no {}", DescriptionOf(declaration)));
    if (const auto nearest = text::NearestName(name.text, names)) {
      diagnostic.help = DidYouMean(name.span, *nearest);
    } else if (!std::holds_alternative<ParamOverride>(declaration.node) &&
               !std::holds_alternative<GoalOverride>(declaration.node) &&
               !std::holds_alternative<ConstOverride>(declaration.node) &&
               !std::holds_alternative<TableOverride>(declaration.node) &&
               !std::holds_alternative<RewardOverride>(declaration.node)) {
      diagnostic.help = {"to add it, leave out `override`", {Without(*declaration.override_span)}};
    }
    diagnostics_.Add(std::move(diagnostic));
  }

  std::vector<std::string> InheritedNames(std::string_view kind) const {
    std::vector<std::string> names;
    if (IsOnly(kind)) return names;
    for (size_t i = 0; i < inherited_; ++i)
      if (KindOf(base_.declarations[i]) == kind)
        names.push_back(NameOf(base_.declarations[i]).text);
    return names;
  }

  std::vector<std::string> TermNames() {
    std::vector<std::string> names;
    ForEachReward(base_, [&](Statement& statement) {
      names.push_back(std::get<RewardStatement>(statement.node).name.text);
    });
    for (const Declaration& declaration : base_.declarations)
      if (std::holds_alternative<PotentialDeclaration>(declaration.node))
        names.push_back(NameOf(declaration).text);
    return names;
  }

  // ---- Additions ----

  void Add(Declaration declaration) {
    if (auto* event = std::get_if<EventDeclaration>(&declaration.node)) {
      if (event->is_known && IsFirstBlock(*event)) return Append(std::move(declaration));
      event->is_known = false;
      return base_.declarations.push_back(std::move(declaration));
    }
    if (const Declaration* inherited = FindInherited(declaration); inherited != nullptr) {
      if (std::holds_alternative<OnboardDeclaration>(declaration.node)) return;
      ReportRedeclared(declaration, *inherited);
    }
    base_.declarations.push_back(std::move(declaration));
  }

  // Behind the base's block of this event, if there is one.
  void Append(Declaration declaration) {
    Declaration* inherited = FindInherited(declaration);
    if (inherited == nullptr) return base_.declarations.push_back(std::move(declaration));
    auto& event = std::get<EventDeclaration>(inherited->node);
    auto& own = std::get<EventDeclaration>(declaration.node);
    event.appended.push_back(std::move(own.body));
    if (event.doc.empty()) event.doc = std::move(own.doc);
  }

  // The task's own file has one block for an event, overriding or appended.
  bool IsFirstBlock(const EventDeclaration& event) {
    const auto [first, is_new] = event_names_.emplace(event.event, event.name.span);
    if (is_new) return true;
    Diagnostic diagnostic =
        MakeDiagnostic(code::kRepeatedEvent, event.name.span,
                       fmt::format("`{}` has a block already", event.name.text));
    diagnostic.labels = {{first->second, "the first block"}};
    diagnostic.help = "put all statements of an event into one block";
    diagnostics_.Add(std::move(diagnostic));
    return false;
  }

  void ReportRedeclared(const Declaration& declaration, const Declaration& inherited) {
    const Identifier& name = NameOf(declaration);
    const std::string_view kind = KindOf(declaration);
    // Which of the two is meant is not known: neither is kept.
    redeclared_.emplace_back(kind, name.text);
    own_.lost.words.insert(name.text);
    Diagnostic diagnostic =
        MakeDiagnostic(code::kMissingOverride, name.span,
                       fmt::format("the base has {} {} already", kind == "observe" ? "an" : "a",
                                   DescriptionOf(declaration)));
    diagnostic.labels = {{NameOf(inherited).span, "declared here"}};
    if (kind == "memory" || kind == "sensor") {
      diagnostic.help = "use the base's, or take another name";
    } else if (const auto* observation = std::get_if<ObserveDeclaration>(&declaration.node);
               observation != nullptr && !observation->has_name) {
      diagnostic.help = "leave it out: the learner sees it already";
    } else if (kind == "param" || kind == "const" || kind == "goal") {
      diagnostic.help =
          fmt::format("to give it another value: `override {} {} = ...`", kind, name.text);
    } else if (kind == "table") {
      diagnostic.help =
          fmt::format("to read another file: `override table {} = \"FILE.csv\"`", name.text);
    } else {
      const uint32_t begin = declaration.span.begin;
      const std::string_view head = kind == "reward" ? "reward potential" : kind;
      diagnostic.help = {fmt::format("to replace it, write `override {} {}`", head, name.text),
                         {{{begin, begin}, "override "}}};
    }
    diagnostics_.Add(std::move(diagnostic));
  }

  // `override` and the blank behind it.
  static Fix Without(Span override_span) {
    return {{override_span.begin, override_span.end + 1}, ""};
  }

  // ---- Words ----

  // "metric `height`", "start pose", "block for `end_of_action`"
  static std::string DescriptionOf(const Declaration& declaration) {
    const std::string_view kind = KindOf(declaration);
    if (kind == "start") return "start pose";
    if (kind == "after_end") return "declaration `after_end`";
    const std::string& name = NameOf(declaration).text;
    if (kind == "on") return fmt::format("block for `{}`", name);
    if (kind == "reward") return fmt::format("reward term `{}`", name);
    if (kind == "fn") return fmt::format("function `{}`", name);
    if (kind == "observe") return fmt::format("observation `{}`", name);
    return fmt::format("{} `{}`", kind, name);
  }

  SyntaxTree base_;
  SyntaxTree own_;
  Diagnostics& diagnostics_;
  size_t inherited_ = 0;                   // as many declarations of base_ are the base's
  std::map<std::string, Span> overrides_;  // by what they override; the word itself
  std::map<EventKind, Span> event_names_;  // of the blocks of the task's own file
  std::vector<Span> removed_;              // what was replaced in the base
  std::vector<std::pair<std::string_view, std::string>> redeclared_;  // kind and name
};

}  // namespace

SyntaxTree Extend(SyntaxTree base, SyntaxTree own, Diagnostics& diagnostics) {
  return Extension(std::move(base), std::move(own), diagnostics).Merge();
}

SyntaxTree ExtendUnknown(SyntaxTree own) {
  for (Declaration& declaration : own.declarations)
    if (declaration.override_span) declaration = WithoutBase(std::move(declaration));
  own.lost.has_anything = true;
  return own;
}

void AddLost(LostText more, LostText& lost) {
  lost.words.merge(more.words);
  lost.has_header = lost.has_header || more.has_header;
  lost.has_imports = lost.has_imports || more.has_imports;
  lost.has_anything = lost.has_anything || more.has_anything;
  lost.has_code = lost.has_code || more.has_code;
}

bool RejectOverrides(const SyntaxTree& tree, Diagnostics& diagnostics) {
  for (const Declaration& declaration : tree.declarations) {
    if (!declaration.override_span) continue;
    Diagnostic diagnostic =
        MakeDiagnostic(code::kOverrideWithoutBase, *declaration.override_span,
                       "this task extends no other: there is nothing to override");
    diagnostic.help = "name the base in the header: `task NAME extends \"base.task\"`";
    diagnostics.Add(std::move(diagnostic));
    return true;
  }
  return false;
}

}  // namespace compiler
