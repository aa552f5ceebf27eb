#include "runtime/core/module/module_graph.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <sstream>

#include "runtime/base/suggestion.h"
#include "runtime/core/module/connections.h"

namespace runtime {
namespace {

struct PortName {
  std::string_view module;
  std::string_view port;  // may contain dots itself: "base.velocity"
};

PortName Split(std::string_view full_name) {
  const size_t dot = full_name.find('.');
  if (dot == std::string_view::npos || dot == 0 || dot + 1 == full_name.size()) {
    throw UserError(fmt::format("`{}` is not a port: write MODULE.PORT", full_name));
  }
  return {full_name.substr(0, dot), full_name.substr(dot + 1)};
}

// The ports of the second one's module that the first one can be connected to; else the other way
// round; nothing to say if the two fit and are merely connected.
std::string Remedy(const Port& first, const Port& second) {
  if (first.Fits(second)) return "";
  for (const auto& [port, other] : {std::pair{&first, &second}, std::pair{&second, &first}}) {
    std::vector<std::string> fitting;
    for (const Port* candidate : other->owner().ports()) {
      if (port->Fits(*candidate)) fitting.push_back(candidate->full_name());
    }
    if (!fitting.empty()) {
      return fmt::format("; `{}` fits `{}`", port->full_name(), fmt::join(fitting, "`, `"));
    }
  }
  return fmt::format("; no port of `{}` fits `{}`", second.owner().name(), first.full_name());
}

void WriteLength(std::ostream& stream, uint64_t length) {
  stream.write(reinterpret_cast<const char*>(&length), sizeof length);
}

void WriteText(std::ostream& stream, const std::string& text) {
  WriteLength(stream, text.size());
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
}

[[noreturn]] void ThrowCutOff() { throw UserError("the checkpoint is damaged: it ends too early"); }

uint64_t ReadLength(std::istream& stream) {
  uint64_t length = 0;
  if (!stream.read(reinterpret_cast<char*>(&length), sizeof length)) ThrowCutOff();
  return length;
}

std::string ReadText(std::istream& stream) {
  uint64_t left = ReadLength(stream);
  std::string text;
  // Piece by piece: a damaged length must not ask for more memory than there is.
  for (char piece[4096]; left > 0; left -= static_cast<uint64_t>(stream.gcount())) {
    if (!stream.read(piece, static_cast<std::streamsize>(std::min<uint64_t>(left, sizeof piece)))) {
      ThrowCutOff();
    }
    text.append(piece, static_cast<size_t>(stream.gcount()));
  }
  return text;
}

}  // namespace

void ModuleTypes::Add(std::string type, ModuleFactory factory) {
  ModuleFactory named = [type, made = std::move(factory)](std::string name,
                                                          const Context& context) {
    std::unique_ptr<Module> module = made(std::move(name), context);
    module->type_ = type;
    return module;
  };
  factories_.insert_or_assign(std::move(type), std::move(named));
}

const ModuleFactory& ModuleTypes::Find(std::string_view type) const {
  const auto factory = factories_.find(type);
  if (factory == factories_.end()) {
    throw UserError(fmt::format("there is no module type `{}`{}", type, Suggestion(type, names())));
  }
  return factory->second;
}

std::unique_ptr<Module> ModuleTypes::Make(std::string_view type, std::string name,
                                          const Context& context) const {
  return Find(type)(std::move(name), context);
}

std::vector<std::string> ModuleTypes::names() const {
  std::vector<std::string> names;
  for (const auto& [name, factory] : factories_) names.push_back(name);
  return names;
}

ModuleGraph::~ModuleGraph() {
  while (!modules_.empty()) modules_.pop_back();
}

void ModuleGraph::CheckNewName(std::string_view name) const {
  if (name.empty()) throw UserError("a module needs a name");
  if (name.find('.') != std::string_view::npos) {
    throw UserError(fmt::format("`{}` cannot name a module: a name has no '.'", name));
  }
  for (const auto& other : modules_) {
    if (other->name() == name) throw UserError(fmt::format("there is a module `{}` already", name));
  }
}

Module& ModuleGraph::Add(std::unique_ptr<Module> module) {
  CheckNewName(module->name());
  return *modules_.emplace_back(std::move(module));
}

void ModuleGraph::Remove(std::string_view module) {
  const Module* found = &Find(module);
  std::erase_if(modules_, [&](const auto& candidate) { return candidate.get() == found; });
}

Module& ModuleGraph::Find(std::string_view module) const {
  std::vector<std::string> names;
  for (const auto& candidate : modules_) {
    if (candidate->name() == module) return *candidate;
    names.push_back(candidate->name());
  }
  throw UserError(fmt::format("there is no module `{}`{}", module, Suggestion(module, names)));
}

void ModuleGraph::ThrowOtherClass(std::string_view module) const {
  throw UserError(fmt::format("the module `{}` is of a type that cannot be used here", module));
}

void ModuleGraph::CheckIsOnly(std::string_view role, const std::vector<const Module*>& modules) {
  if (modules.empty()) {
    throw UserError(fmt::format(
        "the agent has no {}: one of its modules, outside of composites, must be one", role));
  }
  if (modules.size() == 1) return;
  throw UserError(fmt::format("the agent has two {}s, `{}` and `{}`: keep one", role,
                              modules[0]->name(), modules[1]->name()));
}

Port& ModuleGraph::FindPort(std::string_view port) const {
  const PortName name = Split(port);
  return Find(name.module).FindPort(name.port);
}

void ModuleGraph::Connect(std::string_view first, std::string_view second) {
  const PortName from = Split(first);
  const PortName to = Split(second);
  if (from.port == "*" && to.port == "*") return ConnectAll(Find(from.module), Find(to.module));
  if (from.port == "*" || to.port == "*") {
    throw UserError(fmt::format(
        "cannot connect `{}` to `{}`: `*` stands for all ports on both sides or on none", first,
        second));
  }
  Port& first_port = FindPort(first);
  Port& second_port = FindPort(second);
  try {
    Port::Connect(first_port, second_port);
  } catch (const UserError& error) {
    throw UserError(error.what() + Remedy(first_port, second_port));
  }
}

void ModuleGraph::ConnectAll(const Module& from, const Module& to) {
  for (Port* in : to.ports()) {
    if (in->kind() != PortKind::kIn || !in->Connections().empty()) continue;
    for (Port* out : from.ports()) {
      if (out->kind() == PortKind::kOut && out->name() == in->name()) Port::Connect(*out, *in);
    }
  }
}

void ModuleGraph::Disconnect(std::string_view first, std::string_view second) {
  Port::Disconnect(FindPort(first), FindPort(second));
}

void ModuleGraph::Start() {
  for (const auto& module : modules_) ConnectSensors(*module, *this);
  for (const auto& module : modules_) module->Start();
}

// For each module, in the order of their creation: its name and what it wrote, each after its
// length. The number of modules stands in front.
void ModuleGraph::Save(std::ostream& stream) const {
  WriteLength(stream, modules_.size());
  for (const auto& module : modules_) {
    std::ostringstream state;
    module->Save(state);
    WriteText(stream, module->name());
    WriteText(stream, state.str());
  }
}

void ModuleGraph::Load(std::istream& stream, const std::set<std::string>& left_out) {
  std::map<std::string, std::string> states;
  for (uint64_t unread = ReadLength(stream); unread > 0; --unread) {
    std::string name = ReadText(stream);
    states[std::move(name)] = ReadText(stream);
  }
  for (const auto& module : modules_) {
    const auto found = states.find(module->name());
    if (found == states.end() && left_out.contains(module->name())) continue;
    if (found == states.end()) {
      throw UserError(
          fmt::format("the checkpoint has no state for the module `{}`", module->name()));
    }
    std::istringstream state(std::move(found->second));
    states.erase(found);
    module->Load(state);
    if (state.fail()) {
      throw UserError(fmt::format("the checkpoint of the module `{}` is damaged", module->name()));
    }
  }
  for (const auto& [name, state] : states) {
    if (!left_out.contains(name)) {
      throw UserError("the checkpoint is of an agent with more modules");
    }
  }
}

}  // namespace runtime
