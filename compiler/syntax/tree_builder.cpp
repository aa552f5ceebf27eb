#include "compiler/syntax/tree_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "compiler/syntax/allowances.h"
#include "compiler/syntax/expression_builder.h"
#include "compiler/syntax/function_builder.h"
#include "compiler/syntax/lost_text.h"
#include "compiler/syntax/one_line_text.h"
#include "compiler/syntax/statement_builder.h"
#include "compiler/syntax/test_builder.h"
#include "compiler/syntax/token_classes.h"
#include "compiler/syntax/unit_builder.h"
#include "compiler/syntax/word_lookup.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

using grammar::TaskParser;
using DeclarationNode = decltype(Declaration::node);

class TreeBuilder {
 public:
  TreeBuilder(const std::map<uint32_t, std::string>& docs, SyntaxReport& report)
      : docs_(docs),
        report_(report),
        allowances_(report),
        expressions_(report),
        statements_(report, docs, allowances_, tree_.lost),
        tests_(report, statements_, allowances_),
        functions_(report, statements_, tree_.lost) {}

  SyntaxTree Build(TaskParser::FileContext& file) {
    for (antlr4::tree::ParseTree* child : file.children) {
      if (auto* allow = dynamic_cast<TaskParser::AllowContext*>(child)) {
        allowances_.Add(*allow);
      } else if (auto* header = dynamic_cast<TaskParser::HeaderContext*>(child)) {
        allowances_.Attach(WholeFile());
        AddHeader(*header);
      } else if (auto* declaration = dynamic_cast<TaskParser::DeclarationContext*>(child)) {
        allowances_.Attach(SpanOf(*declaration));
        if (first_ == nullptr) first_ = declaration;
        if (IsLost(*declaration, report_) || IsPaidOutside(*declaration)) {
          AddLost(*declaration);
        } else {
          AddDeclaration(*declaration);
        }
      }
    }
    NoteLost(file, tree_.lost);
    allowances_.End();
    if (header_ == nullptr) CheckLibrary(*file.getStart());
    tree_.allowances = allowances_.Take();
    return std::move(tree_);
  }

 private:
  // ---- The header ------------------------------------------------------------------------------

  void AddHeader(TaskParser::HeaderContext& context) {
    const Span task = SpanOf(*context.getStart());
    if (header_ != nullptr) {
      Diagnostic diagnostic = MakeDiagnostic(code::kRepeatedHeader, task, "a file holds one task");
      diagnostic.help = "put the other task into a file of its own";
      report_.AddUnlessFaulty(std::move(diagnostic));
      return;
    }
    header_ = &context;
    if (first_ != nullptr) {
      Diagnostic diagnostic =
          MakeDiagnostic(code::kMissingHeader, task, "a task begins with its header");
      diagnostic.labels.push_back({SpanOf(*first_->getStart()), "this comes before it"});
      diagnostic.help = "move this line to the top of the file";
      report_.AddUnlessFaulty(std::move(diagnostic));
    }
    tree_.lost.has_header = IsLost(context, report_);
    if (!tree_.lost.has_header) return BuildHeader(context);
    // `task t extend "base.task"`
    if (context.getText().find('"') != std::string::npos) tree_.lost.has_anything = true;
  }

  void BuildHeader(TaskParser::HeaderContext& context) {
    tree_.doc = DocOf(context);
    tree_.task = BuildName(*context.name(0));
    if (context.base != nullptr) {
      tree_.base = BaseTask{BuildPath(*context.base), SpanOf(*context.base)};
    }
    if (context.robot != nullptr) tree_.robot = BuildName(*context.robot);
    if (context.world != nullptr)
      tree_.world = WorldFile{BuildPath(*context.world), SpanOf(*context.world)};
  }

  // The file has no header: is it a library?
  void CheckLibrary(const antlr4::Token& begin) {
    tree_.lost.has_header = first_ == nullptr || !IsLibraryPart(*first_);
    if (tree_.lost.words.contains(Spelling(TaskParser::EXTENDS))) tree_.lost.has_anything = true;
    if (first_ == nullptr || !IsLibraryPart(*first_)) {
      const std::string found = begin.getType() == antlr4::Token::EOF
                                    ? "the end of the file"
                                    : fmt::format("`{}`", begin.getText());
      Diagnostic diagnostic = MakeDiagnostic(code::kMissingHeader, SpanOf(begin),
                                             fmt::format("expected `task NAME`, found {}", found));
      diagnostic.help =
          "a file begins with the task's name and its robot: `task crawling for humanoid`";
      report_.AddUnlessFaulty(std::move(diagnostic));
      return;
    }
    if (misplaced_ == nullptr) return;
    const antlr4::Token& word = *misplaced_->getStart();
    Diagnostic diagnostic =
        MakeDiagnostic(code::kNotInLibrary, SpanOf(word),
                       fmt::format("`{}` is not allowed in a library", word.getText()));
    diagnostic.help =
        "a file without `task NAME` holds only imports, functions, sets, tables and consts";
    report_.AddUnlessFaulty(std::move(diagnostic));
  }

  static bool IsLibraryPart(TaskParser::DeclarationContext& context) {
    const TokenType type = context.getStart()->getType();
    return type == TaskParser::FN || type == TaskParser::IMPORT || type == TaskParser::SET ||
           type == TaskParser::CONST || type == TaskParser::TABLE;
  }

  Span WholeFile() const {
    return {report_.source().first_offset(), report_.source().end_offset()};
  }

  // ---- Declarations ----------------------------------------------------------------------------

  // A reward that is no potential, outside of all events: reported.
  bool IsPaidOutside(TaskParser::DeclarationContext& context) {
    auto* reward = context.reward();
    if (reward == nullptr || statements_.KindOf(*reward) == RewardKind::kPotential) return false;
    Diagnostic diagnostic =
        MakeDiagnostic(code::kUnknownDeclaration, SpanOf(*reward->getStart()),
                       "`reward` is allowed only inside an event, except for a potential");
    diagnostic.help = "events are declared with `on EVENT { ... }`";
    report_.AddUnlessFaulty(std::move(diagnostic));
    return true;
  }

  // Of a declaration with an error in it there is what stands in its blocks, and in no known event.
  void AddLost(TaskParser::DeclarationContext& context) {
    NoteLost(context, tree_.lost);
    const TokenType head = context.getStart()->getType();
    const bool is_start =
        head == TaskParser::START || (context.change() != nullptr && context.change()->start());
    if (is_start) return;  // what its block may set, no event may
    for (TaskParser::BlockContext* block : BlocksIn(context))
      tree_.declarations.push_back({SpanOf(*block), UnknownEvent({}, statements_.Build(*block))});
  }

  static EventDeclaration UnknownEvent(Identifier name, Block body) {
    EventDeclaration event{"", EventKind::kEndOfTimeStep, std::move(name), std::move(body)};
    event.is_known = false;
    return event;
  }

  void AddDeclaration(TaskParser::DeclarationContext& context) {
    if (misplaced_ == nullptr && !IsLibraryPart(context)) misplaced_ = &context;
    doc_ = DocOf(context);
    auto& inner = *static_cast<antlr4::ParserRuleContext*>(context.children.front());
    Declaration declaration{SpanOf(inner), {}};
    if (auto* changed = context.change()) {
      declaration.override_span = SpanOf(*changed->getStart());
      declaration.node = BuildOverride(*changed);
    } else {
      declaration.node = BuildNew(context);
    }
    tree_.declarations.push_back(std::move(declaration));
  }

  DeclarationNode BuildNew(TaskParser::DeclarationContext& context) {
    if (auto* start = context.start()) return Start(*start);
    if (auto* after = context.afterEnd()) return AfterAnEnd(*after);
    if (auto* sensor = context.sensor()) return Sensor(*sensor);
    if (auto* param = context.param()) return Param(*param);
    if (auto* memory = context.memory()) return Memory(*memory);
    if (auto* goal = context.goal()) return Goal(*goal);
    if (auto* observation = context.observation()) return Observation(*observation);
    if (auto* metric = context.metric()) return Metric(*metric);
    if (auto* reward = context.reward()) return Potential(*reward);
    if (auto* constant = context.constant()) return Const(*constant);
    if (auto* set = context.namedSet()) return Set(*set);
    if (auto* table = context.table()) return Table(*table);
    if (auto* event = context.event()) return Event(*event);
    if (auto* phase = context.phase()) return Phase(*phase);
    if (auto* function = context.function()) return Function(*function);
    if (auto* test = context.test()) return Test(*test);
    return Import(*context.imported());
  }

  DeclarationNode BuildOverride(TaskParser::ChangeContext& context) {
    if (auto* start = context.start()) return Start(*start);
    if (auto* after = context.afterEnd()) return AfterAnEnd(*after);
    if (auto* param = context.newDefault()) return NewDefault(*param);
    if (auto* goal = context.newGoal()) return GoalOverride{BuildName(*goal->name()), Draw(*goal)};
    if (auto* observation = context.newObservation()) return Named(*observation);
    if (auto* constant = context.newConstant()) return NewConstant(*constant);
    if (auto* set = context.namedSet()) return Set(*set);
    if (auto* table = context.newTable())
      return TableOverride{BuildName(*table->name()), BuildSource(*table->STRING()->getSymbol())};
    if (auto* metric = context.metric()) return Metric(*metric);
    if (auto* event = context.event()) return Event(*event);
    if (auto* phase = context.phase()) return Phase(*phase);
    if (auto* function = context.function()) return Function(*function);
    const RewardKind kind = statements_.KindOf(*context.reward());
    RewardStatement reward = statements_.Reward(*context.reward(), kind);
    reward.doc = doc_;
    return RewardOverride{std::move(reward), kind == RewardKind::kPotential};
  }

  StartDeclaration Start(TaskParser::StartContext& context) {
    StartDeclaration start;
    for (TaskParser::NameContext* pose : context.name()) start.poses.push_back(BuildName(*pose));
    const Span poses = Cover(start.poses.front().span, start.poses.back().span);
    CheckGivenOnce("the start pose", {SpanOf(context).begin, poses.end}, poses, start_);
    if (context.block() != nullptr) start.block = statements_.Build(*context.block());
    return start;
  }

  AfterEndDeclaration AfterAnEnd(TaskParser::AfterEndContext& context) {
    const Identifier word = BuildName(*context.behavior);
    const AfterEnd behavior =
        LookUp(word, kAfterEndNames, code::kUnknownWord, "what a task does after an end", report_);
    CheckGivenOnce("what follows an end", SpanOf(context), word.span, after_end_);
    return {behavior, word};
  }

  // `first`: where it was given before, if it was.
  void CheckGivenOnce(std::string_view what, Span declaration, Span given,
                      std::optional<Span>& first) {
    if (!first) {
      first = given;
      return;
    }
    Diagnostic diagnostic =
        MakeDiagnostic(code::kRepeatedHeader, declaration, fmt::format("{} is given twice", what));
    diagnostic.labels.push_back({*first, "first given here"});
    diagnostic.help = "remove one of them";
    report_.AddUnlessFaulty(std::move(diagnostic));
  }

  SensorDeclaration Sensor(TaskParser::SensorContext& context) {
    SensorDeclaration sensor;
    sensor.doc = doc_;
    sensor.name = BuildDottedName(context);
    SetType(*context.type(), sensor);
    if (context.range() != nullptr) SetRange(*context.range(), sensor);
    return sensor;
  }

  ParamDeclaration Param(TaskParser::ParamContext& context) {
    ParamDeclaration param;
    param.doc = doc_;
    param.name = BuildName(*context.name());
    SetType(*context.type(), param);
    param.initial = expressions_.Build(*context.expression());
    if (context.range() != nullptr) SetRange(*context.range(), param);
    return param;
  }

  ParamOverride NewDefault(TaskParser::NewDefaultContext& context) {
    ParamOverride param;
    param.name = BuildName(*context.name());
    param.initial = expressions_.Build(*context.expression());
    if (context.range() != nullptr) SetRange(*context.range(), param);
    return param;
  }

  MemoryDeclaration Memory(TaskParser::MemoryContext& context) {
    MemoryDeclaration memory;
    memory.doc = doc_;
    memory.name = BuildName(*context.name());
    SetType(*context.type(), memory);
    memory.initial = expressions_.Build(*context.expression());
    if (context.scope != nullptr) {
      memory.scope = LookUp(BuildName(*context.scope), kScopeNames, code::kUnknownWord,
                            "a scope of a memory", report_);
    }
    return memory;
  }

  GoalDeclaration Goal(TaskParser::GoalContext& context) {
    GoalDeclaration goal;
    goal.doc = doc_;
    goal.name = BuildName(*context.name());
    SetType(*context.type(), goal);
    goal.draw = Draw(context);
    return goal;
  }

  // How a goal is drawn, of its declaration or of what overrides it.
  template <typename Context>
  GoalDraw Draw(Context& context) {
    GoalDraw draw{expressions_.Build(*context.value), std::nullopt, std::nullopt};
    if (context.shortest != nullptr) draw.shortest = expressions_.Build(*context.shortest);
    if (context.longest != nullptr) draw.longest = expressions_.Build(*context.longest);
    const auto* word = draw.shortest ? std::get_if<NameExpression>(&draw.shortest->node) : nullptr;
    if (word != nullptr && word->name.text == "episode") draw.shortest.reset();
    return draw;
  }

  DeclarationNode Observation(TaskParser::ObservationContext& context) {
    if (!context.name().empty()) return Named(context);
    TaskParser::ExpressionContext& text = *context.expression();
    const Identifier name{OneLineText(text), SpanOf(text)};
    if (name.text == kOnboard) {
      CheckGivenOnce("`observe onboard`", SpanOf(context), name.span, onboard_);
      return OnboardDeclaration{name};
    }
    return ObserveDeclaration{doc_, name, false, expressions_.Build(text)};
  }

  // An observation to which a name is given, or one that overrides that of this name.
  template <typename Context>
  ObserveDeclaration Named(Context& context) {
    return {doc_, BuildDottedName(context), true, expressions_.Build(*context.expression())};
  }

  MetricDeclaration Metric(TaskParser::MetricContext& context) {
    MetricDeclaration metric;
    metric.doc = doc_;
    metric.name = BuildName(*context.name());
    metric.value = expressions_.Build(*context.expression());
    if (context.reduction != nullptr) {
      metric.reduction = LookUp(BuildName(*context.reduction), kReductionNames, code::kUnknownWord,
                                "a reduction of a metric", report_);
    }
    return metric;
  }

  PotentialDeclaration Potential(TaskParser::RewardContext& context) {
    return {doc_, BuildName(*context.name()), expressions_.Build(*context.expression())};
  }

  ConstDeclaration Const(TaskParser::ConstantContext& context) {
    ConstDeclaration constant;
    constant.doc = doc_;
    constant.name = BuildName(*context.name());
    SetType(*context.type(), constant);
    constant.value = expressions_.Build(*context.expression());
    return constant;
  }

  ConstOverride NewConstant(TaskParser::NewConstantContext& context) {
    return {BuildName(*context.name()), expressions_.Build(*context.expression())};
  }

  SetDeclaration Set(TaskParser::NamedSetContext& context) {
    return {doc_, BuildName(*context.name()), expressions_.BuildSet(*context.items()),
            SpanOf(*context.items())};
  }

  TableDeclaration Table(TaskParser::TableContext& context) {
    TableDeclaration table;
    table.doc = doc_;
    table.name = BuildName(*context.name());
    SetType(*context.type(), table);
    table.source = BuildSource(*context.STRING()->getSymbol());
    return table;
  }

  TableSource BuildSource(antlr4::Token& path) { return {BuildPath(path), SpanOf(path)}; }

  EventDeclaration Event(TaskParser::EventContext& context) {
    const Identifier name = BuildName(*context.name());
    const bool is_known =
        std::ranges::find(kEventNames, name.text, &Word<EventKind>::text) != kEventNames.end();
    const EventKind kind = LookUp(name, kEventNames, code::kUnknownEvent, "an event", report_);
    Block body = statements_.Build(*context.block());
    if (!is_known) return UnknownEvent(name, std::move(body));
    return {doc_, kind, name, std::move(body)};
  }

  PhaseDeclaration Phase(TaskParser::PhaseContext& context) {
    PhaseDeclaration phase;
    phase.doc = doc_;
    phase.name = BuildName(*context.name());
    if (TaskParser::LimitContext* limit = context.limit())
      phase.limit = PhaseLimit{expressions_.Build(*limit->time), BuildName(*limit->otherwise)};
    phase.body = statements_.Build(*context.block());
    return phase;
  }

  ImportDeclaration Import(TaskParser::ImportedContext& context) {
    antlr4::Token& path = *context.STRING()->getSymbol();
    return {BuildPath(path), SpanOf(path)};
  }

  std::string BuildPath(antlr4::Token& token) {
    return BuildNeededText(token, "here the name of a file is needed", report_);
  }

  FunctionDeclaration Function(TaskParser::FunctionContext& context) {
    FunctionDeclaration function = functions_.Build(context);
    function.doc = doc_;
    return function;
  }

  TestDeclaration Test(TaskParser::TestContext& context) {
    TestDeclaration test = tests_.Build(context);
    test.doc = doc_;
    return test;
  }

  template <typename Context>
  static Identifier BuildDottedName(Context& context) {
    Identifier whole;
    for (TaskParser::NameContext* part : context.name()) {
      const Identifier name = BuildName(*part);
      const bool is_first = whole.text.empty();
      whole.text += is_first ? name.text : "." + name.text;
      whole.span = is_first ? name.span : Cover(whole.span, name.span);
    }
    return whole;
  }

  template <typename Declared>
  void SetType(TaskParser::TypeContext& context, Declared& declared) {
    declared.type = BuildType(context);
    declared.unit = BuildUnitOf(context, UnitOwner::kDeclaration, report_);
  }

  template <typename Declared>
  void SetRange(TaskParser::RangeContext& context, Declared& declared) {
    declared.minimum = expressions_.Build(*context.minimum);
    declared.maximum = expressions_.Build(*context.maximum);
  }

  std::string DocOf(antlr4::ParserRuleContext& context) const {
    const auto found = docs_.find(SpanOf(context).begin);
    return found != docs_.end() ? found->second : "";
  }

  const std::map<uint32_t, std::string>& docs_;
  SyntaxReport& report_;
  SyntaxTree tree_;
  Allowances allowances_;
  ExpressionBuilder expressions_;
  StatementBuilder statements_;
  TestBuilder tests_;
  FunctionBuilder functions_;
  std::string doc_;                                      // of the declaration being built
  TaskParser::HeaderContext* header_ = nullptr;          // the first
  TaskParser::DeclarationContext* first_ = nullptr;      // the first declaration
  TaskParser::DeclarationContext* misplaced_ = nullptr;  // the first that no library holds
  std::optional<Span> start_;                            // the first start pose
  std::optional<Span> after_end_;                        // the first word after `after_end`
  std::optional<Span> onboard_;                          // the first `onboard`
};

}  // namespace

SyntaxTree BuildSyntaxTree(TaskParser::FileContext& file,
                           const std::map<uint32_t, std::string>& docs, SyntaxReport& report) {
  return TreeBuilder(docs, report).Build(file);
}

}  // namespace compiler
