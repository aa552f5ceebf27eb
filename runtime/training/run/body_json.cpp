#include "runtime/training/run/body_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "plugins/robot/kind_names.h"

namespace runtime {
namespace {

std::optional<robot::ShapeKind> ShapeKindOf(const std::string& name) {
  using enum robot::ShapeKind;
  for (const auto kind : {kBox, kCapsule, kCylinder, kSphere, kConvex}) {
    if (name == NameOf(kind)) return kind;
  }
  return std::nullopt;
}

bool IsLength(double value) {
  constexpr double kLongest = 1000;  // [m]: of no robot's link
  return 0 <= value && value <= kLongest;
}

bool AreCorners(const std::vector<robot::Vector3>& points) {
  const auto is_near = [](const robot::Vector3& point) {
    return std::ranges::all_of(point, [](double value) { return IsLength(std::abs(value)); });
  };
  return std::ranges::all_of(points, is_near) && robot::IsSolid(points);
}

// Throws json's exceptions where a value is missing or of another type.
std::optional<robot::Link> ParseLink(const nlohmann::json& json) {
  robot::Link link;
  link.name = json.at("name");
  const std::optional<robot::ShapeKind> kind = ShapeKindOf(json.at("shape"));
  if (!kind) return std::nullopt;
  link.shape.kind = *kind;
  link.shape.size = json.at("size");
  link.shape.radius = json.at("radius");
  link.shape.length = json.at("length");
  link.shape.axis = json.at("axis");
  if (json.contains("position")) link.shape.position = json.at("position");
  if (json.contains("orientation")) link.shape.orientation = json.at("orientation");
  if (json.contains("points")) link.shape.points = json.at("points");
  const auto is_place = [](double value) { return IsLength(std::abs(value)); };
  const bool is_sound = std::ranges::all_of(link.shape.size, IsLength) &&
                        std::ranges::all_of(link.shape.position, is_place) &&
                        std::ranges::all_of(link.shape.orientation, is_place) &&
                        IsLength(link.shape.radius) && IsLength(link.shape.length) &&
                        0 <= link.shape.axis && link.shape.axis <= 2 &&
                        (*kind != robot::ShapeKind::kConvex || AreCorners(link.shape.points));
  return is_sound ? std::optional(std::move(link)) : std::nullopt;
}

nlohmann::ordered_json PartJson(const std::string& name, const robot::LinkShape& shape) {
  nlohmann::ordered_json json = {{"name", name},           {"shape", NameOf(shape.kind)},
                                 {"size", shape.size},     {"radius", shape.radius},
                                 {"length", shape.length}, {"axis", shape.axis}};
  if (shape.IsMoved()) {
    json["position"] = shape.position;
    json["orientation"] = shape.orientation;
  }
  if (!shape.points.empty()) {
    json["points"] = shape.points;
  }
  return json;
}

nlohmann::ordered_json JointJson(const robot::RobotDescription& robot, const robot::Joint& joint) {
  nlohmann::ordered_json json = {{"name", joint.name},
                                 {"kind", NameOf(joint.kind)},
                                 {"parent", joint.parent},
                                 {"axis", joint.axis}};
  if (joint.HasStops()) json["stops"] = {joint.low, joint.high};
  if (joint.kind == robot::JointKind::kSlider) {
    const robot::Vector3& from = robot.links[static_cast<size_t>(joint.parent)].position;
    robot::Vector3 offset = robot.links[static_cast<size_t>(joint.child)].position;
    for (size_t i = 0; i < offset.size(); ++i) offset[i] -= from[i];
    json["radius"] = joint.radius;
    json["offset"] = offset;
  }
  return json;
}

}  // namespace

std::string BodyJson(const robot::RobotDescription& robot, const world::WorldDescription* world) {
  nlohmann::ordered_json parts = nlohmann::ordered_json::array();
  for (const robot::Link& link : robot.links) {
    parts.push_back(PartJson(link.name, link.shape));
    parts.back()["mass"] = link.mass;
  }
  for (const robot::Joint& joint : robot.joints) {
    parts[static_cast<size_t>(joint.child)]["joint"] = JointJson(robot, joint);
  }
  if (world != nullptr) {
    for (const world::Thing& thing : world->things) {
      parts.push_back(PartJson(thing.name, thing.shape));
      parts.back()["thing"] = true;
    }
  }
  return parts.dump();
}

std::optional<RecordedBody> ParseBody(const std::string& json) {
  const nlohmann::json list = nlohmann::json::parse(json, nullptr, false);
  if (!list.is_array()) return std::nullopt;
  RecordedBody body;
  try {
    for (const nlohmann::json& each : list) {
      std::optional<robot::Link> part = ParseLink(each);
      const bool is_thing = each.value("thing", false);
      if (!part || (!is_thing && body.things > 0)) return std::nullopt;
      body.parts.push_back(*std::move(part));
      if (is_thing) ++body.things;
    }
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
  return body;
}

}  // namespace runtime
