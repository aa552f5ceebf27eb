#include "runtime/core/module/port.h"

#include <gmock/gmock.h>

#include <memory>

#include "tests/runtime/core/module/test_modules.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string MessageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const UserError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Signal, CallsSlotsInTheOrderOfConnection) {
  Source source("source");
  std::string order;
  Sink a("a"), b("b"), c("c");
  for (Sink* sink : {&a, &b, &c}) sink->then = [&order, sink](double) { order += sink->name(); };
  source.reward.Connect(c.reward);
  source.reward.Connect(a.reward);
  source.reward.Connect(b.reward);
  source.reward(1.5);
  EXPECT_EQ(order, "cab");
  EXPECT_THAT(a.received, ElementsAre(1.5));
}

TEST(Signal, ASlotCanBeConnectedBehindAnother) {
  Source source("source");
  std::string order;
  Sink a("a"), b("b"), c("c");
  for (Sink* sink : {&a, &b, &c}) sink->then = [&order, sink](double) { order += sink->name(); };
  source.reward.Connect(a.reward);
  source.reward.Connect(b.reward);
  Port::ConnectBehind(source.reward, c.reward, a.reward);
  source.reward(1.5);
  EXPECT_EQ(order, "acb");
}

TEST(Signal, NestedEmissionRunsDepthFirst) {
  Source source("source");
  Sink a("a"), b("b");
  a.then = [&](double value) {
    if (value > 0) source.reward(value - 1);
  };
  source.reward.Connect(a.reward);
  source.reward.Connect(b.reward);
  source.reward(2);
  EXPECT_THAT(a.received, ElementsAre(2, 1, 0));
  EXPECT_THAT(b.received, ElementsAre(0, 1, 2));
}

TEST(Signal, SlotConnectedDuringAnEmissionIsCalledFromTheNextOneOn) {
  Source source("source");
  Sink a("a");
  std::vector<std::unique_ptr<Sink>> late;
  a.then = [&](double value) {
    // Many, so that the list of slots has to grow while it is being walked.
    for (int i = 0; i < 100; ++i) {
      late.push_back(std::make_unique<Sink>("late"));
      source.reward.Connect(late.back()->reward);
    }
    if (value > 1) source.reward(value - 1);  // not visible in a nested emission either
  };
  source.reward.Connect(a.reward);
  source.reward(2);
  a.then = nullptr;
  for (const auto& sink : late) EXPECT_THAT(sink->received, IsEmpty());
  source.reward(7);
  EXPECT_EQ(late.size(), 200u);
  for (const auto& sink : late) EXPECT_THAT(sink->received, ElementsAre(7));
}

TEST(Signal, SlotDisconnectedDuringAnEmissionIsSkipped) {
  Source source("source");
  Sink a("a"), b("b"), c("c");
  a.then = [&](double) {
    if (source.reward.IsConnectedTo(b.reward)) source.reward.Disconnect(b.reward);
  };
  for (Sink* sink : {&a, &b, &c}) source.reward.Connect(sink->reward);
  source.reward(1);
  source.reward(2);
  EXPECT_THAT(b.received, IsEmpty());
  EXPECT_THAT(c.received, ElementsAre(1, 2));
  EXPECT_THAT(source.reward.Connections(), ElementsAre(&a.reward, &c.reward));
}

TEST(Signal, SlotThatDisconnectsItselfHasItsCallAndNoMore) {
  Source source("source");
  Sink a("a"), b("b");
  a.then = [&](double) { source.reward.Disconnect(a.reward); };
  source.reward.Connect(a.reward);
  source.reward.Connect(b.reward);
  source.reward(1);
  source.reward(2);
  EXPECT_THAT(a.received, ElementsAre(1));
  EXPECT_THAT(b.received, ElementsAre(1, 2));
}

TEST(Signal, SlotReconnectedDuringAnEmissionMovesToTheEnd) {
  Source source("source");
  Sink a("a"), b("b");
  a.then = [&](double value) {
    if (value > 1) return;
    source.reward.Disconnect(b.reward);
    source.reward.Connect(b.reward);
    EXPECT_THAT(source.reward.Connections(), ElementsAre(&a.reward, &b.reward));
  };
  source.reward.Connect(a.reward);
  source.reward.Connect(b.reward);
  source.reward(1);
  source.reward(2);
  EXPECT_THAT(b.received, ElementsAre(2));
}

TEST(Signal, ModuleDestroyedDuringAnEmissionIsSkipped) {
  Source source("source");
  Sink a("a");
  auto doomed = std::make_unique<Sink>("doomed");
  a.then = [&](double) { doomed.reset(); };
  source.reward.Connect(a.reward);
  source.reward.Connect(doomed->reward);
  source.reward(1);
  source.reward(2);
  EXPECT_THAT(a.received, ElementsAre(1, 2));
  EXPECT_THAT(source.reward.Connections(), ElementsAre(&a.reward));
}

TEST(Signal, EmissionOfADestroyedSignalStops) {
  auto source = std::make_unique<Source>("source");
  Sink a("a"), b("b");
  a.then = [&](double value) {
    if (value > 0) {
      source->reward(0);
    } else {
      source.reset();
    }
  };
  source->reward.Connect(a.reward);
  source->reward.Connect(b.reward);
  source->reward(1);
  EXPECT_THAT(a.received, ElementsAre(1, 0));
  EXPECT_THAT(b.received, IsEmpty());
  EXPECT_THAT(a.reward.Connections(), IsEmpty());
}

TEST(Signal, StaysUsableAfterAnExceptionFromASlot) {
  Source source("source");
  Sink a("a"), b("b");
  a.then = [&](double) {
    source.reward.Disconnect(a.reward);
    throw UserError("broken");
  };
  source.reward.Connect(a.reward);
  source.reward.Connect(b.reward);
  EXPECT_THROW(source.reward(1), UserError);
  source.reward(2);
  EXPECT_THAT(b.received, ElementsAre(2));
}

TEST(In, ReadsTheOutPortByReference) {
  Source source("source");
  Sink sink("sink");
  EXPECT_FALSE(sink.level.connected());
  sink.level.Connect(source.still);
  EXPECT_EQ(&sink.level(), &source.level_value);
}

TEST(In, MustBeConnectedUnlessItSaysOtherwise) {
  Source source("source");
  Sink sink("sink");
  EXPECT_TRUE(sink.level.must_be_connected());
  EXPECT_FALSE(sink.reward.must_be_connected());
  EXPECT_FALSE(source.level.must_be_connected());
  const In<double> optional(&sink, "optional", "", In<double>::Need::kOptional);
  EXPECT_FALSE(optional.must_be_connected());
}

TEST(In, MethodBringsTheValueUpToDateAtEachRead) {
  Source source("source");
  Sink sink("sink");
  sink.level.Connect(source.level);
  EXPECT_EQ(source.refreshes, 0);
  EXPECT_EQ(sink.level(), 2.5);
  source.level_value = 3;
  EXPECT_EQ(sink.level(), 3);
  EXPECT_EQ(source.refreshes, 2);
}

TEST(In, CanBeReconnectedToAnotherOutPort) {
  Source source("source");
  Sink sink("sink");
  sink.level.Connect(source.level);
  sink.level.Disconnect();
  EXPECT_FALSE(sink.level.connected());
  sink.level.Connect(source.still);
  EXPECT_EQ(sink.level(), 2.5);
  EXPECT_EQ(source.refreshes, 0);
}

TEST(In, IsDisconnectedWhenTheOtherModuleIsDestroyed) {
  Sink sink("sink");
  {
    Source source("source");
    sink.level.Connect(source.level);
  }
  EXPECT_FALSE(sink.level.connected());
}

TEST(Out, ForgetsTheReadersThatAreDestroyed) {
  Source source("source");
  {
    Sink sink("sink");
    sink.level.Connect(source.level);
    EXPECT_THAT(source.level.Connections(), ElementsAre(&sink.level));
  }
  EXPECT_THAT(source.level.Connections(), IsEmpty());
}

TEST(Port, IsListedByItsModuleAsLongAsItLives) {
  Source source("source");
  const size_t ports = source.ports().size();
  {
    Out<double> another(&source, "another", &source.level_value);
    EXPECT_EQ(source.ports().back(), &another);
    EXPECT_EQ(another.full_name(), "source.another");
  }
  EXPECT_EQ(source.ports().size(), ports);
}

TEST(Connect, AcceptsTheTwoInEitherOrder) {
  Source source("source");
  Sink sink("sink");
  Port::Connect(sink.reward, source.reward);
  Port::Connect(sink.level, source.level);
  source.reward(4);
  EXPECT_THAT(sink.received, ElementsAre(4));
  EXPECT_EQ(sink.level(), 2.5);
}

TEST(Connect, RefusesKindsThatDoNotBelongTogether) {
  Source source("source");
  Sink sink("sink");
  EXPECT_EQ(MessageOf([&] { Port::Connect(source.reward, sink.level); }),
            "cannot connect `source.reward` to `sink.level`: `source.reward` is a signal and "
            "`sink.level` is an in port: a signal needs a slot, an out port an in port");
}

TEST(Connect, RefusesOtherArguments) {
  Source source("source");
  Sink sink("sink");
  EXPECT_EQ(MessageOf([&] { Port::Connect(source.reward, sink.end); }),
            "cannot connect `source.reward` to `sink.end`: the types differ: `source.reward` is "
            "`(real)`, `sink.end` is `(episode end)`");
}

TEST(Connect, RefusesOtherUnits) {
  Source source("source");
  Sink sink("sink");
  EXPECT_EQ(MessageOf([&] { Port::Connect(source.velocity, sink.position); }),
            "cannot connect `source.base.velocity` to `sink.base.position`: the types differ: "
            "`source.base.velocity` is `vec3 [m/s]`, `sink.base.position` is `vec3 [m]`");
}

TEST(Connect, RefusesAConnectionThatThereIsAlready) {
  Source source("source");
  Sink sink("sink");
  source.reward.Connect(sink.reward);
  EXPECT_EQ(MessageOf([&] { source.reward.Connect(sink.reward); }),
            "cannot connect `source.reward` to `sink.reward`: they are connected already");
  source.reward(1);
  EXPECT_THAT(sink.received, ElementsAre(1));
}

TEST(Connect, RefusesASecondOutPort) {
  Source source("source");
  Sink sink("sink");
  sink.level.Connect(source.level);
  EXPECT_EQ(MessageOf([&] { sink.level.Connect(source.still); }),
            "cannot connect `source.still` to `sink.level`: `sink.level` is connected to "
            "`source.level` already: disconnect the two first");
}

TEST(Disconnect, RefusesPortsThatAreNotConnected) {
  Source source("source");
  Sink sink("sink");
  EXPECT_EQ(MessageOf([&] { Port::Disconnect(source.reward, sink.reward); }),
            "cannot disconnect `source.reward` from `sink.reward`: they are not connected");
}

}  // namespace
}  // namespace runtime
