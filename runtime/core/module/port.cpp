#include "runtime/core/module/port.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "runtime/core/module/module.h"

namespace runtime {

const char* ToText(PortKind kind) {
  switch (kind) {
    case PortKind::kSignal:
      return "signal";
    case PortKind::kSlot:
      return "slot";
    case PortKind::kOut:
      return "out port";
    case PortKind::kIn:
      return "in port";
  }
  assert(false);
  return "";
}

namespace {

PortKind Counterpart(PortKind kind) {
  switch (kind) {
    case PortKind::kSignal:
      return PortKind::kSlot;
    case PortKind::kSlot:
      return PortKind::kSignal;
    case PortKind::kOut:
      return PortKind::kIn;
    case PortKind::kIn:
      return PortKind::kOut;
  }
  assert(false);
  return kind;
}

std::string WithArticle(PortKind kind) {
  const bool vowel = kind == PortKind::kOut || kind == PortKind::kIn;
  return std::string(vowel ? "an " : "a ") + ToText(kind);
}

}  // namespace

Port::Port(Module* owner, std::string name, PortKind kind, PortType type)
    : owner_(owner),
      name_(std::move(name)),
      kind_(kind),
      type_(std::move(type)),
      must_be_connected_(kind == PortKind::kIn) {
  assert(std::none_of(owner_->ports_.begin(), owner_->ports_.end(),
                      [this](const Port* other) { return other->name_ == name_; }));
  owner_->ports_.push_back(this);
}

Port::~Port() {
  for (Port* peer : peers_) {
    if (peer != nullptr) peer->Detach(*this);
  }
  std::erase(owner_->ports_, this);
}

void Port::HandOver(Module& owner, std::string name) {
  for (const Port* other : owner.ports_) {
    if (other->name_ != name) continue;
    throw UserError(fmt::format("the module `{}` has a port `{}` already", owner.name(), name));
  }
  std::erase(owner_->ports_, this);
  owner.ports_.push_back(this);
  owner_ = &owner;
  name_ = std::move(name);
}

std::string Port::full_name() const { return owner_->name() + "." + name_; }

std::vector<Port*> Port::Connections() const {
  std::vector<Port*> connections = peers_;
  std::erase(connections, nullptr);
  return connections;
}

bool Port::IsConnectedTo(const Port& other) const {
  return std::find(peers_.begin(), peers_.end(), &other) != peers_.end();
}

bool Port::Fits(const Port& other) const {
  return other.kind_ == Counterpart(kind_) && other.type_ == type_;
}

std::optional<std::string> Port::ObjectionTo(const Port& other) const {
  if (other.kind_ != Counterpart(kind_)) {
    return fmt::format("`{}` is {} and `{}` is {}: a signal needs a slot, an out port an in port",
                       full_name(), WithArticle(kind_), other.full_name(),
                       WithArticle(other.kind_));
  }
  if (other.type_ != type_) {
    return fmt::format("the types differ: `{}` is `{}`, `{}` is `{}`", full_name(), type_.text,
                       other.full_name(), other.type_.text);
  }
  if (IsConnectedTo(other)) return "they are connected already";
  for (const Port* in : {this, &other}) {
    if (in->kind_ == PortKind::kIn && !in->peers_.empty()) {
      return fmt::format("`{}` is connected to `{}` already: disconnect the two first",
                         in->full_name(), in->peers_.front()->full_name());
    }
  }
  return std::nullopt;
}

void Port::Connect(Port& first, Port& second) {
  if (const auto objection = first.ObjectionTo(second)) {
    throw UserError(fmt::format("cannot connect `{}` to `{}`: {}", first.full_name(),
                                second.full_name(), *objection));
  }
  first.Attach(second);
  second.Attach(first);
}

void Port::ConnectBehind(Port& signal, Port& slot, const Port& before) {
  Connect(signal, slot);
  const auto place = std::ranges::find(signal.peers_, &before);
  assert(place != signal.peers_.end());
  std::rotate(place + 1, signal.peers_.end() - 1, signal.peers_.end());
}

void Port::Disconnect(Port& first, Port& second) {
  if (!first.IsConnectedTo(second)) {
    throw UserError(fmt::format("cannot disconnect `{}` from `{}`: they are not connected",
                                first.full_name(), second.full_name()));
  }
  first.Detach(second);
  second.Detach(first);
}

void Port::Attach(Port& peer) { peers_.push_back(&peer); }

void Port::Detach(Port& peer) { std::erase(peers_, &peer); }

SignalPort::SignalPort(Module* owner, std::string name, PortType type)
    : Port(owner, std::move(name), PortKind::kSignal, std::move(type)) {}

SignalPort::~SignalPort() {
  for (Emission* emission = running_; emission != nullptr; emission = emission->outer_) {
    emission->signal_ = nullptr;
  }
}

void SignalPort::Detach(Port& peer) {
  if (running_ == nullptr) {
    Port::Detach(peer);
  } else {
    std::replace(peers_.begin(), peers_.end(), &peer, static_cast<Port*>(nullptr));
    has_gaps_ = true;
  }
}

// Not in the header: where it is inlined, g++ warns that the address of a local variable is kept.
// It is kept only as long as the variable lives, which g++ cannot see.
SignalPort::Emission::Emission(SignalPort& signal)
    : signal_(&signal),
      outer_(signal.running_),
      end_(outer_ == nullptr ? signal.peers_.size() : outer_->end_) {
  signal.running_ = this;
}

void SignalPort::CloseGaps() {
  std::erase(peers_, nullptr);
  has_gaps_ = false;
}

}  // namespace runtime
