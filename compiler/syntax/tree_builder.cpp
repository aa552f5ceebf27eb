#include "compiler/syntax/tree_builder.h"

#include <string>
#include <utility>

#include "compiler/syntax/expression_builder.h"
#include "compiler/syntax/statement_builder.h"
#include "compiler/syntax/unit_builder.h"
#include "compiler/syntax/word_lookup.h"

namespace compiler {
namespace {

using grammar::TaskParser;

class TreeBuilder {
 public:
  TreeBuilder(const std::map<uint32_t, std::string>& docs, SyntaxReport& report)
      : docs_(docs), report_(report), expressions_(report), statements_(report, docs) {}

  SyntaxTree Build(TaskParser::FileContext& file) {
    if (file.header()->exception == nullptr) Header(*file.header());
    for (TaskParser::DeclarationContext* declaration : file.declaration()) {
      if (declaration->exception == nullptr) Declare(*declaration);
    }
    return std::move(tree_);
  }

 private:
  void Header(TaskParser::HeaderContext& context) {
    tree_.doc = DocOf(context);
    tree_.task = BuildName(*context.name(0));
    if (context.robot != nullptr) tree_.robot = BuildName(*context.robot);
  }

  void Declare(TaskParser::DeclarationContext& context) {
    auto& inner = *static_cast<antlr4::ParserRuleContext*>(context.children.front());
    Declaration declaration{SpanOf(inner), {}};
    if (auto* start = context.start()) {
      declaration.node = Start(*start);
    } else if (auto* sensor = context.sensor()) {
      declaration.node = Sensor(*sensor);
    } else if (auto* param = context.param()) {
      declaration.node = Param(*param);
    } else if (auto* memory = context.memory()) {
      declaration.node = Memory(*memory);
    } else if (auto* metric = context.metric()) {
      declaration.node = Metric(*metric);
    } else {
      declaration.node = Event(*context.event());
    }
    tree_.declarations.push_back(std::move(declaration));
  }

  StartDeclaration Start(TaskParser::StartContext& context) {
    const Identifier pose = BuildName(*context.name());
    if (start_) {
      Diagnostic diagnostic =
          MakeDiagnostic(code::kRepeatedHeader, SpanOf(context), "the start pose is given twice");
      diagnostic.labels.push_back({start_->span, "first given here"});
      diagnostic.help = "remove one of them";
      report_.Add(std::move(diagnostic));
    }
    if (!start_) start_ = pose;
    return {pose};
  }

  SensorDeclaration Sensor(TaskParser::SensorContext& context) {
    SensorDeclaration sensor;
    sensor.doc = DocOf(context);
    for (TaskParser::NameContext* part : context.name()) {
      const Identifier name = BuildName(*part);
      const bool is_first = sensor.name.text.empty();
      sensor.name.text += is_first ? name.text : "." + name.text;
      sensor.name.span = is_first ? name.span : Cover(sensor.name.span, name.span);
    }
    sensor.type = Type(*context.type());
    sensor.unit = UnitOf(*context.type());
    return sensor;
  }

  ParamDeclaration Param(TaskParser::ParamContext& context) {
    ParamDeclaration param;
    param.doc = DocOf(context);
    param.name = BuildName(*context.name());
    param.type = Type(*context.type());
    param.unit = UnitOf(*context.type());
    param.initial = expressions_.Build(*context.initial);
    if (context.minimum != nullptr) {
      param.minimum = expressions_.Build(*context.minimum);
      param.maximum = expressions_.Build(*context.maximum);
    }
    return param;
  }

  MemoryDeclaration Memory(TaskParser::MemoryContext& context) {
    MemoryDeclaration memory;
    memory.doc = DocOf(context);
    memory.name = BuildName(*context.name());
    memory.type = Type(*context.type());
    memory.unit = UnitOf(*context.type());
    memory.initial = expressions_.Build(*context.expression());
    if (context.scope != nullptr) {
      memory.scope = LookUp(BuildName(*context.scope), kScopeNames, code::kUnknownWord,
                            "a scope of a memory", report_);
    }
    return memory;
  }

  MetricDeclaration Metric(TaskParser::MetricContext& context) {
    MetricDeclaration metric;
    metric.doc = DocOf(context);
    metric.name = BuildName(*context.name());
    metric.value = expressions_.Build(*context.expression());
    if (context.reduction != nullptr) {
      metric.reduction = LookUp(BuildName(*context.reduction), kReductionNames, code::kUnknownWord,
                                "a reduction of a metric", report_);
    }
    return metric;
  }

  EventDeclaration Event(TaskParser::EventContext& context) {
    const Identifier name = BuildName(*context.name());
    const EventKind kind = LookUp(name, kEventNames, code::kUnknownEvent, "an event", report_);
    return {DocOf(context), kind, name, statements_.Build(*context.block())};
  }

  static TypeExpression Type(TaskParser::TypeContext& context) {
    TypeExpression type{BuildName(*context.name(0)), std::nullopt, {}};
    type.span = type.name.span;
    if (context.index != nullptr) type.index = BuildName(*context.index);
    if (context.length != nullptr) type.index = BuildName(*context.length);
    if (type.index) type.span = Cover(type.span, SpanOf(*context.RIGHT_BRACKET(0)->getSymbol()));
    return type;
  }

  std::optional<UnitExpression> UnitOf(TaskParser::TypeContext& context) {
    if (context.unit() == nullptr) return std::nullopt;
    return BuildUnit(*context.unit(), report_);
  }

  std::string DocOf(antlr4::ParserRuleContext& context) const {
    const auto found = docs_.find(SpanOf(context).begin);
    return found != docs_.end() ? found->second : "";
  }

  const std::map<uint32_t, std::string>& docs_;
  SyntaxReport& report_;
  ExpressionBuilder expressions_;
  StatementBuilder statements_;
  SyntaxTree tree_;
  std::optional<Identifier> start_;  // the first start pose
};

}  // namespace

SyntaxTree BuildSyntaxTree(TaskParser::FileContext& file,
                           const std::map<uint32_t, std::string>& docs, SyntaxReport& report) {
  return TreeBuilder(docs, report).Build(file);
}

}  // namespace compiler
