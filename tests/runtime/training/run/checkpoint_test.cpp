#include "runtime/training/run/checkpoint.h"

#include <gmock/gmock.h>

#include <istream>
#include <ostream>

#include "tests/runtime/training/run/error_of.h"

namespace runtime {
namespace {

// A module whose state is one number.
class Counter : public Module {
 public:
  Counter(std::string name, int64_t count) : Module(std::move(name)), count_(count) {}
  int64_t count() const { return count_; }
  void Save(std::ostream& out) const override {
    out.write(reinterpret_cast<const char*>(&count_), sizeof count_);
  }
  void Load(std::istream& in) override { in.read(reinterpret_cast<char*>(&count_), sizeof count_); }

 private:
  int64_t count_;
};

class Stateless : public Module {
 public:
  using Module::Module;
};

Counter& AddCounter(ModuleGraph& graph, const std::string& name, int64_t count) {
  return static_cast<Counter&>(graph.Add(std::make_unique<Counter>(name, count)));
}

TEST(Checkpoint, RestoresEveryModule) {
  ModuleGraph saved;
  AddCounter(saved, "first", 1);
  saved.Add(std::make_unique<Stateless>("nothing"));
  AddCounter(saved, "second", -2);
  ModuleGraph loaded;
  const Counter& first = AddCounter(loaded, "first", 0);
  loaded.Add(std::make_unique<Stateless>("nothing"));
  const Counter& second = AddCounter(loaded, "second", 0);
  LoadModules(loaded, SaveModules(saved));
  EXPECT_EQ(first.count(), 1);
  EXPECT_EQ(second.count(), -2);
}

TEST(Checkpoint, RefusesTheStateOfOtherModules) {
  ModuleGraph one;
  AddCounter(one, "first", 1);
  ModuleGraph two;
  AddCounter(two, "first", 1);
  AddCounter(two, "second", 2);
  ModuleGraph other;
  AddCounter(other, "other", 1);
  EXPECT_THAT(ErrorOf([&] { LoadModules(two, SaveModules(one)); }),
              testing::HasSubstr("no state for the module `second`"));
  EXPECT_THAT(ErrorOf([&] { LoadModules(one, SaveModules(two)); }),
              testing::HasSubstr("an agent with more modules"));
  EXPECT_THAT(ErrorOf([&] { LoadModules(one, SaveModules(other)); }),
              testing::HasSubstr("`first`"));
}

TEST(Checkpoint, RefusesAStateThatAModuleCannotRead) {
  ModuleGraph saved;
  saved.Add(std::make_unique<Stateless>("first"));
  ModuleGraph loaded;
  AddCounter(loaded, "first", 1);
  EXPECT_THAT(ErrorOf([&] { LoadModules(loaded, SaveModules(saved)); }),
              testing::HasSubstr("damaged"));
}

}  // namespace
}  // namespace runtime
