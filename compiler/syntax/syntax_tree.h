// The syntax tree of a `.task` file: what was written, nothing resolved yet. Every node knows its
// place in the source.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "compiler/source/source_file.h"
#include "compiler/syntax/table_file.h"

namespace compiler {

struct Identifier {
  std::string text;
  Span span;
};

// ---- Units -------------------------------------------------------------------------------------

// Stands in a function's declaration for the unit of what it is given.
inline constexpr std::string_view kAnyUnit = "unit";

// `N m`, `m/s^2`, `1/s`: a product of named units with integer powers.
struct UnitFactor {
  Identifier name;  // "m", "ms", "deg", ...; in a function also kAnyUnit
  int power = 1;
};
struct UnitExpression {
  std::vector<UnitFactor> factors;  // empty: a plain number
  Span span;
  bool is_lost = false;  // it is wrong, which has been reported
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
struct MethodExpression {  // `v.norm()`, `joint.angle(hip)`: of other languages
  ExpressionPtr object;
  Identifier name;
  Span parenthesis;  // the opening one
  std::vector<ExpressionPtr> arguments;
};
struct LostExpression {};  // had an error of syntax, which has been reported

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
  ExpressionPtr tolerance{};  // of `a == b within 1e-9`; null: none
};

struct Expression {
  Span span;
  std::variant<NumberLiteral, BoolLiteral, NameExpression, MemberExpression, IndexExpression,
               RangeExpression, SetExpression, CallExpression, UnaryExpression, BinaryExpression,
               MethodExpression, LostExpression>
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

// What is assigned to, or given in a test: `sum`, `place.xy`, `touched[feet]`, `contact[head]`.
// The last of several parts between dots is the member if it consists of x, y, z and w only; so in
// `cart.x` it may also be the end of a sensor's name.
struct Target {
  Identifier name;                             // of a sensor, with its dots: `base.velocity`
  std::optional<Identifier> member{};          // `.xy`
  std::vector<ExpressionPtr> items{};          // `[feet]`; empty: no index
  std::optional<Identifier> indexed_member{};  // `.z` behind the index
  Span span{};
};

enum class AssignOperator { kSet, kAdd, kSubtract, kMultiply, kDivide };
struct AssignStatement {  // `sum += reward`; also the anonymous `reward += e`
  Target target;
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

struct ForStatement {  // `for l in links - feet { ... }`, `for i in 0..3 { ... }`
  Identifier variable;
  std::vector<ExpressionPtr> items;  // what stands after `in`: an index set
  Span items_span;
  Block body;
};

enum class MemoryScope { kPerRun, kPerEpisode, kPerAction };
struct OnceStatement {  // `once per action if fallen { ... } else if rolled { ... }`
  MemoryScope scope = MemoryScope::kPerAction;
  std::vector<IfBranch> branches;  // of which one runs, once
};

struct RewardStatement {  // `reward fall = -4`, `reward rate forward = ...`
  std::string doc;
  bool is_rate = false;
  Identifier name;
  Expression value;
};

// `reward fall = -4`, `reward rate forward = ...`, `reward potential near = ...`
enum class RewardKind { kPayment, kRate, kPotential };

enum class EndKind { kSuccess, kFailure, kTruncated };
struct EndStatement {  // `end_episode failure "why"`, `truncate_episode "why"`
  EndKind kind;
  std::string reason;
  Span reason_span;
  Span span;
};

enum class Reduction { kLast, kSum, kMax, kMin, kMean };
struct LogStatement {  // `log speed = norm(base.velocity)`, `log max impact = ...`
  std::string doc;
  Reduction reduction = Reduction::kLast;
  Identifier name;
  Expression value;
};

struct RequireStatement {  // `require norm(base.position) < 100 m`, `require ... "why"`
  Expression condition;
  std::string reason;  // empty where none is given
  std::string text;    // of the condition, as written, in one line
};

struct RedrawStatement {  // `redraw velocity`
  Identifier goal;
};

struct NextStatement {  // `next lift`: only in a phase
  Identifier phase;
};

struct Statement {
  Span span;
  std::variant<LetStatement, AssignStatement, IfStatement, ForStatement, OnceStatement,
               RewardStatement, EndStatement, LogStatement, RequireStatement, RedrawStatement,
               NextStatement>
      node;
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

struct SensorDeclaration {  // `sensor pole.angle: real [rad] in -180 deg .. 180 deg`
  std::string doc;
  Identifier name;  // may be dotted: `base.velocity`
  TypeExpression type;
  std::optional<UnitExpression> unit;
  std::optional<Expression> minimum;  // of each element
  std::optional<Expression> maximum;
};

struct ParamDeclaration {  // `param weight: real [1/s] = 4.0 in 0 .. 20`
  std::string doc;
  Identifier name;
  TypeExpression type;
  std::optional<UnitExpression> unit;
  Expression initial;
  std::optional<Expression> minimum;
  std::optional<Expression> maximum;
};

struct MemoryDeclaration {  // `memory fallen: bool = false per action`
  std::string doc;
  Identifier name;
  TypeExpression type;
  std::optional<UnitExpression> unit;
  Expression initial;
  MemoryScope scope = MemoryScope::kPerEpisode;
};

// How a goal is drawn: what follows its type.
struct GoalDraw {
  Expression value;  // with `uniform`, `normal`, `choose`
  // `per 3 s .. 8 s`, `per 2 s`: the time from one draw to the next; nothing: once per episode.
  std::optional<Expression> shortest;
  std::optional<Expression> longest;
};
struct GoalDeclaration {  // `goal velocity: vec2 [m/s] = uniform(-1 m/s, 1 m/s) per 3 s .. 8 s`
  std::string doc;
  Identifier name;
  TypeExpression type;
  std::optional<UnitExpression> unit;
  GoalDraw draw;
};

// What the learner sees: `observe base.up`, `observe clock = sin(angle)`.
struct ObserveDeclaration {
  std::string doc;
  Identifier name;        // where none is given, the value's text as `taskc fmt` sets it
  bool has_name = false;  // it is given
  Expression value;
};
struct OnboardDeclaration {  // `observe onboard`: nothing is observed that the robot cannot sense
  Identifier word;
};

struct MetricDeclaration {  // `metric distance = base.position.x`, `metric max height = ...`
  std::string doc;
  Reduction reduction = Reduction::kLast;
  Identifier name;
  Expression value;
};

// `reward potential near = -norm(base.position.xy)`: pays each action by how much it has grown.
struct PotentialDeclaration {
  std::string doc;
  Identifier name;
  Expression value;
};

struct ConstDeclaration {  // `const reach: real [m] = 5 cm`
  std::string doc;
  Identifier name;
  TypeExpression type;
  std::optional<UnitExpression> unit;
  Expression value;
};

// Where the numbers of a table stand.
struct TableSource {
  std::string path;  // as written: relative to the folder of the file it stands in
  Span path_span;
  std::optional<TableFile> file{};  // nothing: not read, or with errors in it
};
struct TableDeclaration {  // `table gait: real[joint] [rad] = "walk.csv"`
  std::string doc;
  Identifier name;
  TypeExpression type;
  std::optional<UnitExpression> unit;
  TableSource source;
};

struct SetDeclaration {  // `set supports = {feet, hands}`
  std::string doc;
  Identifier name;
  std::vector<ExpressionPtr> items;  // an index set
  Span items_span;
};

struct EventDeclaration {  // `on end_of_time_step { ... }`
  std::string doc;
  EventKind event;
  Identifier name;
  Block body;
  // In a task that extends another: what it and further ones add to the base's block, each in a
  // scope of its own.
  std::vector<Block> appended{};
  bool is_known = true;  // false: which event this is was written wrongly, and that reported
};

// How long a phase may last, and what comes then.
struct PhaseLimit {  // `within 3 s else reach`
  Expression time;
  Identifier otherwise;
};
struct PhaseDeclaration {  // `phase lift within 3 s else reach { ... }`
  std::string doc;
  Identifier name;
  std::optional<PhaseLimit> limit;
  Block body;
};

struct StartDeclaration {  // `start standing`, `start standing or lying { ... }`
  std::vector<Identifier> poses;
  std::optional<Block> block{};
};

// What the task does from the end that it reaches to the end of the episode.
enum class AfterEnd { kStop, kContinue };
struct AfterEndDeclaration {  // `after_end continue`
  AfterEnd behavior = AfterEnd::kStop;
  Identifier word;  // "continue"
};

struct ImportDeclaration {  // `import "shaping.task"`
  std::string path;         // as written: relative to the folder of the file it stands in
  Span path_span;
};

struct FunctionParameter {  // `distance: real [m]`
  Identifier name;
  TypeExpression type;
  std::optional<UnitExpression> unit;
};
// `fn near(d: real [m]) -> real = exp(-d / 1 m)`, or with a block of `let`s and a `return`.
struct FunctionDeclaration {
  std::string doc;
  Identifier name;
  std::vector<FunctionParameter> parameters;
  TypeExpression result;
  std::optional<UnitExpression> unit;
  std::vector<LetStatement> lets;
  Expression value;
};

// ---- Only in a task that extends another --------------------------------------------------------

struct ParamOverride {  // `override param direction = -1`; type and unit are the base's
  Identifier name;
  Expression initial;
  std::optional<Expression> minimum;  // nothing: the base's range
  std::optional<Expression> maximum;
};
struct ConstOverride {  // `override const reach = 10 cm`; type and unit are the base's
  Identifier name;
  Expression value;
};
struct TableOverride {  // `override table gait = "run.csv"`; type and unit are the base's
  Identifier name;
  TableSource source;
};
struct GoalOverride {  // `override goal velocity = uniform(0 m/s, 2 m/s)`; type and unit stay
  Identifier name;
  GoalDraw draw;
};
struct RewardOverride {  // `override reward rate roll = ...`: in place of every statement of the
                         // term, or of its potential
  RewardStatement reward;
  bool is_potential = false;
};

// ---- Tests --------------------------------------------------------------------------------------

struct GivenStatement {  // `given contact[head] = true`; a sensor, param, memory or `time_step`
  Target target;
  Expression value;
};
struct FiredEvent {  // `100 * end_of_time_step`
  EventKind event;
  Identifier name;
  uint32_t times = 1;
};
struct FireStatement {  // `fire start_of_action, end_of_time_step`
  std::vector<FiredEvent> events;
};
struct ExpectStatement {  // `expect total(fall) == -4`
  Expression condition;
};
struct ExpectEndStatement {  // `expect end_episode failure "why"`, `expect truncate_episode "why"`
  EndStatement end;
};
struct TestStatement {
  Span span;
  std::variant<GivenStatement, FireStatement, ExpectStatement, ExpectEndStatement> node;
};

struct TestDeclaration {  // `test "a fall is paid once" { ... }`
  std::string doc;
  std::string name;
  Span name_span;
  std::vector<TestStatement> statements;
};

// ---- The file -----------------------------------------------------------------------------------

struct Declaration {
  Span span;
  std::variant<SensorDeclaration, ParamDeclaration, MemoryDeclaration, GoalDeclaration,
               ObserveDeclaration, OnboardDeclaration, MetricDeclaration, PotentialDeclaration,
               ConstDeclaration, SetDeclaration, TableDeclaration, EventDeclaration,
               PhaseDeclaration, StartDeclaration, AfterEndDeclaration, ImportDeclaration,
               FunctionDeclaration, ParamOverride, ConstOverride, TableOverride, GoalOverride,
               RewardOverride, TestDeclaration>
      node;
  std::optional<Span> override_span{};  // of the word `override`, where it stands before it
  bool is_imported = false;             // of a library, which serves other tasks as well
};

// `allow W0706, W0712` before a declaration, a statement or the header: these warnings are not
// given for anything inside it. Before the header: for the whole file.
struct Allowance {
  std::vector<Identifier> codes;
  Span covers;
};

struct BaseTask {  // `extends "forward_rolling.task"`
  std::string path;
  Span path_span;
};

struct WorldFile {  // `in "ball.toml"`
  std::string path;
  Span path_span;
  // Its number in Sources::files(), and that of its height map.
  std::optional<size_t> file{};
  std::optional<size_t> map_file{};
};

// What is not in a tree with errors, so that nothing is said about what may depend on it.
struct LostText {
  // Names that may have been declared, and texts of ends.
  std::set<std::string, std::less<>> words;
  bool has_header = false;   // the header could not be read: the robot is not known
  bool has_imports = false;  // a file with functions
  bool has_code = false;     // statements or declarations
  // Declarations of which not even the names are known: those of the task that is extended, or what
  // was written without a name.
  bool has_anything = false;

  bool is_empty() const { return !has_header && !has_imports && !has_anything && !has_code; }
};

struct SyntaxTree {
  std::string doc;                  // the `///` lines before `task`
  std::optional<Identifier> task;   // nothing: a library, which has no rewards, memory and the like
  std::optional<Identifier> robot;  // `for humanoid`
  std::optional<WorldFile> world;
  std::optional<BaseTask> base;
  std::vector<Declaration> declarations;
  std::vector<Allowance> allowances;
  LostText lost;
};

}  // namespace compiler
