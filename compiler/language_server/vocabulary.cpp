#include "compiler/language_server/vocabulary.h"

#include <array>

namespace compiler {
namespace {

constexpr auto kDeclarations = std::to_array<ExplainedWord>({
    {"task", "The task's name, and the robot that it is written for: `task NAME for ROBOT`."},
    {"start", "How an episode begins: `start POSE or POSE { joint.angle += uniform(LOW, HIGH) }`."},
    {"after_end",
     "What the task does from the end that it reaches until the episode is over: `after_end "
     "continue`."},
    {"sensor",
     "A sensor that no robot has: `sensor NAME: TYPE [UNIT]`. A module or a host fills it."},
    {"param",
     "A number that can be set while the trainer runs: `param NAME: TYPE = VALUE in LOW .. HIGH`."},
    {"const", "A value that never changes: `const NAME: TYPE = VALUE`."},
    {"set",
     "A set of links, joints, sites or numbers, for indices and loops: `set NAME = links - feet`."},
    {"table",
     "Numbers of a CSV file, read with an argument between its rows: `table NAME: TYPE [UNIT] = "
     "\"FILE.csv\"`."},
    {"memory", "A value that is kept between callbacks: `memory NAME: TYPE = VALUE per action`."},
    {"goal",
     "What the robot is told, drawn at random: `goal NAME: TYPE = uniform(LOW, HIGH) per 3 s .. 8 "
     "s`."},
    {"observe",
     "What the learner sees: `observe VALUE`, `observe NAME = VALUE`; `observe onboard` warns of "
     "what a real robot cannot sense."},
    {"metric", "What success means, as opposed to the reward: `metric REDUCTION NAME = VALUE`."},
    {"reward potential",
     "Pays each action by how much a value has grown, so that the best policy stays the best: "
     "`reward potential NAME = VALUE`."},
    {"on", "What is done at an event: `on EVENT { ... }`."},
    {"phase",
     "A stretch of an episode with rewards and rules of its own: `phase NAME within 3 s else OTHER "
     "{ ... }`. The present one: `phase == NAME`, `observe phase`."},
    {"fn", "A function: `fn NAME(ARGUMENT: TYPE) -> TYPE = VALUE`."},
    {"import",
     "Imports the functions of a library: `import \"std/gait\"`, or of a file: `import \"FILE\"`."},
    {"test", "A test without a simulator: `test \"name\" { given ... fire ... expect ... }`."},
    {"override", "Replaces something of the task that this one extends."},
    {"allow", "Silences the warnings with these codes for what follows."},
});
constexpr auto kStatements = std::to_array<ExplainedWord>({
    {"let", "Gives a value a name: `let NAME = VALUE`."},
    {"reward", "Pays a named term; also the sum of the terms that this callback has paid so far."},
    {"reward rate", "Pays a named term per second."},
    {"if", "`if CONDITION { ... } else if CONDITION { ... } else { ... }`"},
    {"else", "What is done if no condition before it holds."},
    {"for",
     "Runs the block for each element: `for NAME in links - feet { ... }`, `for i in 0..3 { ... "
     "}`."},
    {"once per",
     "Runs the block when the condition first holds: `once per action if CONDITION { ... }`."},
    {"end_episode", "Ends the episode: `end_episode failure \"why\"`."},
    {"truncate_episode",
     "Ends the episode at a limit, from which the learner may bootstrap: `truncate_episode "
     "\"why\"`."},
    {"log", "A curve of any number: `log REDUCTION NAME = VALUE`."},
    {"require", "What must always hold: `require CONDITION \"why\"`."},
    {"redraw", "Draws a goal anew: `redraw NAME`."},
    {"next", "The phase from the next time step on: `next NAME`."},
    {"allow", "Silences the warnings with these codes for what follows."},
});
constexpr auto kTests = std::to_array<ExplainedWord>({
    {"given", "Sets a sensor, a param, a memory or a goal: `given NAME = VALUE`."},
    {"fire", "Fires events: `fire end_of_time_step, 100 * end_of_time_step`."},
    {"expect", "What must hold now: `expect CONDITION`, `expect end_episode failure \"why\"`."},
});
constexpr auto kBody = std::to_array<ExplainedWord>({
    {"let", "Gives a value a name: `let NAME = VALUE`."},
    {"return", "The function's value: `return VALUE`."},
});
constexpr auto kValues = std::to_array<ExplainedWord>({
    {"true", "The condition that always holds."},
    {"false", "The condition that never holds."},
    {"not", "Negates a condition."},
    {"pi", "The number pi, 3.14159..."},
    {"reward", "The sum of the terms that this callback has paid so far."},
    {"time_step", "The length of this event's time step, `real [s]`."},
});
constexpr auto kOperators = std::to_array<ExplainedWord>({
    {"and", "Whether both conditions hold."},
    {"or", "Whether one of two conditions holds."},
    {"within",
     "How far the sides may differ, in a test: `expect total(TERM) == 1 within 1e-9`; how long a "
     "phase may last: `phase NAME within 3 s else OTHER { ... }`."},
    {"in",
     "The range of a param or a sensor: `in LOW .. HIGH`; or the set of a loop; "
     "or the world of a task: `task NAME for ROBOT in \"FILE.toml\"`."},
    {"per",
     "When a memory is reset to its initial value: `per action`; when a goal is drawn: `per 3 s .. "
     "8 s`."},
    {"extends", "Builds on another task: `task NAME extends \"FILE\"`."},
    {"for", "The robot: `task NAME for ROBOT`."},
});
constexpr auto kEvents = std::to_array<ExplainedWord>({
    {"start_of_episode", "When an episode begins."},
    {"end_of_episode", "When an episode has ended."},
    {"start_of_action", "When the learner has chosen an action."},
    {"end_of_action", "When an action is done; the learner then gets the rewards since its start."},
    {"start_of_time_step", "Before each time step."},
    {"end_of_time_step", "After each time step."},
    {"start_of_physics_step", "Before each step of the simulation."},
    {"end_of_physics_step", "After each step of the simulation."},
});
constexpr auto kReductions = std::to_array<ExplainedWord>({
    {"last", "The value at the end."},
    {"sum", "The sum of all values."},
    {"max", "The greatest value."},
    {"min", "The least value."},
    {"mean", "The mean of all values."},
});
constexpr auto kScopes = std::to_array<ExplainedWord>({
    {"action", "Reset in each action."},
    {"episode", "Reset in each episode."},
    {"run", "Kept for the whole run."},
});
constexpr auto kOutcomes = std::to_array<ExplainedWord>({
    {"success", "The robot has done what it should."},
    {"failure", "The robot has failed."},
});
constexpr auto kAfterEnd = std::to_array<ExplainedWord>({
    {"stop", "After an end, no callback runs and nothing is paid until the next episode."},
    {"continue", "After an end, callbacks run and pay on until the episode is over."},
});
constexpr auto kOthers = std::to_array<ExplainedWord>({
    {"once",
     "Runs the block when the condition first holds: `once per action if CONDITION { ... }`."},
    {"rate", "A term that is paid per second."},
    {"loop", "Read a table so that its first row follows the last one: `TABLE(x, loop)`."},
    {"duration", "How long a table is, from its first argument to its last: `duration(TABLE)`."},
    {"potential", "A value of which each action is paid the growth, discounted."},
    {"bool", "A condition."},
    {"int", "An integer."},
    {"real", "A number, which may have a unit."},
    {"vec2", "Two numbers: `.x`, `.y`."},
    {"vec3", "Three numbers: `.x`, `.y`, `.z`."},
    {"vec4", "Four numbers: `.x`, `.y`, `.z`, `.w`."},
    {"mat2", "2 x 2 numbers, indexed by row and column."},
    {"mat3", "3 x 3 numbers, indexed by row and column."},
    {"mat4", "4 x 4 numbers, indexed by row and column."},
    {"quat", "A rotation as a quaternion: `.w`, `.x`, `.y`, `.z`."},
    {"unit",
     "In the parameters and the result of a function: the unit of what it is given, each time the "
     "same."},
    {"total", "What a reward term has paid since the test began: `total(TERM)`."},
    {"value",
     "A metric or a log, as it would be recorded if the episode ended now: `value(NAME)`."},
    {"observed", "What the learner sees now: `observed(OBSERVATION)`."},
    {"onboard", "Warns of observations that a real robot cannot sense by itself."},
    {"discount", "The learner's discount for one action, which a test gives."},
    {"ended", "Whether the episode has ended since the test began."},
    {"phase_time", "How long the present phase has lasted, `real [s]`."},
});

}  // namespace

std::span<const ExplainedWord> DeclarationWords() { return kDeclarations; }
std::span<const ExplainedWord> StatementWords() { return kStatements; }
std::span<const ExplainedWord> TestWords() { return kTests; }
std::span<const ExplainedWord> BodyWords() { return kBody; }
std::span<const ExplainedWord> ValueWords() { return kValues; }
std::span<const ExplainedWord> OperatorWords() { return kOperators; }
std::span<const ExplainedWord> EventWords() { return kEvents; }
std::span<const ExplainedWord> ReductionWords() { return kReductions; }
std::span<const ExplainedWord> ScopeWords() { return kScopes; }
std::span<const ExplainedWord> OutcomeWords() { return kOutcomes; }
std::span<const ExplainedWord> AfterEndWords() { return kAfterEnd; }

std::string_view ExplanationOf(std::string_view word) {
  const std::span<const ExplainedWord> lists[] = {
      kDeclarations, kStatements, kTests,  kBody,     kValues,   kOperators,
      kEvents,       kReductions, kScopes, kOutcomes, kAfterEnd, kOthers};
  for (const auto& list : lists) {
    for (const ExplainedWord& explained : list) {
      if (explained.word == word) return explained.explanation;
    }
  }
  return "";
}

}  // namespace compiler
