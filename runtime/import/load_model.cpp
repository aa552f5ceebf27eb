#include "runtime/import/load_model.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "base/file/read.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

// A cube of 5 cm as binary STL, for a mesh that is not there.
std::string CubeOf5Centimeters() {
  constexpr float kHalf = 0.025F;
  constexpr std::array<std::array<int, 3>, 12> kTriangles = {{{0, 1, 3},
                                                              {0, 3, 2},
                                                              {4, 6, 7},
                                                              {4, 7, 5},
                                                              {0, 4, 5},
                                                              {0, 5, 1},
                                                              {2, 3, 7},
                                                              {2, 7, 6},
                                                              {0, 2, 6},
                                                              {0, 6, 4},
                                                              {1, 5, 7},
                                                              {1, 7, 3}}};
  std::string bytes(80, '\0');
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(static_cast<uint32_t>(kTriangles.size()));
  for (const auto& triangle : kTriangles) {
    for (int i = 0; i < 3; ++i) append(0.0F);  // its normal
    for (const int corner : triangle) {
      for (const int axis : {4, 2, 1}) append((corner & axis) != 0 ? kHalf : -kHalf);
    }
    append(uint16_t{0});
  }
  return bytes;
}

std::string BytesOf(const std::filesystem::path& mesh) {
  if (mesh.empty()) return CubeOf5Centimeters();
  file::Reading reading = file::Read(mesh.string());
  if (!reading.problem.empty()) {
    throw UserError(fmt::format("{}: cannot read the mesh: {}", mesh.string(), reading.problem));
  }
  return std::move(reading.bytes);
}

// Files can be so wrong that MuJoCo crashes. Whether it does on this one is found out in a process
// of its own.
bool CrashesOn(const char* name, const mjVFS* files) {
  const pid_t child = fork();
  if (child < 0) return false;  // too many processes: what follows will tell
  if (child == 0) {
    try {
      std::array<char, 1024> error{};
      mj_loadXML(name, files, error.data(), error.size());
    } catch (const UserError&) {  // told again to the parent
    }
    _exit(0);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status);
}

// In one line.
std::string Line(std::string message) {
  for (char& c : message) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  while (!message.empty() && message.back() == ' ') message.pop_back();
  return message;
}

// What a user can do about some of MuJoCo's messages.
std::string Remedy(const std::string& message) {
  if (message.find("mass and inertia of moving bodies") != std::string::npos)
    return "; give the link a mass and an inertia";
  if (message.find("faces") != std::string::npos)
    return "; make the mesh simpler, or give the link a box or a capsule for its collisions";
  return "";
}

// Null, with MuJoCo's message, where it cannot make a model. Throws UserError where it crashes.
MujocoModel TryLoad(const std::filesystem::path& file, const char* name, const MemoryFiles& files,
                    std::string& message) {
  if (CrashesOn(name, files.get())) {
    throw UserError(fmt::format(
        "{}: MuJoCo crashes on it: see whether it is well-formed and complete", file.string()));
  }
  std::array<char, 1024> error{};
  MujocoModel model(mj_loadXML(name, files.get(), error.data(), error.size()));
  message = error.data();
  return model;
}

UserError NoModel(const std::filesystem::path& file, const std::string& message) {
  return UserError(fmt::format("{}: MuJoCo cannot make a model of it: {}{}", file.string(),
                               Line(message), Remedy(message)));
}

}  // namespace

MujocoModel LoadModel(ModelFile& file) {
  constexpr int kMostAttempts = 1000;
  constexpr const char* kName = "model.xml";
  UseMujoco();
  MemoryFiles files;
  for (const auto& [name, place] : file.meshes()) files.Add(name, BytesOf(place));
  for (int attempt = 0;; ++attempt) {
    files.Add(kName, file.text());
    std::string message;
    MujocoModel model = TryLoad(file.file(), kName, files, message);
    if (model) return model;
    if (attempt == kMostAttempts || !file.LeaveOut(message)) throw NoModel(file.file(), message);
    files.Remove(kName);
  }
}

MujocoModel LoadMesh(const std::filesystem::path& file, double scale) {
  constexpr const char* kName = "model.xml";
  const std::string extension = ExtensionOf(file.string());
  UseMujoco();
  if (extension != ".stl" && extension != ".obj") {
    throw UserError(fmt::format("{}: neither STL nor OBJ: convert it", file.string()));
  }
  MemoryFiles files;
  files.Add("mesh" + extension, BytesOf(file));
  files.Add(kName,
            fmt::format("<mujoco><asset><mesh name=\"mesh\" file=\"mesh{}\" scale=\"{} {} {}\"/>"
                        "</asset><worldbody><body><freejoint/><geom type=\"mesh\" mesh=\"mesh\"/>"
                        "</body></worldbody></mujoco>",
                        extension, scale, scale, scale));
  std::string message;
  MujocoModel model = TryLoad(file, kName, files, message);
  if (!model) throw NoModel(file, message);
  return model;
}

}  // namespace runtime
