// A task that has passed all checks: every name resolved, every expression typed, every index
// known. What is built from it needs no further look at the source, and cannot fail.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/source/source_file.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Powers of the base dimensions. Angles count as a dimension, so that degrees, radians and plain
// numbers cannot be mixed up.
struct Unit {
  int8_t meter = 0;
  int8_t kilogram = 0;
  int8_t second = 0;
  int8_t radian = 0;
  int8_t any = 0;  // inside of a function: of `unit`, which each call says

  bool operator==(const Unit&) const = default;
};
// "m/s", "N m" where such a name exists; "" for a plain number.
std::string ToString(const Unit& unit);

enum class Scalar { kBool, kInt, kReal };

enum class Shape {
  kScalar,
  kVector,      // vec2, vec3, vec4: rows elements
  kMatrix,      // mat2, mat3, mat4: rows x columns, row major
  kQuaternion,  // w, x, y, z
  kArray        // of rows entries, indexed by an enumeration of the robot, or by 0 .. rows-1
};

// A value's type without its unit. Its elements are numbers or conditions, row by row: those of a
// matrix, or of an array with the elements of each entry side by side.
struct Type {
  Scalar scalar = Scalar::kReal;
  Shape shape = Shape::kScalar;
  uint32_t rows = 1;
  uint32_t columns = 1;  // of an array: the number of elements of an entry
  std::string index{};   // "link" for an array over that enumeration of the robot, else empty
  // Of an array: what its entries are, a scalar, a vector or a quaternion.
  Shape entry = Shape::kScalar;

  uint32_t size() const { return rows * columns; }
  bool operator==(const Type&) const = default;
};
// As written in a task: "real", "vec3", "bool[link]", "vec3[4]".
std::string ToString(const Type& type);

// ---- Expressions --------------------------------------------------------------------------------

struct CheckedExpression;
using CheckedExpressionPtr = std::unique_ptr<CheckedExpression>;

struct Constant {    // always a scalar; in SI units
  double value = 0;  // 0 or 1 for a bool; an exact integer for an int
};
struct ConstRead {     // of a const with a shape; a scalar one is a Constant
  uint32_t index = 0;  // into CheckedTask::consts
};
struct SensorRead {
  uint32_t sensor = 0;  // index into CheckedTask::sensors
};
struct ParamRead {
  uint32_t param = 0;
};
struct MemoryRead {
  uint32_t memory = 0;
};
struct LocalRead {
  uint32_t local = 0;  // index into the locals of the event, or of the function
};
struct ArgumentRead {
  uint32_t argument = 0;  // index into CheckedFunction::arguments; only inside that function
};
struct RewardSoFar {};  // the sum of this callback's terms so far
struct TimeStep {};     // length of this event's time step [s]

// Some elements of `operand`, in order: swizzles, indices and index sets alike. A scalar result has
// exactly one element.
struct Elements {
  CheckedExpressionPtr operand;
  std::vector<uint32_t> indices;
};

// Element-wise where one or both operands have a shape; then a scalar operand applies to each.
struct CheckedUnary {
  UnaryOperator op;
  CheckedExpressionPtr operand;
};
struct CheckedBinary {
  BinaryOperator op;
  CheckedExpressionPtr left;
  CheckedExpressionPtr right;
};

// `left == right within tolerance`, of reals; only in a test's `expect`.
struct CheckedWithin {
  CheckedExpressionPtr left;
  CheckedExpressionPtr right;
  CheckedExpressionPtr tolerance;
  bool is_equal = true;  // false: `!=`
};

// From the one list in builtin_table.def.
enum class Builtin {
#define BUILTIN(id, name, least, most, arguments, units, usage) id,
#include "compiler/check/builtin_table.def"
  kVector  // its arguments, scalars, as the elements of a value of any shape
};
struct BuiltinCall {
  Builtin function;
  std::vector<CheckedExpressionPtr> arguments;
};
// Where the function takes single numbers and is given more, it computes each element of the result
// by itself; an argument that is a scalar then applies to each.
struct FunctionCall {
  uint32_t function = 0;                        // index into CheckedTask::functions
  std::vector<CheckedExpressionPtr> arguments;  // of the types that the function declares
  bool is_each = false;
};
// What only a test's `expect` reads; see docs/language.md.
struct TestRead {
  enum Kind {
    kTotal,        // what reward term `index` has paid since the test began
    kMetric,       // metric `index`, as it would be recorded if the episode ended now
    kLog,          // log `index`, in the same way
    kReward,       // what the last callback has paid
    kObservation,  // observation `index`, as the learner would see it now
    kEnded         // whether an end was reached since the test began, or a requirement did not hold
  };
  Kind kind = kTotal;
  uint32_t index = 0;
};
// A random number, only in the equation of a goal. Of several, each element is drawn by itself; a
// scalar argument then applies to each. Only a choice among values with a shape is one choice.
enum class Distribution {
  kUniform,  // from the first argument to the second
  kNormal,   // with the first as its mean and the second as its standard deviation
  kChoice    // one of the arguments, each as likely
};
struct Draw {
  Distribution distribution = Distribution::kUniform;
  uint32_t site = 0;  // its number among those of the goal
  std::vector<CheckedExpressionPtr> arguments;
};
// What a table says for an argument, a real scalar; see table_value.h.
struct TableRead {
  uint32_t table = 0;    // index into CheckedTask::tables
  bool repeats = false;  // after the last row comes the first again; else the ends hold
  CheckedExpressionPtr operand;
};
struct IntToReal {  // inserted by the checker; there are no casts in the language
  CheckedExpressionPtr operand;
};

struct CheckedExpression {
  Span span;
  Type type;
  Unit unit;
  std::variant<Constant, ConstRead, SensorRead, ParamRead, MemoryRead, LocalRead, ArgumentRead,
               RewardSoFar, TimeStep, Elements, CheckedUnary, CheckedBinary, CheckedWithin,
               BuiltinCall, FunctionCall, Draw, TableRead, TestRead, IntToReal>
      node;
};

// ---- Statements ---------------------------------------------------------------------------------

struct CheckedStatement;
using CheckedBlock = std::vector<CheckedStatement>;

struct CheckedLet {
  uint32_t local = 0;
  CheckedExpression value;
};
struct CheckedAssign {
  uint32_t memory = 0;
  std::vector<uint32_t> elements;  // those that are set; empty: all
  AssignOperator op;
  CheckedExpression value;  // as many elements as are set; or a scalar, for each of them
};
struct CheckedIfBranch {
  CheckedExpression condition;
  CheckedBlock body;
};
struct CheckedIf {
  std::vector<CheckedIfBranch> branches;
  CheckedBlock otherwise;
};
// A loop is known before the run: its body stands here once for each pass, with the loop's variable
// replaced by its value.
struct CheckedPass {
  std::string value;  // of the variable: "head", "3"
  CheckedBlock body;
};
struct CheckedFor {
  std::string variable;
  std::vector<CheckedPass> passes;
};
struct CheckedReward {
  uint32_t term = 0;
  bool is_rate = false;
  CheckedExpression value;  // a real scalar
};
struct CheckedEnd {
  uint32_t end = 0;
};
struct CheckedLog {
  uint32_t log = 0;
  CheckedExpression value;  // a real scalar
};
struct CheckedRequire {
  uint32_t requirement = 0;
  CheckedExpression condition;
};

// Draws a goal anew, unless the host has set it.
struct CheckedRedraw {
  uint32_t goal = 0;
};

// Only in a phase: the phase from the next time step on, unless the step has reached such a
// statement before.
struct CheckedNext {
  uint32_t phase = 0;
};
// The blocks of all phases, of which that of the present one runs; then the phase changes, if a
// CheckedNext says so, and its time is 0 again.
struct CheckedPhaseSwitch {
  std::vector<CheckedBlock> blocks;
};

// Brings a time function up to date, with the value that its argument has now; at the start of an
// episode with its first one, where the function does not merely count time.
struct CheckedAdvance {
  uint32_t function = 0;  // index into CheckedTask::time_functions
  bool is_start = false;
  CheckedExpression value;
  // A real [s]; of `delay` perhaps an int: time steps. Not at the start.
  std::optional<CheckedExpression> duration;
};

// Remembers a potential where an episode starts, and pays by how much it has grown where an action
// or the episode is over: discount * phi(s') - phi(s), where phi is 0 at a terminal end.
struct CheckedPotentialStep {
  enum Moment { kStart, kAction, kEnd };
  uint32_t potential = 0;  // index into CheckedTask::potentials
  Moment moment = kStart;
  CheckedExpression value;  // a real scalar
};

struct CheckedStatement {
  Span span;
  std::variant<CheckedLet, CheckedAssign, CheckedIf, CheckedFor, CheckedReward, CheckedEnd,
               CheckedLog, CheckedRequire, CheckedRedraw, CheckedNext, CheckedPhaseSwitch,
               CheckedAdvance, CheckedPotentialStep>
      node;
};

// ---- The start ----------------------------------------------------------------------------------

enum class StartValue {
  kJointAngle,
  kJointVelocity,
  kBasePosition,
  kBaseRoll,
  kBasePitch,
  kBaseYaw,
  kBaseVelocity,
  kBaseAngularVelocity
};
struct CheckedStartValue {
  StartValue value = StartValue::kJointAngle;
  std::string name;     // "joint.angle"
  uint32_t memory = 0;  // the host puts there what it is in the pose, and takes what it has become
  // In the poses; one for each element.
  std::vector<double> minimum{};
  std::vector<double> maximum{};
};

// ---- The task -----------------------------------------------------------------------------------

// `const NAME: TYPE = ...`
struct CheckedConst {
  std::string name;
  Type type;
  Unit unit;
  std::vector<double> elements;  // in SI units; 0 or 1 for a bool, exact integers for ints
};
// `set NAME = ...`
struct CheckedSet {
  std::string name;
  std::string parts;               // "link": of that enumeration of the robot; empty: numbers
  std::vector<uint32_t> indices;   // in their order
  std::vector<std::string> names;  // of the parts, or the numbers
};
// `table NAME: TYPE = "FILE"`
struct CheckedTable {
  std::string name;
  std::string doc;
  Type type;  // of real elements
  Unit unit;
  std::string file;      // as written in the task
  std::string argument;  // what its column is called
  Unit argument_unit;
  // In SI units. Rotations have length 1, each the nearer to that of the row before of the two
  // quaternions that mean it.
  std::vector<double> arguments;  // of each row, increasing; at least two
  std::vector<double> elements;   // of each row, one row after the other

  double duration() const { return arguments.back() - arguments.front(); }
};
struct CheckedSensor {
  std::string name;
  std::string doc{};
  Type type;
  Unit unit;
  // Bit e: event e reads it; bit TASKC_MEASURE: a metric does; bit TASKC_OBSERVE: an observation.
  uint32_t read_by = 0;
  // What the robot or the task says of its values; infinite where they say nothing. One for each
  // element.
  std::vector<double> minimum{};
  std::vector<double> maximum{};
  // The range is the robot author's claim, or follows from one: no stop, limit or length keeps the
  // values in it.
  bool is_nominal = false;
  bool is_onboard = true;  // a real robot can sense it
  // Of what is known of the robot and need not be sensed, which no CheckedTask has: one for each
  // element.
  std::vector<double> constant{};
  // Of a thing of the world: its elements when an episode begins, empty where they are 0.
  std::vector<double> at_rest{};
};
struct CheckedParam {
  std::string name;
  std::string doc;
  Type type;  // a scalar
  Unit unit;
  double initial = 0;
  double minimum = 0;
  double maximum = 0;
  Span span{};
};
struct CheckedMemory {
  std::string name;
  Type type;
  Unit unit;
  MemoryScope scope;
  CheckedExpression initial;  // a constant or a param, as a scalar: the value of every element
  Span span;
  std::string doc{};
  bool is_declared = true;  // false: see hidden_memory.h
};
// A goal lives in memory: its value, whether the host holds it, how often it was drawn in this
// episode, and the time that is left until it is drawn again. It is drawn when memory is
// initialized, and by CheckedRedraw.
struct CheckedGoal {
  std::string name;
  std::string doc;
  Type type;
  Unit unit;
  uint32_t memory = 0;      // of its value
  uint32_t held = 0;        // memory: the host sets it, it is not drawn
  uint32_t draws = 0;       // memory: how often it was drawn
  uint32_t stream = 0;      // of random numbers: the hash of its name
  CheckedExpression value;  // or a scalar, for each of its elements
  struct Interval {
    uint32_t left = 0;  // memory: the time until it is drawn again [s]
    CheckedExpression length;
  };
  std::optional<Interval> interval;  // nothing: once per episode
  Span span{};
};
// A phase of a task; its block is in the task's one CheckedPhaseSwitch, which ends the block of
// `end_of_time_step`.
struct CheckedPhase {
  std::string name;
  std::string doc;
  Span span{};  // of its name
  // How long it may last; the statements for it end its block.
  struct Limit {
    CheckedExpression time;  // a real [s]: a constant or a param
    uint32_t otherwise = 0;  // the phase that comes then
    Span span{};
  };
  std::optional<Limit> limit{};
};
// What a task with phases remembers of them, both per episode.
struct PhaseMemory {
  uint32_t present = 0;  // memory, an int: the index of the present phase
  uint32_t time = 0;     // memory, a real [s]: how long that has been the present one
};
// A value that follows from another one and its past. It lives in memory, is computed once at the
// end of each time step, before the blocks, and keeps its value until the next: what reads it is a
// MemoryRead.
enum class TimeFunction {
  kPrevious,  // what it was a time step ago
  kChange,    // by how much it has changed since
  kRate,      // the same per second
  kDelay,     // what it was some time ago
  kSmooth,    // a running mean, in which the past counts less and less
  kHeld,      // whether it has been true for some time
  kSince,     // how long it has not been true
  kRising,    // whether it has become true in this step
  kFalling    // whether it has become false in this step
};
struct CheckedTimeFunction {
  TimeFunction function = TimeFunction::kPrevious;
  uint32_t value = 0;  // memory: what it gives
  uint32_t past = 0;   // memory: what it needs of before; of a delay `steps` of them, one after
                       // the other
  uint32_t steps = 1;  // how many values `past` has room for
  uint32_t next = 0;   // memory, of a delay: where in `past` the next one goes
  Span span{};         // of its first call
};
// What the learner sees: as many doubles as the value has elements, a bool as 0 or 1.
struct CheckedObservation {
  std::string name;
  std::string doc;
  CheckedExpression value;  // of any type
  uint32_t offset = 0;      // of its first element among all that the learner sees
  bool has_name = false;    // false: its name is the text of its value
  // Of each element; infinite until ComputeBounds() has told (compiler/analyze/analyze.cpp).
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  Span span{};  // of its name
};
// A potential lives in memory: its value where the action that runs began, whether that is known
// (after a swap in the middle of an episode it is not), and whether the action has been paid for.
// So what it pays telescopes whatever its equation reads, and an episode that ends with an action
// pays for that action once.
struct CheckedPotential {
  uint32_t term = 0;   // index into CheckedTask::terms
  uint32_t last = 0;   // memory
  uint32_t known = 0;  // memory
  uint32_t paid = 0;   // memory, of the action
  Span span{};         // of its name
};
struct CheckedTerm {
  std::string name;
  std::string doc;
  Span span{};  // of its first statement
};
struct CheckedMetric {
  std::string name;
  std::string doc;
  Reduction reduction;
  CheckedExpression value;  // a real scalar
  Span span{};              // of its name
};
struct CheckedLogValue {
  std::string name;
  std::string doc;
  Unit unit;  // of its first statement; all have the same
  Reduction reduction;
  Span span{};
};
struct CheckedEndReason {
  EndKind kind;
  std::string reason;
  Span span{};
};
struct CheckedRequirement {
  std::string reason;  // the condition's own text where none is given
  Span span{};
};
struct Local {
  std::string name;
  Type type;
  Unit unit;
};
struct CheckedEvent {
  Span span;                 // of the event's name
  bool is_declared = false;  // false: the task says nothing about this event
  std::vector<Local> locals;
  CheckedBlock body;
};

// A function computes from its arguments alone. It calls only functions that stand before it in
// CheckedTask::functions: none ever calls itself.
struct CheckedFunction {
  std::string name;
  std::string doc;
  Span span{};  // of its name
  std::vector<Local> arguments;
  std::vector<Local> locals;
  std::vector<CheckedLet> lets;  // in their order
  CheckedExpression value;
};

// ---- Tests --------------------------------------------------------------------------------------

struct CheckedGiven {
  enum Target { kSensor, kParam, kMemory, kGoal, kTimeStep, kDiscount };
  Target target = kSensor;
  uint32_t index = 0;              // into the task's sensors, params, memory or goals
  std::vector<uint32_t> elements;  // empty: all
  CheckedExpression value;         // a constant for each element, or one scalar for all of them
  bool is_implied = false;         // by the orientation that the statement gives
};
struct CheckedFire {
  EventKind event;
  uint32_t times = 1;
};
struct CheckedExpect {
  CheckedExpression condition;
};
struct CheckedExpectEnd {
  EndKind kind;
  std::string reason;
};
struct CheckedTestStatement {
  Span span;
  std::variant<CheckedGiven, CheckedFire, CheckedExpect, CheckedExpectEnd> node;
};
struct CheckedTest {
  std::string name;
  Span span{};  // of its name
  std::vector<CheckedTestStatement> statements;
};

// How an episode begins: in one of some poses, each as likely, of which the block changes
// something. It is drawn before the episode starts, with memory and goals as they are then.
struct CheckedStart {
  std::vector<std::string> poses;           // none: the robot's first
  Span span{};                              // of their names
  uint32_t stream = 0;                      // of random numbers; the first is that of the pose
  std::vector<CheckedStartValue> values{};  // those that the block names
  CheckedEvent block{};
  // Of each joint, where there is a block: its name and its stops [rad].
  std::vector<std::string> joints{};
  std::vector<double> low{};
  std::vector<double> high{};
};

struct CheckedTask {
  std::string name;
  std::string doc;
  std::string robot;               // "" where the task declares its own sensors
  std::vector<std::string> links;  // of the robot, in its order
  std::vector<std::string> joints;
  std::vector<std::string> sites;
  CheckedStart start{};
  // Of all events; infinite where no robot says [s].
  double longest_time_step = std::numeric_limits<double>::infinity();
  std::vector<CheckedConst> consts;
  std::vector<CheckedSet> sets;
  std::vector<CheckedTable> tables;
  std::vector<CheckedSensor> sensors;  // those that something reads
  std::vector<CheckedParam> params;
  std::vector<CheckedMemory> memory;
  // The one in which the task remembers, for the rest of an episode, that it has ended it; nothing:
  // it ends none, or its callbacks run on. See after_end.h.
  std::optional<uint32_t> ended{};
  std::vector<CheckedGoal> goals;
  std::vector<CheckedPhase> phases;                 // an episode begins in the first
  PhaseMemory phase_memory{};                       // where there are phases
  std::vector<CheckedTimeFunction> time_functions;  // each after those that its argument reads
  std::vector<CheckedObservation> observations;
  uint32_t observation_size = 0;  // the elements of all of them
  std::optional<Span> onboard{};  // where the task says `observe onboard`
  std::vector<CheckedTerm> terms;
  std::vector<CheckedPotential> potentials;
  std::vector<CheckedMetric> metrics;
  std::vector<CheckedLogValue> logs;
  std::vector<CheckedEndReason> ends;
  std::vector<CheckedRequirement> requirements;
  std::vector<CheckedFunction> functions;
  std::array<CheckedEvent, 8> events;  // indexed by EventKind
  std::vector<CheckedTest> tests;
};

}  // namespace compiler
