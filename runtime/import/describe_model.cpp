#include "runtime/import/describe_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/base/user_error.h"
#include "runtime/import/body_parts.h"
#include "runtime/import/joint_parts.h"
#include "runtime/import/load_model.h"
#include "runtime/import/names.h"
#include "runtime/import/site_parts.h"

namespace runtime {
namespace {

using Vector = Eigen::Vector3d;

constexpr double kLeastMass = 1e-3;  // of a link that the model gives none [kg]
constexpr double kShare = 1e-3;      // of a body's mass: what a link gets that is but a shape of it
constexpr double kPoint = 0.005;     // radius of the shape of a link that has none [m]

ShapePart PointAt(const Vector& place) {
  ShapePart point;
  point.shape = {.kind = robot::ShapeKind::kSphere, .radius = kPoint};
  point.position = place;
  point.orientation = Eigen::Quaterniond::Identity();
  point.friction = 1;
  return point;
}

MassPart BallOf(double mass, const Vector& place, double radius = 0.01) {
  const double inertia = 0.4 * mass * radius * radius;
  return {mass, place, inertia * Eigen::Matrix3d::Identity()};
}

class Builder {
 public:
  Builder(const ModelFile& file, const mjModel& model)
      : file_(file),
        model_(model),
        data_(mj_makeData(&model)),
        owners_(static_cast<size_t>(model.nbody), 0),
        links_(static_cast<size_t>(model.nbody), -1) {
    mj_kinematics(&model_, data_.get());
    mj_comPos(&model_, data_.get());
  }

  DescribedModel Build(std::optional<bool> fixed_base) {
    const int root = ChooseRoot();
    ChooseOwners(root);
    ReadBase(root, fixed_base);
    for (int body = root; body < model_.nbody; ++body) {
      if (owners_[body] == body && Top(body) == top_) AddBody(body, body == root);
    }
    AddSites(root);
    AddExclusions();
    WarnOfRest();
    Recenter();
    return std::move(described_);
  }

 private:
  robot::RobotDescription& robot() { return described_.robot; }
  void Warn(const std::string& text) {
    described_.warnings.push_back(fmt::format("{}: {}", file_.file().string(), text));
  }
  void WarnOf(const std::vector<std::string>& names, const std::string& text) {
    if (!names.empty()) Warn(fmt::format("{}: `{}`", text, fmt::join(names, "`, `")));
  }
  std::string BodyName(int body) const { return NameIn(model_, mjOBJ_BODY, body); }

  // The ancestor that hangs on the world.
  int Top(int body) const {
    while (body > 0 && model_.body_parentid[body] != 0) body = model_.body_parentid[body];
    return body;
  }

  // The body that all others hang on: of several trees the largest, without frames above it that
  // have neither mass nor shape.
  int ChooseRoot() {
    if (model_.nbody < 2) {
      throw UserError(fmt::format("{}: the model has no body{}", file_.file().string(),
                                  file_.is_urdf() ? ": it needs a `link`" : ""));
    }
    std::vector<int> sizes(static_cast<size_t>(model_.nbody), 0);
    for (int body = 1; body < model_.nbody; ++body) ++sizes[static_cast<size_t>(Top(body))];
    top_ = static_cast<int>(std::ranges::max_element(sizes) - sizes.begin());
    for (int body = 1; body < model_.nbody; ++body) {
      if (model_.body_parentid[body] == 0 && body != top_)
        Warn(fmt::format("`{}` is left out: a robot is one tree", BodyName(body)));
    }
    int root = top_;
    while (model_.body_jntnum[root] == 0 && MassOf(model_, *data_, root).mass == 0 &&
           ShapesOf(model_, *data_, root).empty()) {
      const std::vector<int> children = ChildrenOf(root);
      if (children.size() != 1 || model_.body_jntnum[children.front()] != 0) break;
      root = children.front();
    }
    return root;
  }

  std::vector<int> ChildrenOf(int body) const {
    std::vector<int> children;
    for (int i = body + 1; i < model_.nbody; ++i) {
      if (model_.body_parentid[i] == body) children.push_back(i);
    }
    return children;
  }

  // Bodies that do not move against their parent and have no shape are part of it, as sites.
  void ChooseOwners(int root) {
    for (int body = root; body < model_.nbody; ++body) {
      const bool is_part =
          body != root && model_.body_jntnum[body] == 0 && ShapesOf(model_, *data_, body).empty();
      owners_[body] = is_part ? owners_[model_.body_parentid[body]] : body;
      if (is_part && Top(body) == top_) parts_.push_back(BodyName(body));
    }
  }

  bool HasFreeJoint(int body) const {
    return model_.body_jntnum[body] > 0 && model_.jnt_type[model_.body_jntadr[body]] == mjJNT_FREE;
  }

  void ReadBase(int root, std::optional<bool> fixed_base) {
    const bool says_nothing = file_.is_urdf() && !file_.has_world();
    const bool is_fixed = fixed_base.value_or(!HasFreeJoint(root) && !says_nothing);
    robot().has_fixed_base = is_fixed;
    if (says_nothing && !fixed_base) {
      Warn(
          "a URDF file does not say whether its first link is fixed: it is taken to be free; "
          "`--base fixed` fixes it");
    }
    // What moves against the world hangs on a link that stands for it.
    if (model_.body_jntnum[root] > 0 && !HasFreeJoint(root)) {
      robot().has_fixed_base = true;
      const Vector place(data_->xpos + 3 * root);
      AddLink(link_names_.Take("world", "world"), BallOf(1, place), PointAt(place));
      world_link_ = 0;
    }
  }

  int AddLink(std::string name, const MassPart& mass, const ShapePart& part) {
    robot::Link link;
    link.name = std::move(name);
    link.mass = mass.mass;
    link.position = ToArray(mass.center);
    link.inertia = ToInertia(mass.inertia);
    link.shape = part.shape;
    link.shape.position = ToArray(part.position - mass.center);
    const Eigen::Quaterniond& q = part.orientation;
    link.shape.orientation = {q.w(), q.x(), q.y(), q.z()};
    link.friction = part.friction;
    robot().links.push_back(std::move(link));
    shapes_.push_back(part);
    return static_cast<int>(robot().links.size()) - 1;
  }

  MassPart MassWithParts(int body) const {
    MassPart sum;
    for (int i = body; i < model_.nbody; ++i) {
      if (owners_[i] == body && Top(i) == top_) sum.Add(MassOf(model_, *data_, i));
    }
    return sum;
  }

  // The body's shapes, the largest first; where it has none a point.
  std::vector<ShapePart> ShapesFor(int body, const MassPart& mass) {
    std::vector<ShapePart> shapes = ShapesOf(model_, *data_, body);
    for (ShapePart& shape : shapes) {
      if (file_.missing().contains(shape.mesh)) {
        const ShapePart box = BoxOf(mass);
        shape.shape = box.shape;
        shape.position = box.position;
        shape.orientation = box.orientation;
        shape.volume = box.volume;
      } else if (!shape.approximated.empty()) {
        approximated_.push_back(fmt::format("{} ({})", BodyName(body), shape.approximated));
      }
    }
    std::ranges::stable_sort(shapes, std::greater(), &ShapePart::volume);
    if (shapes.empty()) {
      shapeless_.push_back(BodyName(body));
      shapes.push_back(PointAt(mass.center));
    }
    return shapes;
  }

  void AddBody(int body, bool is_root) {
    MassPart mass = MassWithParts(body);
    if (mass.mass == 0) {
      massless_.push_back(BodyName(body));
      mass = BallOf(kLeastMass, Vector(data_->xpos + 3 * body));
    }
    if (mass.mass > 0 && !IsPossible(model_, body)) {
      Warn(fmt::format("no body has the inertia of `{}`: it gets a larger one about one axis",
                       BodyName(body)));
    }
    const std::vector<ShapePart> shapes = ShapesFor(body, mass);
    const std::string name = link_names_.Take(BodyName(body), "link");
    int parent = is_root ? world_link_ : links_[owners_[model_.body_parentid[body]]];
    // What lies between several joints, and what is but a shape, takes a little of the mass.
    std::vector<MassPart> others;
    for (size_t i = 1; i < shapes.size(); ++i) {
      const double radius = std::cbrt(shapes[i].volume * 3 / (4 * std::numbers::pi));
      others.push_back(BallOf(kShare * mass.mass, shapes[i].position, radius));
    }
    MassPart own = mass;
    for (const MassPart& other : others) own.Add({-other.mass, other.center, other.inertia});
    const bool hangs = !is_root || world_link_ >= 0;
    if (hangs && model_.body_jntnum[body] > 1) {
      parent = AddBetween(body, name, parent, own);
    }
    const int link = AddLink(name, own, shapes.front());
    links_[body] = link;
    if (hangs) Attach(body, parent, link);
    for (size_t i = 1; i < shapes.size(); ++i) {
      const int other = AddLink(link_names_.Take(fmt::format("{}_{}", name, i + 1), "link"),
                                others[i - 1], shapes[i]);
      AddMount(fmt::format("{}_mount", robot().links[static_cast<size_t>(other)].name),
               robot::MountKind::kFixed, link, other);
    }
  }

  // Links between the first joints of a body that has several, each on the one before; the parent
  // of the last joint.
  int AddBetween(int body, const std::string& name, int parent, MassPart& own) {
    const int first = model_.body_jntadr[body];
    for (int i = 0; i + 1 < model_.body_jntnum[body]; ++i) {
      const MassPart share = BallOf(kShare * own.mass, own.center);
      own.Add({-share.mass, share.center, share.inertia});
      const int between = AddLink(link_names_.Take(fmt::format("{}_{}", name, "between"), "link"),
                                  share, PointAt(own.center));
      betweens_.push_back(between);
      AddJoint(first + i, parent, between);
      parent = between;
    }
    return parent;
  }

  void Attach(int body, int parent, int link) {
    const int count = model_.body_jntnum[body];
    if (count == 0) {
      AddMount(fmt::format("{}_mount", robot().links[static_cast<size_t>(link)].name),
               robot::MountKind::kFixed, parent, link);
    } else {
      AddJoint(model_.body_jntadr[body] + count - 1, parent, link);
    }
  }

  void AddMount(const std::string& name, robot::MountKind kind, int parent, int child) {
    robot().mounts.push_back(
        {.name = joint_names_.Take(name, "mount"), .kind = kind, .parent = parent, .child = child});
  }

  void AddJoint(int index, int parent, int child) {
    const std::string called = NameIn(model_, mjOBJ_JOINT, index);
    const std::string& child_name = robot().links[static_cast<size_t>(child)].name;
    const std::string name = called.empty() ? child_name + "_joint" : called;
    const int dof = model_.jnt_dofadr[index];
    const Vector anchor(data_->xanchor + 3 * index);
    const int type = model_.jnt_type[index];
    if (type == mjJNT_BALL || type == mjJNT_FREE) {
      if (type == mjJNT_FREE) Warn(fmt::format("`{}` hangs on nothing: it gets a ball", name));
      AddMount(name, robot::MountKind::kBall, parent, child);
      robot().mounts.back().anchor = ToArray(anchor);
      robot().mounts.back().damper = model_.dof_damping[dof];
      return;
    }
    robot::Joint joint;
    joint.parent = parent;
    joint.child = child;
    joint.anchor = ToArray(anchor);
    // Angles count the other way around here.
    joint.axis = ToArray((type == mjJNT_SLIDE ? 1 : -1) * Vector(data_->xaxis + 3 * index));
    const double reference = model_.qpos0[model_.jnt_qposadr[index]];
    WarnOfManyTurns(index, name);
    if (!ReadStops(model_, index, joint)) {
      Warn(fmt::format("the stops of `{}` leave it nothing to move by: it is fixed", name));
      AddMount(name, robot::MountKind::kFixed, parent, child);
      return;
    }
    joint.name = joint_names_.Take(name, "joint");
    joint.passive = PassiveForcesOf(model_, index);
    joint.gains = MotorOf(file_, model_, index, called);
    robot().joints.push_back(std::move(joint));
    described_.qpos.push_back(model_.jnt_qposadr[index]);
    described_.references.push_back(reference);
  }

  // A URDF file was looked at before, line by line.
  void WarnOfManyTurns(int index, const std::string& name) {
    constexpr double kMost = 4 * std::numbers::pi;
    const mjtNum* range = model_.jnt_range + 2 * index;
    const bool turns = model_.jnt_type[index] == mjJNT_HINGE && model_.jnt_limited[index] != 0;
    if (file_.is_urdf() || !turns || std::max(std::abs(range[0]), std::abs(range[1])) < kMost)
      return;
    Warn(
        fmt::format("joint `{}` turns from {:.4g} to {:.4g} rad: are these degrees? write rad, or "
                    "`<compiler angle=\"degree\"/>`",
                    name, range[0], range[1]));
  }

  // Frames without a shape, those above the root among them, and what the model itself calls sites.
  void AddSites(int root) {
    for (int body = top_; body < model_.nbody; ++body) {
      if (Top(body) != top_) continue;
      const int owner = body < root ? root : owners_[body];
      if (owner != body) AddSite(FrameOf(model_, *data_, body), links_[owner]);
      for (const SitePart& part : SitesOf(model_, *data_, body)) AddSite(part, links_[owner]);
    }
  }

  void AddSite(const SitePart& part, int link) {
    if (robot().sites.size() == robot::kMostSites) {
      sites_too_many_.push_back(part.name);
      return;
    }
    const Eigen::Quaterniond& q = part.orientation;
    robot().sites.push_back({.name = site_names_.Take(part.name, "site"),
                             .link = link,
                             .position = ToArray(part.position),
                             .orientation = {q.w(), q.x(), q.y(), q.z()}});
  }

  bool MayTouch(size_t a, size_t b) const {
    return (shapes_[a].contype & shapes_[b].conaffinity) != 0 ||
           (shapes_[b].contype & shapes_[a].conaffinity) != 0;
  }

  void AddExclusions() {
    const size_t count = robot().links.size();
    for (size_t a = 0; a < count; ++a) {
      for (size_t b = a + 1; b < count; ++b) {
        const bool is_between = std::ranges::count(betweens_, static_cast<int>(a)) > 0 ||
                                std::ranges::count(betweens_, static_cast<int>(b)) > 0;
        if (is_between || !MayTouch(a, b))
          robot().contact_exclusions.push_back({static_cast<int>(a), static_cast<int>(b)});
      }
    }
    for (int i = 0; i < model_.nexclude; ++i) {
      const int first = links_[owners_[model_.exclude_signature[i] >> 16]];
      const int second = links_[owners_[model_.exclude_signature[i] & 0xffff]];
      if (first >= 0 && second >= 0 && first != second)
        robot().contact_exclusions.push_back({first, second});
    }
  }

  void WarnOfRest() {
    WarnOfNames(link_names_, "links");
    WarnOfNames(joint_names_, "joints");
    WarnOfNames(site_names_, "sites");
    WarnOf(parts_, "without a shape, and so sites of the link they are fixed to");
    WarnOf(sites_too_many_, fmt::format("left out, as {} sites are the most", robot::kMostSites));
    if (!SitesOf(model_, *data_, 0).empty()) Warn("sites of the world are left out");
    WarnOf(massless_, fmt::format("without a mass, and so given {} g", 1000 * kLeastMass));
    WarnOf(shapeless_, fmt::format("without a shape that touches anything, and so given a ball of "
                                   "{} mm",
                                   2000 * kPoint));
    WarnOf(approximated_, "simpler than in the file");
    if (model_.neq > 0)
      Warn(fmt::format("{} equality constraints (loops, mimics) are left out", model_.neq));
    if (model_.ntendon > 0) Warn(fmt::format("{} tendons are left out", model_.ntendon));
    if (file_.text().find("<mimic") != std::string::npos)
      Warn("`mimic` is left out: these joints move by themselves");
    for (int geom = 0; geom < model_.ngeom; ++geom) {
      const bool is_floor = model_.geom_type[geom] == mjGEOM_PLANE;
      if (model_.geom_bodyid[geom] == 0 && !is_floor) {
        Warn("what stands around in the world is left out: robots are on flat ground");
        break;
      }
    }
  }

  void WarnOfNames(const Names& names, std::string_view kind) {
    if (names.renamed().empty()) return;
    Warn(fmt::format("{} whose names tasks cannot write have others: {}", kind,
                     fmt::join(names.renamed(), ", ")));
  }

  // Places are relative to the first link's center.
  void Recenter() {
    const robot::Vector3 base = robot().links.front().position;
    described_.base = base;
    const auto move = [&](robot::Vector3& place) {
      for (size_t i = 0; i < 3; ++i) place[i] -= base[i];
    };
    for (robot::Link& link : robot().links) move(link.position);
    for (robot::Joint& joint : robot().joints) move(joint.anchor);
    for (robot::Mount& mount : robot().mounts) move(mount.anchor);
    for (robot::Site& site : robot().sites) move(site.position);
  }

  const ModelFile& file_;
  const mjModel& model_;
  MujocoData data_;
  DescribedModel described_;
  int top_ = 0;
  int world_link_ = -1;
  std::vector<int> owners_;        // of each body: the one that it is part of
  std::vector<int> links_;         // of each body that has one
  std::vector<ShapePart> shapes_;  // of each link
  std::vector<int> betweens_;      // links
  // Names of bodies.
  std::vector<std::string> parts_, massless_, shapeless_, approximated_;
  std::vector<std::string> sites_too_many_;
  Names link_names_;
  Names joint_names_;
  Names site_names_;
};

}  // namespace

DescribedModel DescribeModel(const ModelFile& file, const mjModel& model,
                             std::optional<bool> fixed_base) {
  return Builder(file, model).Build(fixed_base);
}

}  // namespace runtime
