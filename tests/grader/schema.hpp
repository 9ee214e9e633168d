#pragma once
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace rigor::grader {

/// What of JSON Schema our schemas use. Returns where and why `value` breaks the schema; "" when it keeps it.
inline std::string breaks(const nlohmann::json& schema, const nlohmann::json& value, const std::string& where = "$") {
  const auto is = [&](const std::string& type) {
    return type == "object" ? value.is_object() : type == "array" ? value.is_array() : type == "string" ? value.is_string() : type == "null" ? value.is_null()
           : type == "boolean" ? value.is_boolean() : type == "integer" ? value.is_number_integer() : type == "number" && value.is_number();
  };
  if (schema.contains("type")) {
    const auto& type = schema["type"];
    bool one = false;
    if (type.is_string()) one = is(type);
    else for (const auto& t : type) one = one || is(t);
    if (!one) return where + " is " + value.dump() + ", not of type " + type.dump();
  }
  if (schema.contains("const") && value != schema["const"]) return where + " is " + value.dump() + ", not " + schema["const"].dump();
  if (schema.contains("enum") && std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end()) return where + ": " + value.dump() + " is none of " + schema["enum"].dump();
  if (schema.contains("minimum") && value.is_number() && value < schema["minimum"]) return where + " is " + value.dump() + ", too small";
  if (schema.contains("oneOf")) {
    int fits = 0;
    std::string why;
    for (const auto& each : schema["oneOf"]) {
      const std::string broken = breaks(each, value, where);
      fits += broken.empty();
      why = broken.empty() ? why : broken;
    }
    if (fits != 1) return where + " fits " + std::to_string(fits) + " of oneOf: " + why;
  }
  if (value.is_object()) {
    for (const auto& key : schema.value("required", nlohmann::json::array()))
      if (!value.contains(key.get<std::string>())) return where + " lacks " + key.dump();
    const auto properties = schema.value("properties", nlohmann::json::object());
    for (const auto& [key, member] : value.items()) {
      if (!properties.contains(key)) {
        if (schema.value("additionalProperties", true)) continue;
        return where + " has an unknown key " + key;
      }
      if (const std::string broken = breaks(properties[key], member, where + "." + key); !broken.empty()) return broken;
    }
  }
  if (value.is_array() && schema.contains("items"))
    for (std::size_t i = 0; i < value.size(); ++i)
      if (const std::string broken = breaks(schema["items"], value[i], where + "[" + std::to_string(i) + "]"); !broken.empty()) return broken;
  return "";
}

}  // namespace rigor::grader
