#include "compiler/interpret/time_functions.h"

#include <algorithm>
#include <cmath>

namespace compiler {
namespace {

// In each branch `value`, `past` and `now` are of one element.

template <typename Number>
void AdvancePrevious(bool is_start, Number now, Number& past, Number& value) {
  value = is_start ? now : past;
  past = now;
}

template <typename Number>
void AdvanceChange(bool is_start, Number now, Number& past, Number& value) {
  value = is_start ? Number{0} : now - past;
  past = now;
}

void AdvanceRate(const TimeStepOf& step, double now, double& past, double& value) {
  value = step.is_start ? 0 : (now - past) / step.time_step;
  past = now;
}

// A share of the way from the past to the present, never beyond it.
void AdvanceSmooth(const TimeStepOf& step, double now, double& past, double& value) {
  const double share = 1 - std::exp(-step.time_step / step.duration);
  const double next = past + (now - past) * share;
  past = step.is_start || (next > now) == (past < now) ? now : next;
  value = past;
}

// Half a step is added, so that times that are no exact sums of steps do not matter.
void AdvanceHeld(const TimeStepOf& step, bool now, double& past, int64_t& value) {
  past = now ? past + step.time_step : 0;
  value = now && past + 0.5 * step.time_step > step.duration;
}

void AdvanceSince(const TimeStepOf& step, bool now, double& value) {
  value = now ? 0 : value + step.time_step;
}

void AdvanceEdge(const TimeStepOf& step, bool is_rising, int64_t now, int64_t& past,
                 int64_t& value) {
  value = !step.is_start && now != past && (now != 0) == is_rising;
  past = now;
}

size_t LagOf(const TimeStepOf& step) {
  const double steps =
      step.counts_steps ? step.duration : std::floor(step.duration / step.time_step + 0.5);
  const double most = step.function.steps - 1;
  return static_cast<size_t>(steps < most ? steps : most);
}

// The past is a ring: its newest value stands before `next`.
template <typename Number>
void AdvanceDelay(const TimeStepOf& step, const std::vector<Number>& now, std::vector<Number>& past,
                  int64_t& next, std::vector<Number>& value) {
  const size_t size = now.size();
  const size_t room = step.function.steps;
  if (step.is_start) {
    for (size_t i = 0; i < past.size(); ++i) past[i] = now[i % size];
    next = 0;
    value = now;
    return;
  }
  const auto at = static_cast<size_t>(next);
  for (size_t i = 0; i < size; ++i) past[at * size + i] = now[i];
  const size_t from = (at + room - LagOf(step)) % room;
  for (size_t i = 0; i < size; ++i) value[i] = past[from * size + i];
  next = static_cast<int64_t>((at + 1) % room);
}

}  // namespace

void Advance(const TimeStepOf& step, const Value& now, std::vector<Value>& memory) {
  const CheckedTimeFunction& function = step.function;
  Value& value = memory[function.value];
  Value& past = memory[function.past];  // of `since`: not its own, and not touched
  const auto each = [&](const auto& advance) {
    std::visit(
        [&]<typename Numbers>(const Numbers& elements) {
          for (size_t i = 0; i < elements.size(); ++i)
            advance(elements[i], std::get<Numbers>(past)[i], std::get<Numbers>(value)[i]);
        },
        now);
  };
  switch (function.function) {
    case TimeFunction::kPrevious:
      return each([&](auto x, auto& before, auto& result) {
        AdvancePrevious(step.is_start, x, before, result);
      });
    case TimeFunction::kChange:
      return each([&](auto x, auto& before, auto& result) {
        AdvanceChange(step.is_start, x, before, result);
      });
    case TimeFunction::kRate:
    case TimeFunction::kSmooth: {
      const auto& numbers = std::get<Reals>(now);
      for (size_t i = 0; i < numbers.size(); ++i) {
        double& before = std::get<Reals>(past)[i];
        double& result = std::get<Reals>(value)[i];
        if (function.function == TimeFunction::kRate) {
          AdvanceRate(step, numbers[i], before, result);
        } else {
          AdvanceSmooth(step, numbers[i], before, result);
        }
      }
      return;
    }
    case TimeFunction::kHeld: {
      const auto& held = std::get<Integers>(now);
      for (size_t i = 0; i < held.size(); ++i)
        AdvanceHeld(step, held[i] != 0, std::get<Reals>(past)[i], std::get<Integers>(value)[i]);
      return;
    }
    case TimeFunction::kSince: {
      const auto& held = std::get<Integers>(now);
      for (size_t i = 0; i < held.size(); ++i)
        AdvanceSince(step, held[i] != 0, std::get<Reals>(value)[i]);
      return;
    }
    case TimeFunction::kRising:
    case TimeFunction::kFalling: {
      const auto& held = std::get<Integers>(now);
      const bool is_rising = function.function == TimeFunction::kRising;
      for (size_t i = 0; i < held.size(); ++i)
        AdvanceEdge(step, is_rising, held[i], std::get<Integers>(past)[i],
                    std::get<Integers>(value)[i]);
      return;
    }
    case TimeFunction::kDelay:
      return std::visit(
          [&]<typename Numbers>(const Numbers& elements) {
            AdvanceDelay(step, elements, std::get<Numbers>(past),
                         std::get<Integers>(memory[function.next]).front(),
                         std::get<Numbers>(value));
          },
          now);
  }
}

}  // namespace compiler
