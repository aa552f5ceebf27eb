#include "compiler/emit/time_function_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string_view>

namespace compiler {
namespace {

// Of one element: {v} is what the function gives, {p} its past, {n} its argument now, {d} its
// duration. The same operations in the same order as in compiler/interpret/time_functions.cpp.
using Forms = std::array<std::string_view, 2>;

Forms AtStart(TimeFunction function) {
  switch (function) {
    case TimeFunction::kPrevious:
    case TimeFunction::kSmooth:
      return {"{p} = {n};", "{v} = {n};"};
    case TimeFunction::kChange:
    case TimeFunction::kRate:
      return {"{p} = {n};", "{v} = 0;"};
    case TimeFunction::kRising:
    case TimeFunction::kFalling:
      return {"{p} = {n};", "{v} = false;"};
    case TimeFunction::kHeld:
    case TimeFunction::kSince:  // need nothing then
    case TimeFunction::kDelay:
      break;
  }
  return {};
}

Forms InStep(TimeFunction function) {
  switch (function) {
    case TimeFunction::kPrevious:
      return {"{v} = {p};", "{p} = {n};"};
    case TimeFunction::kChange:
      return {"{v} = {n} - {p};", "{p} = {n};"};
    case TimeFunction::kRate:
      return {"{v} = ({n} - {p}) / frame->time_step;", "{p} = {n};"};
    case TimeFunction::kSmooth:
      return {"{p} = Approach({p}, {n}, 1.0 - Exp(-frame->time_step / {d}));", "{v} = {p};"};
    case TimeFunction::kHeld:
      return {"{p} = {n} ? {p} + frame->time_step : 0.0;",
              "{v} = {n} && {p} + 0.5 * frame->time_step > {d};"};
    case TimeFunction::kSince:
      return {"{v} = {n} ? 0.0 : {v} + frame->time_step;", ""};
    case TimeFunction::kRising:
      return {"{v} = {n} && !{p};", "{p} = {n};"};
    case TimeFunction::kFalling:
      return {"{v} = !{n} && {p};", "{p} = {n};"};
    case TimeFunction::kDelay:
      break;
  }
  return {};
}

std::string OfElement(std::string_view form, const std::string& index,
                      const TimeFunctionNames& names) {
  return fmt::format(fmt::runtime(form), fmt::arg("v", names.value + index),
                     fmt::arg("p", names.past + index), fmt::arg("n", names.now + index),
                     fmt::arg("d", names.duration));
}

// Written out where there are few: the C++ compiler then takes several at a time.
std::string ForEach(uint32_t size, std::string_view form, const TimeFunctionNames& names,
                    uint32_t written_out) {
  if (size == 1) return OfElement(form, "", names);
  if (size > written_out)
    return fmt::format("for (int i = 0; i < {}; ++i) {}", size, OfElement(form, "[i]", names));
  std::vector<std::string> elements;
  for (uint32_t i = 0; i < size; ++i)
    elements.push_back(OfElement(form, fmt::format("[{}]", i), names));
  return fmt::format("{}", fmt::join(elements, " "));
}

// The past is a ring: its newest value stands before `next`.
std::vector<std::string> DelayLines(const CheckedTimeFunction& function, uint32_t size,
                                    bool is_start, bool counts_steps,
                                    const TimeFunctionNames& names, HelperSet& helpers) {
  const uint32_t room = function.steps;
  const bool is_scalar = size == 1;
  const std::string index = is_scalar ? "" : "[i]";
  const std::string loop = is_scalar ? "" : fmt::format("for (int i = 0; i < {}; ++i) ", size);
  if (is_start) {
    return {fmt::format("for (int i = 0; i < {}; ++i) {}[i] = {}{};", room * size, names.past,
                        names.now, is_scalar ? "" : fmt::format("[i % {}]", size)),
            fmt::format("{} = 0;", names.next),
            fmt::format("{}{}{} = {}{};", loop, names.value, index, names.now, index)};
  }
  const auto of_past = [&](const std::string& place) {
    return is_scalar ? fmt::format("{}[{}]", names.past, place)
                     : fmt::format("{}[{} * {} + i]", names.past, place, size);
  };
  const std::string steps =
      counts_steps ? fmt::format("(double){}", names.duration)
                   : fmt::format("__builtin_floor({} / frame->time_step + 0.5)", names.duration);
  const std::string from = fmt::format("({} + {} - {}({}, {})) % {}", names.next, room,
                                       helpers.Use(Helper::kLag), steps, room - 1, room);
  return {fmt::format("{}{} = {}{};", loop, of_past(names.next), names.now, index),
          fmt::format("{}{}{} = {};", loop, names.value, index, of_past(from)),
          fmt::format("{0} = ({0} + 1) % {1};", names.next, room)};
}

}  // namespace

std::vector<std::string> AdvanceLines(const CheckedTimeFunction& function, const Type& type,
                                      bool is_start, bool counts_steps,
                                      const TimeFunctionNames& names, uint32_t written_out,
                                      HelperSet& helpers) {
  const uint32_t size = type.size();
  if (function.function == TimeFunction::kDelay)
    return DelayLines(function, size, is_start, counts_steps, names, helpers);
  if (function.function == TimeFunction::kSmooth && !is_start) {
    helpers.Use(Helper::kExp);
    helpers.Use(Helper::kApproach);
  }
  std::vector<std::string> lines;
  for (const std::string_view form :
       is_start ? AtStart(function.function) : InStep(function.function))
    if (!form.empty()) lines.push_back(ForEach(size, form, names, written_out));
  return lines;
}

}  // namespace compiler
