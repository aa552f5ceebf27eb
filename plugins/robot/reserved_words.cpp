#include "plugins/robot/reserved_words.h"

#include <algorithm>
#include <array>

namespace robot {

bool IsReservedWord(std::string_view name) {
  constexpr auto kWords = std::to_array<std::string_view>(
      {"task", "for", "start", "sensor", "param", "memory", "metric", "on", "in", "per", "let",
       "if", "else", "reward", "end_episode", "truncate_episode", "or", "and", "not", "true",
       "false",
       // units
       "m", "cm", "mm", "km", "s", "ms", "us", "min", "kg", "g", "N", "J", "W", "Hz", "rad",
       "deg"});
  return std::ranges::find(kWords, name) != kWords.end();
}

}  // namespace robot
