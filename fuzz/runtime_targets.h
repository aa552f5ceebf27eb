// What the trainer reads that others may have written.
#pragma once

#include <string>

namespace fuzz {

// Descriptions, as files or texts: each is read, or refused with a message.
void Robot(const std::string& text);
void Agent(const std::string& text);
void Study(const std::string& text);
void World(const std::string& text);
void Signal(const std::string& text);    // a CSV file of what a signal is in the course of time
void Greeting(const std::string& text);  // of a program that is an environment

// Damage (edits.h) to what the trainer itself has written.
void Plugin(const std::string& edits);      // a shared object, before the loader sees it
void Run(const std::string& edits);         // the database of a run, read as `show` and `report` do
void Checkpoint(const std::string& edits);  // what was learned
void Change(const std::string& text);       // of the journal: its kind, a line's end, its data

// What clients send.
void Request(const std::string& text);  // method, target and body, each on a line of its own
void Frames(const std::string& bytes);  // after a connection has become a WebSocket

}  // namespace fuzz
