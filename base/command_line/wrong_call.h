#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace command_line {

// What is wrong with a call that `app` has not understood, in one line, with the command or option
// that was probably meant. `error`: what parsing the line has thrown.
std::string WhatIsWrong(const CLI::App& app, const CLI::ParseError& error);

}  // namespace command_line
