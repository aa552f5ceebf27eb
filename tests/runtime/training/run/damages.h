// Every way in which a row of a run's database can be what no trainer has written, for tests of who
// reads it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace runtime {

// SQL that damages the database; its text says how.
using Damage = std::string;

// Lets the tables of the run take whatever is written to them: what a damaged page would hold.
void LiftConstraints(const std::filesystem::path& database);

// For each column of each table all kinds of wrong values in its last rows; rows, columns and
// tables that are gone.
std::vector<Damage> AllDamages(const std::filesystem::path& database);

// Returns whether anything has changed: some of it is refused by SQLite itself.
bool Apply(const Damage& damage, const std::filesystem::path& database);

}  // namespace runtime
