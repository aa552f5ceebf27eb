// Modules of your own: a shared object that adds types of modules to those of the trainer.
//
//   #include "runtime/core/module/module_library.h"
//
//   class Heartbeat : public runtime::Module { ... };
//
//   TASKC_MODULES(types) { types.Add<Heartbeat>("Heartbeat"); }
//
// An agent file names it, `libraries = ["heartbeat.so"]`, and has modules of these types like any
// others. It is made by the compiler that made the trainer, against the headers of the same version
// (examples/module/README.md); what does not fit is refused when it is loaded.
#pragma once

#include "runtime/core/module/module_graph.h"

namespace runtime {

// Another number whenever a library that was made before could no longer work.
inline constexpr int kModuleInterface = 1;

// What a library says of itself, as the symbol `taskc_modules`.
struct ModuleLibrary {
  int interface;
  const char* compiler;
  void (*add)(ModuleTypes& types);
};

}  // namespace runtime

// Once in a library; what follows is the body of a function that adds its types.
#define TASKC_MODULES(types)                                                      \
  static void TaskcAddModules(runtime::ModuleTypes& types);                       \
  extern "C" {                                                                    \
  runtime::ModuleLibrary taskc_modules = {runtime::kModuleInterface, __VERSION__, \
                                          TaskcAddModules};                       \
  }                                                                               \
  static void TaskcAddModules(runtime::ModuleTypes& types)
