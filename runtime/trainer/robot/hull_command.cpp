#include "runtime/trainer/robot/hull_command.h"

#include <memory>

#include "base/text/print.h"
#include "runtime/import/mesh_hull.h"
#include "runtime/trainer/commands.h"

namespace runtime {
namespace {

int PrintHull(const MeshOptions& options) {
  const MeshHull hull = HullOfMesh(options);
  text::Print(
      "# The hull of {} of the {} vertices of {}: {:.4g} l. Its position is in the mesh's "
      "frame.\n{}",
      hull.link.shape.points.size(), hull.vertices, options.file.filename().string(),
      1000 * hull.volume, hull.text);
  return kSuccess;
}

}  // namespace

void AddHullCommand(command_line::Command& robot) {
  const auto options = std::make_shared<MeshOptions>();
  command_line::Command& command =
      robot.AddCommand("hull",
                       "Prints the convex hull of a mesh as a link of a robot.toml: its corners, "
                       "its center of mass, "
                       "and the inertia that it has if its density is uniform.");
  command.AddOption("FILE", options->file, "the mesh").Required().ValueName("FILE.stl|FILE.obj");
  command
      .AddOption("--scale", options->scale,
                 "how many meters one unit of the file is: 0.001 for millimeters")
      .ShowDefault()
      .Range(1e-6, 1e6);
  command.AddOption("--mass", options->mass, "of the link [kg]").ShowDefault().Range(1e-6, 1e6);
  command
      .AddOption("--directions", options->directions,
                 "in which corners are looked for: the more, the finer")
      .ShowDefault()
      .Range(4, 1000);
  command.OnRun([options] { return PrintHull(*options); });
}

}  // namespace runtime
