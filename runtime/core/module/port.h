// Typed ports, through which modules talk to each other.
//
//   signal -> slot   an event with arguments: a signal calls any number of slots, in the order of
//                    their connection, synchronously and depth first
//   out    -> in     a value: an in port reads the one out port it is connected to, by reference
//
// Ports are connected by name (runtime/core/module/module_graph.h) and their types are compared
// then. A call through a connected port is a call through a pointer: nothing is allocated, copied
// or locked.
//
// Rewiring is allowed at any time, also from a slot while its signal is being emitted: a new slot
// is called from the next emission on, a removed one is not called any more.
//
// Ownership: a port belongs to its module and registers itself there; it neither moves nor copies.
// A port that is destroyed is disconnected first.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

namespace runtime {

class Module;

enum class PortKind { kSignal, kSlot, kOut, kIn };

// "signal", "slot", "out port" or "in port".
const char* ToText(PortKind kind);

// What must be equal for two ports to be connected: the C++ type and, for values whose shape is
// only known at run time, its description ("vec3 [m/s]").
struct PortType {
  std::type_index cpp;
  std::string text;
  bool operator==(const PortType&) const = default;
};

class Port {
 public:
  Port(Module* owner, std::string name, PortKind kind, PortType type);
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;
  virtual ~Port();

  Module& owner() const { return *owner_; }
  const std::string& name() const { return name_; }
  PortKind kind() const { return kind_; }
  const PortType& type() const { return type_; }
  // "task.reward"
  std::string full_name() const;

  // The ports that this one is connected to, in the order of their connection.
  std::vector<Port*> Connections() const;
  bool IsConnectedTo(const Port& other) const;

  // An in port that its module reads whether there is a value or not, so that it must stay
  // connected while the graph runs. All in ports are, but those that say otherwise.
  bool must_be_connected() const { return must_be_connected_; }

  // Whether kinds and types of the two fit each other, connected or not.
  bool Fits(const Port& other) const;

  // Makes the port one of `owner`, under another name; it does what it did before. `owner` outlives
  // the module that the port was made by. Throws UserError where `owner` has a port of that name.
  void HandOver(Module& owner, std::string name);

  // Connects a signal to a slot, or an out port to an in port; the order of the two does not
  // matter. Throws UserError if they do not fit, if they are connected already, or if the in port
  // has another out port; nothing has changed then.
  static void Connect(Port& first, Port& second);
  // The same for a signal and a slot; the slot is called right after `before`, which is connected
  // to the signal. Not while the signal is being emitted.
  static void ConnectBehind(Port& signal, Port& slot, const Port& before);
  // Throws UserError if the two are not connected.
  static void Disconnect(Port& first, Port& second);

 protected:
  virtual void Attach(Port& peer);
  virtual void Detach(Port& peer);
  void AllowUnconnected() { must_be_connected_ = false; }

  // Null in a signal that is being emitted: a slot that was removed meanwhile.
  std::vector<Port*> peers_;

 private:
  std::optional<std::string> ObjectionTo(const Port& other) const;

  Module* owner_;
  std::string name_;
  PortKind kind_;
  PortType type_;
  bool must_be_connected_;
};

// Names a member function at compile time: Slot<double> reward{this, "reward",
// Bind<&Learner::Pay>{}}.
template <auto Method>
struct Bind {};

// The type of a signal or slot with these arguments, of an out or in port with this value, as shown
// to the user. Specialize TypeText for types that a port carries.
template <class T>
struct TypeText;  // static constexpr const char* value

template <>
struct TypeText<bool> {
  static constexpr const char* value = "bool";
};
template <>
struct TypeText<int> {
  static constexpr const char* value = "int";
};
template <>
struct TypeText<double> {
  static constexpr const char* value = "real";
};

template <class... Args>
PortType MakeEventType() {
  std::string text;
  ((text += (text.empty() ? "" : ", "), text += TypeText<std::decay_t<Args>>::value), ...);
  return {std::type_index(typeid(void (*)(Args...))), "(" + text + ")"};
}

// `text` "": the text of the C++ type.
template <class T>
PortType MakeValueType(std::string text) {
  return {std::type_index(typeid(T)), text.empty() ? TypeText<T>::value : std::move(text)};
}

template <class... Args>
class Slot : public Port {
 public:
  template <class Owner, auto Method>
  Slot(Owner* owner, std::string name, Bind<Method>)
      : Port(owner, std::move(name), PortKind::kSlot, MakeEventType<Args...>()),
        object_(owner),
        function_(
            [](void* object, Args... args) { (static_cast<Owner*>(object)->*Method)(args...); }) {}

  void operator()(Args... args) const { function_(object_, args...); }

 private:
  void* object_;
  void (*function_)(void*, Args...);
};

// What is common to all signals: the list of slots stays valid while it is being walked.
class SignalPort : public Port {
 public:
  ~SignalPort() override;

 protected:
  SignalPort(Module* owner, std::string name, PortType type);

  // One walk along the slots, on the stack of whoever emits. Emissions of one signal nest.
  class Emission {
   public:
    explicit Emission(SignalPort& signal);
    ~Emission() {
      if (signal_ == nullptr) return;
      signal_->running_ = outer_;
      if (outer_ == nullptr && signal_->has_gaps_) signal_->CloseGaps();
    }
    Emission(const Emission&) = delete;
    Emission& operator=(const Emission&) = delete;

    // The next slot, or null at the end, also if the signal was destroyed meanwhile.
    Port* Next() {
      while (signal_ != nullptr && next_ < end_) {
        if (Port* slot = signal_->peers_[next_++]) return slot;
      }
      return nullptr;
    }

   private:
    friend class SignalPort;
    SignalPort* signal_;
    Emission* outer_;
    size_t next_ = 0;
    size_t end_;  // slots beyond it were connected during the emission
  };

  void Detach(Port& peer) override;

 private:
  void CloseGaps();

  Emission* running_ = nullptr;  // the innermost one
  bool has_gaps_ = false;        // a slot was removed during the emission
};

template <class... Args>
class Signal : public SignalPort {
 public:
  Signal(Module* owner, std::string name)
      : SignalPort(owner, std::move(name), MakeEventType<Args...>()) {}

  void operator()(Args... args) {
    if (peers_.empty()) return;
    Emission emission(*this);
    while (Port* slot = emission.Next()) (*static_cast<const Slot<Args...>*>(slot))(args...);
  }

  // As Port::Connect and Port::Disconnect, with types known to the C++ compiler.
  void Connect(Slot<Args...>& slot) { Port::Connect(*this, slot); }
  void Disconnect(Slot<Args...>& slot) { Port::Disconnect(*this, slot); }
};

// `type_text` describes a value whose shape is only known at run time.
template <class T>
class Out : public Port {
 public:
  // A value that is always up to date.
  Out(Module* owner, std::string name, const T* value, std::string type_text = "")
      : Port(owner, std::move(name), PortKind::kOut, MakeValueType<T>(std::move(type_text))),
        object_(const_cast<T*>(value)),
        function_([](void* object) -> const T& { return *static_cast<const T*>(object); }) {}

  // A value that `Method` brings up to date when it is read. `const T& Method()`.
  template <class Owner, auto Method>
  Out(Owner* owner, std::string name, Bind<Method> method, std::string type_text = "")
      : Out(owner, std::move(name), owner, method, std::move(type_text)) {}

  // The same with a method of `object`, which lives as long as the port.
  template <class Object, auto Method>
  Out(Module* owner, std::string name, Object* object, Bind<Method>, std::string type_text = "")
      : Port(owner, std::move(name), PortKind::kOut, MakeValueType<T>(std::move(type_text))),
        object_(object),
        function_(
            [](void* target) -> const T& { return (static_cast<Object*>(target)->*Method)(); }) {}

  bool connected() const { return !peers_.empty(); }
  const T& operator()() const { return function_(object_); }

 private:
  void* object_;
  const T& (*function_)(void*);
};

template <class T>
class In : public Port {
 public:
  enum class Need { kRequired, kOptional };

  In(Module* owner, std::string name, std::string type_text = "", Need need = Need::kRequired)
      : Port(owner, std::move(name), PortKind::kIn, MakeValueType<T>(std::move(type_text))) {
    if (need == Need::kOptional) AllowUnconnected();
  }

  bool connected() const { return out_ != nullptr; }
  // Precondition: connected.
  const T& operator()() const { return (*out_)(); }

  // As Port::Connect, with types known to the C++ compiler.
  void Connect(Out<T>& out) { Port::Connect(out, *this); }
  void Disconnect() {
    if (connected()) Port::Disconnect(*this, *peers_.front());
  }

 protected:
  void Attach(Port& peer) override {
    Port::Attach(peer);
    out_ = static_cast<const Out<T>*>(&peer);
  }
  void Detach(Port& peer) override {
    Port::Detach(peer);
    out_ = nullptr;
  }

 private:
  const Out<T>* out_ = nullptr;  // peers_.front(), one step nearer
};

}  // namespace runtime
