// The functions of a plugin: those of the task, one for each event, `initialize`, `measure`
// and `observe`.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/emit/expression_emitter.h"
#include "compiler/emit/text_writer.h"
#include "compiler/emit/used_values.h"
#include "compiler/source/sources.h"

namespace compiler {

// The names at file scope of a plugin.
struct PluginNames {
  explicit PluginNames(const CheckedTask& task);

  UniqueNames taken;                   // all that follow
  std::vector<std::string> terms;      // enumerators: "term_fall"
  std::vector<std::string> logs;       // enumerators: "log_speed"
  std::vector<std::string> functions;  // "fn_shape"
  std::vector<std::string> draws;      // of each goal, the function that draws it: "draw_velocity"
  std::vector<std::string> consts;     // "const_home"
  std::vector<LookupTable> tables;
  std::vector<std::string> memory;  // members of the struct
};

// Whether the plugin draws in which of several poses an episode starts, and changes the pose.
inline bool DrawsPose(const CheckedTask& task) { return task.start.poses.size() > 1; }
inline bool DrawsStart(const CheckedTask& task) { return !task.start.block.body.empty(); }

// Whether the plugin has something to do at this event. Its function is called like the event.
bool HasFunction(const CheckedTask& task, EventKind event);

class FunctionEmitter {
 public:
  // Refers to its arguments, which must outlive it.
  FunctionEmitter(const CheckedTask& task, const Sources& sources, const PluginNames& names,
                  TextWriter& writer, HelperSet& helpers);

  void EmitFunction(uint32_t index);
  // What draws a goal.
  void EmitDraw(uint32_t goal);
  // What draws the pose in which an episode starts, and what changes that.
  void EmitDrawPose();
  void EmitDrawStart();
  void EmitInitialize();
  void EmitEvent(EventKind kind);
  void EmitMeasure();
  void EmitObserve();

 private:
  // The state of the function that is being emitted.
  struct Function {
    Function() = default;
    Function(const PluginNames& plugin, UsedValues of_function)
        : names(&plugin.taken), used(std::move(of_function)) {
      values.functions = plugin.functions;
      values.consts = plugin.consts;
      values.tables = plugin.tables;
    }

    UniqueNames names;
    ValueNames values;
    UsedValues used;
    const std::vector<Local>* locals = nullptr;
    std::string next_phase{};  // the variable that holds it
  };

  // Opens a function of the plugin that the host calls.
  void Begin(std::string_view name, SourceLine line, UsedValues used);
  // Opens a function with this head; `function_` already knows what it uses.
  void BeginFunction(const std::string& head, SourceLine line);
  // Those of the function; each gets its name where it is defined.
  void SetLocals(const std::vector<Local>& locals);
  void EmitPrologue(SourceLine line);
  void End();

  // The place from which random numbers are drawn.
  void EmitDrawPlace(uint32_t stream, std::string_view count, SourceLine line);
  // What a function gives: returned, or written to an array.
  void EmitResult(const CheckedExpression& value, const std::string& array);
  void EmitBlock(const CheckedBlock& block);
  void Emit(const CheckedLet& let, SourceLine line);
  void Emit(const CheckedAssign& assign, SourceLine line);
  void Emit(const CheckedIf& node, SourceLine line);
  void Emit(const CheckedReward& reward, SourceLine line);
  void Emit(const CheckedEnd& end, SourceLine line);
  void Emit(const CheckedFor& loop, SourceLine line);
  void Emit(const CheckedLog& log, SourceLine line);
  void Emit(const CheckedRequire& require, SourceLine line);
  void Emit(const CheckedRedraw& redraw, SourceLine line);
  void Emit(const CheckedNext& next, SourceLine line);
  void Emit(const CheckedPhaseSwitch& phases, SourceLine line);
  void Emit(const CheckedAdvance& advance, SourceLine line);
  void Emit(const CheckedPotentialStep& step, SourceLine line);
  void EmitReset(const CheckedMemory& memory, uint32_t index);
  // Sets all elements of a variable, or those with these indices.
  void EmitStore(uint32_t memory, std::string_view op, const std::vector<CppText>& values,
                 const std::vector<uint32_t>& indices, SourceLine line);
  // Lines that stand for one line of the task.
  void WriteLines(const std::vector<std::string>& lines, SourceLine line);
  // What a function stands for that the task does not write itself: it only sets memory.
  SourceLine FirstLineOfMemory() const;
  SourceLine LineOf(Span span) const {
    return {sources_.FileOf(span).path(), sources_.LineOf(span)};
  }

  const CheckedTask& task_;
  const Sources& sources_;
  const PluginNames& names_;
  TextWriter& writer_;
  HelperSet& helpers_;
  Function function_;
  std::optional<ExpressionEmitter> expressions_;
};

}  // namespace compiler
