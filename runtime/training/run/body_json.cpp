#include "runtime/training/run/body_json.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

namespace runtime {
namespace {

const char* ShapeName(robot::ShapeKind kind) {
  switch (kind) {
    case robot::ShapeKind::kBox:
      return "box";
    case robot::ShapeKind::kCapsule:
      return "capsule";
    case robot::ShapeKind::kCylinder:
      return "cylinder";
    case robot::ShapeKind::kSphere:
      return "sphere";
  }
  std::abort();
}

std::optional<robot::ShapeKind> ShapeKindOf(const std::string& name) {
  using enum robot::ShapeKind;
  for (const auto kind : {kBox, kCapsule, kCylinder, kSphere}) {
    if (name == ShapeName(kind)) return kind;
  }
  return std::nullopt;
}

bool IsLength(double value) {
  constexpr double kLongest = 1000;  // [m]: of no robot's link
  return 0 <= value && value <= kLongest;
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
  const auto is_place = [](double value) { return IsLength(std::abs(value)); };
  const bool is_sound = std::ranges::all_of(link.shape.size, IsLength) &&
                        std::ranges::all_of(link.shape.position, is_place) &&
                        std::ranges::all_of(link.shape.orientation, is_place) &&
                        IsLength(link.shape.radius) && IsLength(link.shape.length) &&
                        0 <= link.shape.axis && link.shape.axis <= 2;
  return is_sound ? std::optional(std::move(link)) : std::nullopt;
}

}  // namespace

std::string BodyJson(const robot::RobotDescription& robot) {
  nlohmann::ordered_json links = nlohmann::ordered_json::array();
  for (const robot::Link& link : robot.links) {
    nlohmann::ordered_json json = {
        {"name", link.name},           {"shape", ShapeName(link.shape.kind)},
        {"size", link.shape.size},     {"radius", link.shape.radius},
        {"length", link.shape.length}, {"axis", link.shape.axis}};
    if (link.shape.IsMoved()) {
      json["position"] = link.shape.position;
      json["orientation"] = link.shape.orientation;
    }
    links.push_back(std::move(json));
  }
  return links.dump();
}

std::optional<std::vector<robot::Link>> ParseBody(const std::string& json) {
  const nlohmann::json list = nlohmann::json::parse(json, nullptr, false);
  if (!list.is_array()) return std::nullopt;
  std::vector<robot::Link> links;
  try {
    for (const nlohmann::json& each : list) {
      std::optional<robot::Link> link = ParseLink(each);
      if (!link) return std::nullopt;
      links.push_back(*std::move(link));
    }
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
  return links;
}

}  // namespace runtime
