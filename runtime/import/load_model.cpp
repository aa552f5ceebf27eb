#include "runtime/import/load_model.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <new>
#include <string_view>

#include "runtime/base/user_error.h"
#include "runtime/import/mesh_file.h"

namespace runtime {
namespace {

enum class Trial { kDone, kCrash, kTooMuch };

constexpr rlim_t kMostSeconds = 30;
constexpr rlim_t kMostMemory = 2'000'000'000;  // [bytes]

void LimitResources() {
  const rlimit time{kMostSeconds, kMostSeconds};
  setrlimit(RLIMIT_CPU, &time);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // these map all of the memory
  const rlimit memory{kMostMemory, kMostMemory};
  setrlimit(RLIMIT_AS, &memory);
#endif
}

Trial LoadInChild(const char* name, const mjVFS* files) {
  LimitResources();
  try {
    std::array<char, 1024> error{};
    mj_loadXML(name, files, error.data(), error.size());
  } catch (const UserError& error) {  // most are told again to the parent
    const bool is_memory = std::string_view(error.what()).find("allocate") != std::string::npos;
    return is_memory ? Trial::kTooMuch : Trial::kDone;
  } catch (const std::bad_alloc&) {
    return Trial::kTooMuch;
  }
  return Trial::kDone;
}

// Files can be so wrong that MuJoCo crashes, or so large that it does not come to an end. What it
// does on this one is found out in a process of its own.
Trial TryInChild(const char* name, const mjVFS* files) {
  const pid_t child = fork();
  if (child < 0) return Trial::kDone;  // too many processes: what follows will tell
  if (child == 0) _exit(static_cast<int>(LoadInChild(name, files)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFSIGNALED(status)) return static_cast<Trial>(WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  return signal == SIGXCPU || signal == SIGKILL ? Trial::kTooMuch : Trial::kCrash;
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

// Null, with MuJoCo's message, where it cannot make a model. Throws UserError where it crashes or
// does not come to an end.
MujocoModel TryLoad(const std::filesystem::path& file, const char* name, const MemoryFiles& files,
                    std::string& message) {
  switch (TryInChild(name, files.get())) {
    case Trial::kDone:
      break;
    case Trial::kCrash:
      throw UserError(fmt::format(
          "{}: MuJoCo crashes on it: see whether it is well-formed and complete", file.string()));
    case Trial::kTooMuch:
      throw UserError(fmt::format(
          "{}: MuJoCo needs more than {} s or {} GB for it: see whether a count or a size in it is "
          "too large",
          file.string(), kMostSeconds, kMostMemory / 1'000'000'000));
  }
  std::array<char, 1024> error{};
  MujocoModel model(mj_loadXML(name, files.get(), error.data(), error.size()));
  message = error.data();
  return model;
}

// With the meshes' places, where MuJoCo says what we have called them for it.
std::string WithMeshesOf(const ModelFile& file, std::string message) {
  for (const auto& [name, place] : file.meshes()) {
    const size_t found = message.find(name);
    if (found != message.npos) message.replace(found, name.size(), place.string());
  }
  return message;
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
  for (const auto& [name, place] : file.meshes()) files.Add(name, MeshBytes(place));
  for (int attempt = 0;; ++attempt) {
    files.Add(kName, file.text());
    std::string message;
    MujocoModel model = TryLoad(file.file(), kName, files, message);
    if (model) return model;
    if (attempt == kMostAttempts || !file.LeaveOut(message)) {
      throw NoModel(file.file(), WithMeshesOf(file, std::move(message)));
    }
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
  files.Add("mesh" + extension, MeshBytes(file));
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
