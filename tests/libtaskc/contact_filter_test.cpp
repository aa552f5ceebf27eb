// The filter of contacts as a host in C calls it.
#include "runtime/training/simulation/contact_filter.h"

#include <gmock/gmock.h>

#include <random>
#include <vector>

#include "tests/libtaskc/contact_filter_host.h"

namespace libtaskc {
namespace {

using Flags = std::vector<unsigned char>;

Flags Filtered(double step, const Flags& touches) {
  Flags contact(touches.size());
  FilterContacts(step, touches.data(), static_cast<int>(touches.size()), contact.data());
  return contact;
}

// How many of them are, or are not, in contact before that changes; they touch from the second on.
int StepsUntilChange(double step, unsigned char first) {
  Flags touches(1000, 1 - first);
  touches[0] = first;
  const Flags contact = Filtered(step, touches);
  EXPECT_EQ(contact[0], first);
  return static_cast<int>(std::ranges::find(contact, 1 - first) - contact.begin());
}

TEST(ContactFilterOfAHost, ShowsATouchAfterEightMillisecondsAndItsEndAfterThirtyNine) {
  EXPECT_EQ(StepsUntilChange(0.0002, 0), 40);
  EXPECT_EQ(StepsUntilChange(0.0002, 1), 193);
  EXPECT_EQ(StepsUntilChange(0.002, 0), 4);
  EXPECT_EQ(StepsUntilChange(0.002, 1), 20);
}

TEST(ContactFilterOfAHost, DoesNotShowTouchesOfThreeMilliseconds) {
  Flags touches(1000, 0);
  std::fill_n(touches.begin() + 100, 16, 1);
  EXPECT_EQ(Filtered(0.0002, touches), Flags(1000, 0));
}

TEST(ContactFilterOfAHost, IsTheTrainers) {
  std::mt19937 random(3);
  for (const double step : {0.0002, 0.001, 0.005 / 3, 0.005}) {
    Flags touches(2000);
    for (size_t i = 0; i < touches.size(); ++i) {
      touches[i] = i > 0 && random() % 20 > 0 ? touches[i - 1] : random() % 2;
    }
    runtime::ContactFilter trainer(1, step);
    trainer.Start({touches.data(), 1});
    Flags expected = {trainer.flag(0)};
    for (size_t i = 1; i < touches.size(); ++i) {
      trainer.Update({&touches[i], 1});
      expected.push_back(trainer.flag(0));
    }
    EXPECT_THAT(expected, testing::AllOf(testing::Contains(0), testing::Contains(1)));
    EXPECT_EQ(Filtered(step, touches), expected) << step;
  }
}

}  // namespace
}  // namespace libtaskc
