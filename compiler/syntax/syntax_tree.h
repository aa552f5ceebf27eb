// The syntax tree of a `.task` file: what was written, nothing resolved yet. Every node knows its
// place in the source.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/source/source_file.h"

namespace compiler {

struct Identifier {
  std::string text;
  Span span;
};

// ---- Units -------------------------------------------------------------------------------------

// `N m`, `m/s^2`, `1/s`: a product of named units with integer powers.
struct UnitFactor {
  Identifier name;  // "m", "ms", "deg", ...
  int power = 1;
};
struct UnitExpression {
  std::vector<UnitFactor> factors;  // empty: a plain number
  Span span;
};

// ---- Expressions -------------------------------------------------------------------------------

struct Expression;
using ExpressionPtr = std::unique_ptr<Expression>;

struct NumberLiteral {  // `20 s`, `0.25`, `3`
  double value = 0;
  bool is_integer = false;  // written without point and exponent
  std::optional<UnitExpression> unit;
};
struct BoolLiteral {
  bool value = false;
};
struct NameExpression {  // `fallen`, `base`, `reward`, `head`
  Identifier name;
};
struct MemberExpression {  // `base.position`, `.xy`
  ExpressionPtr object;
  Identifier member;
};
struct IndexExpression {  // `contact[body, head]`, `contact[2..7, links - feet]`
  ExpressionPtr object;
  std::vector<ExpressionPtr> items;
};
struct RangeExpression {  // `2..7`, both ends included; only inside an index
  ExpressionPtr first;
  ExpressionPtr last;
};
struct SetExpression {  // `{body, head}`; only inside an index
  std::vector<ExpressionPtr> items;
};
struct CallExpression {  // `norm(v)`
  Identifier function;
  std::vector<ExpressionPtr> arguments;
};

enum class UnaryOperator { kNegate, kNot };
struct UnaryExpression {
  UnaryOperator op;
  ExpressionPtr operand;
};

enum class BinaryOperator {
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kLess,
  kLessEqual,
  kGreater,
  kGreaterEqual,
  kEqual,
  kNotEqual,
  kAnd,
  kOr
};
struct BinaryExpression {
  BinaryOperator op;
  Span op_span;
  ExpressionPtr left;
  ExpressionPtr right;
};

struct Expression {
  Span span;
  std::variant<NumberLiteral, BoolLiteral, NameExpression, MemberExpression, IndexExpression,
               RangeExpression, SetExpression, CallExpression, UnaryExpression, BinaryExpression>
      node;
};

// ---- Types -------------------------------------------------------------------------------------

// `real`, `vec3`, `bool[link]`, `real[4]`.
struct TypeExpression {
  Identifier name;                  // element type or vector type
  std::optional<Identifier> index;  // what stands in the brackets: an enumeration or a number
  Span span;
};

// ---- Statements --------------------------------------------------------------------------------

struct Statement;
using Block = std::vector<Statement>;

struct LetStatement {  // `let speed = norm(base.velocity)`
  Identifier name;
  Expression value;
};

enum class AssignOperator { kSet, kAdd, kSubtract, kMultiply, kDivide };
struct AssignStatement {  // `sum += reward`; also the anonymous `reward += e`
  Identifier target;
  AssignOperator op;
  Expression value;
};

struct IfBranch {
  Expression condition;
  Block body;
};
struct IfStatement {
  std::vector<IfBranch> branches;  // `if`, then every `else if`
  std::optional<Block> otherwise;
};

struct RewardStatement {  // `reward fall = -4`, `reward rate forward = ...`
  std::string doc;
  bool is_rate = false;
  Identifier name;
  Expression value;
};

enum class EndKind { kSuccess, kFailure, kTruncated };
struct EndStatement {  // `end_episode failure "why"`, `truncate_episode "why"`
  EndKind kind;
  std::string reason;
  Span reason_span;
};

struct Statement {
  Span span;
  std::variant<LetStatement, AssignStatement, IfStatement, RewardStatement, EndStatement> node;
};

// ---- Declarations ------------------------------------------------------------------------------

enum class EventKind {  // in the order of the TASKC_*_OF_* constants
  kStartOfEpisode,
  kEndOfEpisode,
  kStartOfAction,
  kEndOfAction,
  kStartOfTimeStep,
  kEndOfTimeStep,
  kStartOfPhysicsStep,
  kEndOfPhysicsStep
};

struct SensorDeclaration {  // `sensor base_velocity: vec3 [m/s]`
  std::string doc;
  Identifier name;  // may be dotted: `base.velocity`
  TypeExpression type;
  std::optional<UnitExpression> unit;
};

struct ParamDeclaration {  // `param gain: real [1/s] = 4.0 in 0 .. 20`
  std::string doc;
  Identifier name;
  TypeExpression type;
  std::optional<UnitExpression> unit;
  Expression initial;
  std::optional<Expression> minimum;
  std::optional<Expression> maximum;
};

enum class MemoryScope { kPerRun, kPerEpisode, kPerAction };
struct MemoryDeclaration {  // `memory fallen: bool = false per action`
  std::string doc;
  Identifier name;
  TypeExpression type;
  std::optional<UnitExpression> unit;
  Expression initial;
  MemoryScope scope = MemoryScope::kPerEpisode;
};

enum class Reduction { kLast, kSum, kMax, kMin, kMean };
struct MetricDeclaration {  // `metric distance = base.position.x`, `metric max height = ...`
  std::string doc;
  Reduction reduction = Reduction::kLast;
  Identifier name;
  Expression value;
};

struct EventDeclaration {  // `on end_of_time_step { ... }`
  std::string doc;
  EventKind event;
  Identifier name;
  Block body;
};

struct Declaration {
  Span span;
  std::variant<SensorDeclaration, ParamDeclaration, MemoryDeclaration, MetricDeclaration,
               EventDeclaration>
      node;
};

struct SyntaxTree {
  std::string doc;  // the `///` lines before `task`
  Identifier task;
  std::optional<Identifier> robot;  // `for humanoid`
  std::optional<Identifier> start;  // `start standing`
  std::vector<Declaration> declarations;
};

}  // namespace compiler
