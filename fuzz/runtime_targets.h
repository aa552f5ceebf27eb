// What the trainer reads that others may have written.
#pragma once

#include <string>

namespace fuzz {

// Descriptions, as files or texts: each is read, or refused with a message.
bool Robot(const std::string& text);
bool Agent(const std::string& text);
bool Study(const std::string& text);
bool World(const std::string& text);
bool Signal(const std::string& text);    // a CSV file of what a signal is in the course of time
bool Greeting(const std::string& text);  // of a program that is an environment

// Damage (edits.h) to what the trainer itself has written.
bool Plugin(const std::string& edits);      // a shared object, before the loader sees it
bool Run(const std::string& edits);         // the database of a run, read as `show` and `report` do
bool Checkpoint(const std::string& edits);  // what was learned
bool Change(const std::string& text);       // of the journal: its kind, a line's end, its data

// What clients send.
bool Request(const std::string& text);  // method, target and body, each on a line of its own
bool Frames(const std::string& bytes);  // after a connection has become a WebSocket

}  // namespace fuzz
