// The verbs of `taskc`: build, check and so on. A verb is one small file, NAME_verb.cpp, that
// declares its options and says what is done with them; and one line in kVerbs.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "compiler/driver/exit_status.h"
#include "compiler/driver/session.h"

namespace compiler {

// What a verb does once its options are parsed. It may throw CallError, robot::DescriptionError and
// InternalError: then this was the end of the call.
using Action = std::function<ExitStatus(Session&)>;

struct Verb {
  const char* name;
  const char* title;     // one line, for the list of verbs
  const char* examples;  // calls, one in a line, each with a comment
  // Declares the verb's options. They live as long as the action that is returned.
  Action (*declare)(CLI::App& app, Session& session);
};

// In the order in which the help lists them.
extern const std::vector<Verb> kVerbs;

Action DeclareBuild(CLI::App& app, Session& session);
Action DeclareCheck(CLI::App& app, Session& session);
Action DeclareCompletion(CLI::App& app, Session& session);
Action DeclareDoc(CLI::App& app, Session& session);
Action DeclareTest(CLI::App& app, Session& session);
Action DeclareEmit(CLI::App& app, Session& session);
Action DeclareFmt(CLI::App& app, Session& session);
Action DeclareLsp(CLI::App& app, Session& session);
Action DeclareExplain(CLI::App& app, Session& session);
Action DeclareSeal(CLI::App& app, Session& session);
Action DeclareNew(CLI::App& app, Session& session);
Action DeclareWatch(CLI::App& app, Session& session);

// Calls `action` for each file and returns the worst status. A file that cannot be read or written
// (CallError) does not keep the others from their turn.
ExitStatus ForEachTask(const std::vector<std::string>& files, Session& session,
                       const std::function<ExitStatus(const std::string& file)>& action);

// ---- Options that several verbs have ------------------------------------------------------------

void AddTask(CLI::App& app, std::string& task);
void AddTasks(CLI::App& app, std::vector<std::string>& tasks);
// Where to write, and what that is: "FILE.cpp".
void AddOutput(CLI::App& app, std::filesystem::path& output, const std::string& what,
               const std::string& description);
void AddRobots(CLI::App& app, Session& session);
// In which form, and in which colors, what is wrong is reported.
void AddReport(CLI::App& app, Session& session);

}  // namespace compiler
