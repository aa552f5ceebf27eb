#include "runtime/training/run/change_json.h"

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "base/variant/overloaded.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

using Json = nlohmann::json;

// What each kind says, for the writer and the reader at once. All of it must be there, except flags
// that are false, `Values` that are none, and what is called optional.

void Members(auto& members, variant::OneOf<SwapTask> auto& change) {
  members.Text("name", change.module);
  members.Task("task", change.task);
  members.Flag("forget", change.forget);
}

void Members(auto& members, variant::OneOf<LoadShadow, RollBackTask> auto& change) {
  members.Text("name", change.module);
  members.Task("task", change.task);
}

void Members(auto& members, variant::OneOf<PromoteTask> auto& change) {
  members.Text("name", change.module);
  members.Flag("forget", change.forget);
}

void Members(auto& members, variant::OneOf<UnloadShadow, RemoveModule> auto& change) {
  members.Text("name", change.module);
}

void Members(auto& members, variant::OneOf<SetParameter> auto& change) {
  members.Text("name", change.parameter);
  members.Value("value", change.value);
}

void Members(auto& members, variant::OneOf<ScheduleParameter> auto& change) {
  members.Text("name", change.parameter);
  members.Real("from", change.from);
  members.Real("to", change.to);
  members.Count("episodes", change.episodes);
}

void Members(auto& members, variant::OneOf<HoldGoal> auto& change) {
  members.Text("name", change.goal);
  members.Value("value", change.value);
}

void Members(auto& members, variant::OneOf<ReleaseGoal> auto& change) {
  members.Text("name", change.goal);
}

void Members(auto& members, variant::OneOf<ConnectPorts, DisconnectPorts> auto& change) {
  members.Text("first", change.first);
  members.Text("second", change.second);
}

void Members(auto& members, variant::OneOf<AddModule> auto& change) {
  members.Text("type", change.type);
  members.Text("name", change.module);
  members.Values("parameters", change.parameters);
}

void Members(auto& members, variant::OneOf<PutInQuarantine> auto& change) {
  members.OptionalTask("task", change.task);
  members.OptionalCount("change", change.change);
  members.Text("why", change.why);
}

using NamedValues = std::vector<std::pair<std::string, ParameterValue>>;

class Writer {
 public:
  explicit Writer(std::string_view kind) : json_({{"command", kind}}) {}

  void Text(const char* key, const std::string& text) { json_[key] = text; }
  void Task(const char* key, int64_t task) { json_[key] = task; }
  void Count(const char* key, int64_t count) { json_[key] = count; }
  void Real(const char* key, const WrittenNumber& number) { json_[key] = ToJson(number); }
  void Value(const char* key, const ParameterValue& value) { json_[key] = ToJson(value); }
  void Flag(const char* key, bool flag) {
    if (flag) json_[key] = true;
  }
  void Values(const char* key, const NamedValues& values) {
    for (const auto& [name, value] : values) json_[key][name] = ToJson(value);
  }
  void OptionalTask(const char* key, std::optional<int64_t> task) {
    if (task) Task(key, *task);
  }
  void OptionalCount(const char* key, std::optional<int64_t> count) {
    if (count) Count(key, *count);
  }

  std::string Written() const { return json_.dump(); }

 private:
  Json json_;
};

// Throws UserError where a member is not there or not right.
class Reader {
 public:
  Reader(const Json& json, int64_t task_count) : json_(json), task_count_(task_count) {}

  void Text(const char* key, std::string& text) { Get(key, &Json::is_string).get_to(text); }
  void Task(const char* key, int64_t& task) { Whole(key, task_count_, task); }
  void Count(const char* key, int64_t& count) { Whole(key, kMost, count); }
  void Real(const char* key, WrittenNumber& number) { Convert(key, NumberFromJson, number); }
  void Value(const char* key, ParameterValue& value) { Convert(key, ValueFromJson, value); }
  void Flag(const char* key, bool& flag) {
    if (json_.contains(key)) Get(key, &Json::is_boolean).get_to(flag);
  }
  void Values(const char* key, NamedValues& values) {
    if (!json_.contains(key)) return;
    for (const auto& [name, json] : Get(key, &Json::is_object).items()) {
      std::optional<ParameterValue> value = ValueFromJson(json);
      if (!value) FailWith(key);
      values.emplace_back(name, *std::move(value));
    }
  }
  void OptionalTask(const char* key, std::optional<int64_t>& task) {
    if (json_.contains(key)) Task(key, task.emplace());
  }
  void OptionalCount(const char* key, std::optional<int64_t>& count) {
    if (json_.contains(key)) Count(key, count.emplace());
  }

 private:
  static constexpr int64_t kMost = int64_t{1} << 53;

  [[noreturn]] static void FailWith(const char* key) {
    throw UserError(fmt::format("has a wrong `{}`", key));
  }

  const Json& Get(const char* key, auto is_right) const {
    const auto found = json_.find(key);
    if (found == json_.end()) throw UserError(fmt::format("has no `{}`", key));
    if (!std::invoke(is_right, *found)) FailWith(key);
    return *found;
  }

  void Whole(const char* key, int64_t most, int64_t& number) const {
    const auto is_right = [most](const Json& json) {
      return json.is_number_integer() && json >= 1 && json <= most;
    };
    Get(key, is_right).get_to(number);
  }

  template <class Value>
  void Convert(const char* key, std::optional<Value> (*convert)(const Json&), Value& value) const {
    value = *convert(Get(key, [&](const Json& json) { return convert(json).has_value(); }));
  }

  const Json& json_;
  const int64_t task_count_;
};

// A value at once and a schedule are both written as `set`.
template <class Kind>
bool IsOfKind(std::string_view kind, const Json& json) {
  if (kind != Kind::kKind) return false;
  return !std::is_same_v<Kind, SetParameter> || json.contains("value");
}

template <class Kind>
Kind Read(const Json& json, int64_t task_count) {
  Kind change;
  Reader reader(json, task_count);
  Members(reader, change);
  return change;
}

// As the first kind, from number `index` on, that it is of.
template <size_t index = 0>
std::optional<Change> ReadAsAny(const std::string& kind, const Json& json, int64_t task_count) {
  using Kind = std::variant_alternative_t<index, Change>;
  if constexpr (std::is_same_v<Kind, UnknownChange>) {
    return std::nullopt;
  } else if (IsOfKind<Kind>(kind, json)) {
    return Read<Kind>(json, task_count);
  } else {
    return ReadAsAny<index + 1>(kind, json, task_count);
  }
}

}  // namespace

std::string ChangeData(const Change& change) {
  return std::visit(variant::Overloaded{
                        [](const UnknownChange& unknown) { return unknown.data; },
                        []<class Known>(Known known) {  // a copy, because readers fill it in
                          Writer writer(Known::kKind);
                          Members(writer, known);
                          return writer.Written();
                        },
                    },
                    change);
}

Change ReadChange(const std::string& kind, const std::string& data, int64_t task_count) {
  const Json json = Json::parse(data, nullptr, false);
  if (!json.is_object()) throw UserError("is no JSON object");
  const auto command = json.find("command");
  if (command != json.end() && !command->is_string()) throw UserError("has a wrong `command`");
  if (command == json.end() || *command != kind) throw UserError("is of another kind");
  return ReadAsAny(kind, json, task_count).value_or(UnknownChange{kind, data});
}

}  // namespace runtime
