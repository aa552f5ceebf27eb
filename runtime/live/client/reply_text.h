// What a trainer says, for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace runtime {

// The value of a reply, with a newline at its end: a text as it is, an object as a row for each
// member, a list of objects as a table.
std::string ReplyText(const nlohmann::json& value);

// An event in one line, without a newline.
std::string EventLine(const nlohmann::json& event);

}  // namespace runtime
