// The modules of one agent and the connections between their ports.
#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/core/module/module.h"

namespace runtime {

// What a module may need at its creation besides its parameters.
struct Context;

using ModuleFactory = std::function<std::unique_ptr<Module>(std::string name, const Context&)>;

// Creates modules by the name of their type.
class ModuleTypes {
 public:
  // For modules with the constructor M(std::string name, const Context&).
  template <class M>
  void Add(std::string type) {
    Add(std::move(type), [](std::string name, const Context& context) {
      return std::make_unique<M>(std::move(name), context);
    });
  }
  void Add(std::string type, ModuleFactory factory);
  // Throws UserError for an unknown type, with the nearest one.
  const ModuleFactory& Find(std::string_view type) const;
  std::unique_ptr<Module> Make(std::string_view type, std::string name, const Context&) const;
  std::vector<std::string> names() const;

 private:
  std::map<std::string, ModuleFactory, std::less<>> factories_;
};

class ModuleGraph {
 public:
  ModuleGraph() = default;
  ModuleGraph(ModuleGraph&&) = default;
  ~ModuleGraph();  // destroys the modules in the reverse order of their creation

  // Throws UserError if the name is taken, empty, or contains a '.'.
  void CheckNewName(std::string_view name) const;
  // Throws as CheckNewName().
  Module& Add(std::unique_ptr<Module> module);
  // Disconnects and destroys a module. Not from inside one of its own slots. Throws UserError for
  // an unknown module.
  void Remove(std::string_view module);
  // Throws UserError for an unknown module, with the nearest name.
  Module& Find(std::string_view module) const;
  // The module of this name as an M. Throws UserError if it is of another class.
  template <class M>
  M& FindAs(std::string_view module) const;
  // All modules that are an M, in the order of their creation; not those inside composites.
  template <class M>
  std::vector<M*> FindAll() const;
  // The only one that is. Throws UserError, which calls it `M::kRole`, where there is none or more
  // than one.
  template <class M>
  M& FindOnly() const;
  // "task.reward". Throws UserError for an unknown module or port, with the nearest name.
  Port& FindPort(std::string_view port) const;

  // Connects a signal to a slot, or an out port to an in port; the order of the two does not
  // matter. Throws UserError if kinds or types do not fit (and lists the ports that would), if they
  // are connected already, or if the in port has another out port.
  //
  // "environment.*", "task.*" connects each in port of the second module that has no connection yet
  // to the out port of the same name of the first module, if it has one.
  void Connect(std::string_view first, std::string_view second);
  void Disconnect(std::string_view first, std::string_view second);

  // Starts every module in the order of their creation.
  void Start();

  const std::vector<std::unique_ptr<Module>>& modules() const { return modules_; }

  // The state of all modules, so that a graph of the same modules continues where this one is.
  void Save(std::ostream& stream) const;
  // Throws UserError where the state is damaged or of other modules. Those in `left_out` may be
  // missing in the graph (their state is passed over) or in the state (they stay as they are).
  void Load(std::istream& stream, const std::set<std::string>& left_out = {});

 private:
  void ConnectAll(const Module& from, const Module& to);
  [[noreturn]] void ThrowOtherClass(std::string_view module) const;
  // Unless there is exactly one.
  static void CheckIsOnly(std::string_view role, const std::vector<const Module*>& modules);

  std::vector<std::unique_ptr<Module>> modules_;
};

template <class M>
M& ModuleGraph::FindAs(std::string_view module) const {
  if (M* found = dynamic_cast<M*>(&Find(module))) return *found;
  ThrowOtherClass(module);
}

template <class M>
std::vector<M*> ModuleGraph::FindAll() const {
  std::vector<M*> found;
  for (const auto& module : modules_) {
    if (M* candidate = dynamic_cast<M*>(module.get())) found.push_back(candidate);
  }
  return found;
}

template <class M>
M& ModuleGraph::FindOnly() const {
  const std::vector<M*> found = FindAll<M>();
  CheckIsOnly(M::kRole, {found.begin(), found.end()});
  return *found.front();
}

}  // namespace runtime
