#include "runtime/module/network.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "runtime/module/suggestion.h"

namespace runtime {
namespace {

struct PortName {
  std::string_view module;
  std::string_view port;  // may contain dots itself: "base.velocity"
};

PortName Split(std::string_view full_name) {
  const size_t dot = full_name.find('.');
  if (dot == std::string_view::npos || dot == 0 || dot + 1 == full_name.size()) {
    throw UserError(fmt::format("`{}` is no port: write MODULE.PORT", full_name));
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

}  // namespace

void ModuleTypes::Add(std::string type, ModuleFactory factory) {
  factories_.insert_or_assign(std::move(type), std::move(factory));
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

Network::~Network() {
  while (!modules_.empty()) modules_.pop_back();
}

Module& Network::Add(std::unique_ptr<Module> module) {
  const std::string& name = module->name();
  if (name.empty() || name.find('.') != std::string::npos) {
    throw UserError(fmt::format("`{}` cannot name a module: a name has no '.'", name));
  }
  for (const auto& other : modules_) {
    if (other->name() == name) throw UserError(fmt::format("there is a module `{}` already", name));
  }
  return *modules_.emplace_back(std::move(module));
}

Module& Network::Find(std::string_view module) const {
  std::vector<std::string> names;
  for (const auto& candidate : modules_) {
    if (candidate->name() == module) return *candidate;
    names.push_back(candidate->name());
  }
  throw UserError(fmt::format("there is no module `{}`{}", module, Suggestion(module, names)));
}

void Network::ThrowOtherClass(std::string_view module) const {
  throw UserError(
      fmt::format("the module `{}` is of a type that cannot play its part here", module));
}

Port& Network::FindPort(std::string_view port) const {
  const PortName name = Split(port);
  return Find(name.module).FindPort(name.port);
}

void Network::Connect(std::string_view first, std::string_view second) {
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

void Network::ConnectAll(const Module& from, const Module& to) {
  for (Port* in : to.ports()) {
    if (in->kind() != PortKind::kIn || !in->Connections().empty()) continue;
    for (Port* out : from.ports()) {
      if (out->kind() == PortKind::kOut && out->name() == in->name()) Port::Connect(*out, *in);
    }
  }
}

void Network::Disconnect(std::string_view first, std::string_view second) {
  Port::Disconnect(FindPort(first), FindPort(second));
}

void Network::Start() {
  for (const auto& module : modules_) module->Start();
}

std::string Network::ToText() const {
  std::string text;
  for (const auto& module : modules_) {
    text += module->name() + "\n";
    for (const Parameter& parameter : module->parameters()) {
      text +=
          fmt::format("  {} = {}\n", parameter.name, runtime::ToText(module->Get(parameter.name)));
    }
    for (const Port* port : module->ports()) {
      if (port->kind() != PortKind::kSignal && port->kind() != PortKind::kOut) continue;
      for (const Port* peer : port->Connections()) {
        text += fmt::format("  {} -> {}  {}\n", port->name(), peer->full_name(), port->type().text);
      }
    }
  }
  return text;
}

}  // namespace runtime
