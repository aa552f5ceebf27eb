#include "compiler/driver/verb.h"

namespace compiler {

const std::vector<Verb> kVerbs = {
    {"build", "Build a task into a plugin",
     "taskc build crawling.task                  # into the cache; prints where the plugin is\n"
     "taskc build crawling.task -o crawling.so   # into a file",
     DeclareBuild},
    {"check", "Check tasks, build nothing",
     "taskc check crawling.task   # all its mistakes at once\n"
     "taskc check *.task",
     DeclareCheck},
    {"emit", "Show the C++ that a task becomes",
     "taskc emit crawling.task\n"
     "taskc emit crawling.task -o crawling.cpp",
     DeclareEmit},
    {"fmt", "Lay out tasks: indentation, blanks, line breaks",
     "taskc fmt *.task           # rewrites the files\n"
     "taskc fmt --check *.task   # lists those that would change\n"
     "taskc fmt - <crawling.task # prints the result",
     DeclareFmt},
};

void AddTask(CLI::App& app, std::string& task) {
  app.add_option("FILE.task", task, "the task")->required()->type_name("");
}

void AddTasks(CLI::App& app, std::vector<std::string>& tasks) {
  app.add_option("FILE.task", tasks, "the tasks")->required()->type_name("...");
}

void AddOutput(CLI::App& app, std::filesystem::path& output, const std::string& what,
               const std::string& description) {
  app.add_option("-o,--output", output, description)->type_name(what);
}

void AddRobots(CLI::App& app, Session& session) {
  app.add_option("--robots", session.robots, "look for robots in this folder first")
      ->type_name("DIR");
}

}  // namespace compiler
