// A module made of modules: to the outside it has the ports and parameters that it exports.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "runtime/core/module/module_graph.h"

namespace runtime {

// An exported port is the inner port itself, under another name: a call through it costs what a
// call of any port costs.
class Composite : public Module {
 public:
  // Takes over the modules and their connections.
  Composite(std::string name, ModuleGraph inner);

  // `inner`: "learner.reward", "learner.temperature". Throw UserError where there is no such port
  // or parameter, or where `name` is taken.
  void ExportPort(const std::string& name, std::string_view inner);
  void ExportParameter(const std::string& name, std::string_view inner);

  // The modules that it is made of. Their exported ports are not among their ports any more.
  const ModuleGraph& inner() const { return inner_; }

  void Set(std::string_view parameter, const ParameterValue& value) override;
  void Start() override { inner_.Start(); }
  void Save(std::ostream& stream) const override { inner_.Save(stream); }
  void Load(std::istream& stream) override { inner_.Load(stream); }

 private:
  struct InnerParameter {
    Module* module;
    std::string name;
  };

  ModuleGraph inner_;
  std::map<std::string, InnerParameter, std::less<>> exported_;
};

}  // namespace runtime
