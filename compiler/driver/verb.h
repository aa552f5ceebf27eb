// The verbs of `taskc`: build, check and so on. A verb is one small file, NAME_verb.cpp, that
// declares its options and says what is done with them; and one line in kVerbs.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/command_line/command.h"
#include "compiler/driver/exit_status.h"
#include "compiler/driver/session.h"

namespace compiler {

using command_line::Command;
using command_line::Option;

// What a verb does once its options are parsed. It may throw CallError, robot::DescriptionError and
// InternalError: then this was the end of the call.
using Action = std::function<ExitStatus(Session&)>;

struct Verb {
  const char* name;
  const char* title;     // one line, for the list of verbs
  const char* examples;  // calls, one in a line, each with a comment; or "": it declares them
  // Declares the verb's options. They live as long as the action that is returned.
  Action (*declare)(Command& command, Session& session);
};

// In the order in which the help lists them.
extern const std::vector<Verb> kVerbs;

Action DeclareBuild(Command& command, Session& session);
Action DeclareCheck(Command& command, Session& session);
Action DeclareCompletion(Command& command, Session& session);
Action DeclareDiff(Command& command, Session& session);
Action DeclareDoc(Command& command, Session& session);
Action DeclareTest(Command& command, Session& session);
Action DeclareEmit(Command& command, Session& session);
Action DeclareFmt(Command& command, Session& session);
Action DeclareLsp(Command& command, Session& session);
Action DeclareExplain(Command& command, Session& session);
Action DeclareSpec(Command& command, Session& session);
Action DeclareFault(Command& command, Session& session);
Action DeclareSeal(Command& command, Session& session);
Action DeclareNew(Command& command, Session& session);
Action DeclareWatch(Command& command, Session& session);

// Calls `action` for each file and returns the worst status. A file that cannot be read or written
// (CallError) does not keep the others from their turn.
ExitStatus ForEachTask(const std::vector<std::string>& files, Session& session,
                       const std::function<ExitStatus(const std::string& file)>& action);

// ---- Options that several verbs have ------------------------------------------------------------

void AddTask(Command& command, std::string& task);
void AddTasks(Command& command, std::vector<std::string>& tasks);
// Where to write, and what that is: "FILE.cpp".
Option AddOutput(Command& command, std::filesystem::path& output, const std::string& what,
                 const std::string& description);
void AddRobots(Command& command, Session& session);
// For editors, and others that have a text which is not saved.
void AddText(Command& command, Session& session);
// In which form, and in which colors, what is wrong is reported.
void AddReport(Command& command, Session& session);

}  // namespace compiler
