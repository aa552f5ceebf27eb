#include "compiler/driver/verb.h"

namespace compiler {

const std::vector<Verb> kVerbs = {
    {"new", "Start a new task",
     "taskc new walking --for humanoid   # walking.task, with the robot's sensors and links "
     "listed\n"
     "taskc new balancing                # a task that declares its own sensors",
     DeclareNew},
    {"build", "Build a task into a plugin",
     "taskc build crawling.task                  # into the cache; prints where the plugin is\n"
     "taskc build crawling.task -o crawling.so   # into a file",
     DeclareBuild},
    {"check", "Check tasks without building them",
     "taskc check crawling.task         # reports all errors at once\n"
     "taskc check *.task --json         # for programs, with fixes that they can apply\n"
     "taskc check --fix crawling.task   # applies them",
     DeclareCheck},
    {"test", "Run the tests of tasks",
     "taskc test crawling.task\n"
     "taskc test crawling.task --filter fall   # only tests with `fall` in their names",
     DeclareTest},
    {"watch", "Rebuild tasks whenever their files are saved",
     "taskc watch crawling.task   # until Ctrl-C", DeclareWatch},
    {"emit", "Show the C++ that a task compiles to",
     "taskc emit crawling.task\n"
     "taskc emit crawling.task -o crawling.cpp",
     DeclareEmit},
    {"fmt", "Format tasks: indentation, spaces, line breaks",
     "taskc fmt *.task           # rewrites the files\n"
     "taskc fmt --check *.task   # lists the files that would change\n"
     "taskc fmt - <crawling.task # prints the result",
     DeclareFmt},
    {"doc", "Document a task: equations, sensors, params, bounds",
     "taskc doc crawling.task                     # as Markdown\n"
     "taskc doc crawling.task -o crawling.html    # one file, with typeset equations\n"
     "taskc doc crawling.task --json              # params, terms, metrics; weights of rewards",
     DeclareDoc},
    {"diff", "Say what differs in meaning between two tasks",
     "taskc diff crawling.task mine.task          # not in layout, comments, local names\n"
     "taskc diff crawling.task mine.task --json   # status as of diff: 0 same, 1 different",
     DeclareDiff},
    {"spec", "Print all that one needs to know to write a task, for people and language models",
     "taskc spec --robot humanoid          # sensors, names, functions, units, grammar, examples\n"
     "taskc spec --robot humanoid --json   # for programs",
     DeclareSpec},
    {"fault", "Find where a reward that is not finite comes from",
     "taskc fault crawling.task fault.json   # what the task read then, as the trainer writes it",
     DeclareFault},
    {"seal", "Seal plugins that taskc did not build, so that the trainer loads them",
     "taskc seal mine.so   # written by hand against the ABI; loading it runs its code",
     DeclareSeal},
    {"lsp", "Serve an editor through the Language Server Protocol",
     "taskc lsp   # started by an editor; see docs/editors.md", DeclareLsp},
    {"explain", "Explain an error or a warning",
     "taskc explain E0203   # what it means, with examples\n"
     "taskc explain         # lists all codes with their titles",
     DeclareExplain},
    {"completion", "Print a script that completes taskc's command line in a shell", "",
     DeclareCompletion},
};

ExitStatus ForEachTask(const std::vector<std::string>& files, Session& session,
                       const std::function<ExitStatus(const std::string& file)>& action) {
  ExitStatus status = ExitStatus::kOk;
  for (const std::string& file : files) {
    try {
      status = Worse(status, action(file));
    } catch (const CallError& error) {
      session.Fail(error.what());
      status = Worse(status, ExitStatus::kWrongCall);
    }
  }
  return status;
}

void AddTask(Command& command, std::string& task) {
  command.AddOption("FILE.task", task, "the task").Required().ValueName("");
}

void AddTasks(Command& command, std::vector<std::string>& tasks) {
  command.AddOption("FILE.task", tasks, "the tasks").Required().ValueName("...");
}

Option AddOutput(Command& command, std::filesystem::path& output, const std::string& what,
                 const std::string& description) {
  return command.AddOption("-o,--output", output, description).ValueName(what);
}

void AddRobots(Command& command, Session& session) {
  command.AddOption("--robots", session.robots, "look for robots in this folder first")
      .ValueName("DIR");
}

void AddText(Command& command, Session& session) {
  command
      .AddOption("--text", session.text_file,
                 "read the task's text from this file, as if it stood in FILE.task")
      .ValueName("FILE");
}

void AddReport(Command& command, Session& session) {
  Option json = command.OnFlag(
      "--json", [&] { session.format = "json"; }, "report as JSON, for other programs");
  command
      .OnFlag(
          "--sarif", [&] { session.format = "sarif"; }, "report as SARIF 2.1.0")
      .Excludes(json);
  // What scripts may still say.
  command.AddOption("--format", session.format, "").OneOf({"text", "json", "sarif"}).Hidden();
  command.AddOption("--color", session.color, "colors; auto: on a terminal, unless NO_COLOR is set")
      .OneOf({"auto", "always", "never"});
}

}  // namespace compiler
