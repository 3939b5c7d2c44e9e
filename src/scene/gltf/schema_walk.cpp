// The walk that holds a document to the tables of shapes.
// SPDX-License-Identifier: MIT
#include "scene/gltf/schema.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace facet::scene::gltf {
namespace {

struct Walk {
    const Json& root;
    Problems& problems;
    std::set<std::string, std::less<>> declared;  ///< extensionsUsed
    std::map<std::string_view, std::vector<bool>>
        referenced;  ///< by array, for objects nobody uses

    void object(const Json& value, const ObjectShape& shape, const Pointer& at);
    void property(const Json& value, const Rule& rule, const Pointer& at);
    void element(const Json& value, const Rule& rule, const Pointer& at);
    void array(const Json& value, const Rule& rule, const Pointer& at);
    void reference(const Json& value, const Rule& rule, const Pointer& at);
    void index_map(const Json& value, const Rule& rule, const Pointer& at);
    void extensions(const Json& value, const ObjectShape& shape, const Pointer& at);
    void extension(const std::string& name, const Json& value, const ObjectShape& shape,
                   const Pointer& at);
    bool matches(const Json& value, Kind kind, const Pointer& at, bool is_element);
};

bool Walk::matches(const Json& value, Kind kind, const Pointer& at, bool is_element) {
    if (has_kind(value, kind)) return true;
    problems.error(is_element ? "ARRAY_TYPE_MISMATCH" : "TYPE_MISMATCH", at.text(),
                   fmt::format("not of type {}", kind_name(kind)), brief(value));
    return false;
}

void Walk::reference(const Json& value, const Rule& rule, const Pointer& at) {
    const auto index = as_unsigned(value);
    if (!index) {
        problems.error("VALUE_NOT_IN_RANGE", at.text(), "index is negative", brief(value));
        return;
    }
    const Json* const target = find_path(root, rule.refers_to);
    // An extension that is not there at all is told where it is used, once.
    if (target == nullptr && rule.refers_to.starts_with("extensions/") &&
        find_path(root, rule.refers_to.substr(0, rule.refers_to.rfind('/'))) == nullptr)
        return;
    const std::size_t count = target != nullptr && target->is_array() ? target->size() : 0;
    if (*index >= count)
        problems.error("UNRESOLVED_REFERENCE", at.text(),
                       fmt::format("no such element of {}", rule.refers_to),
                       fmt::format("{}, but there are {}", *index, count));
    else {
        std::vector<bool>& marks = referenced[rule.refers_to];
        marks.resize(count);
        marks[*index] = true;
    }
}

/// One value of the right kind against range, list and reference.
void Walk::element(const Json& value, const Rule& rule, const Pointer& at) {
    if (!rule.refers_to.empty() && value.is_number_integer()) return reference(value, rule, at);
    if (!rule.words.empty()) {
        const std::string word = value.is_string() ? value.get<std::string>() : value.dump();
        if (!is_listed(rule.words, word))
            problems.note(Severity::warning, "VALUE_NOT_IN_LIST", at.text(), "not a known value",
                          fmt::format("{}, known: {}", word.substr(0, 60), rule.words));
    }
    if (!value.is_number()) return;
    const double number = value.get<double>();
    const bool is_low = rule.excludes_low ? number <= rule.low : number < rule.low;
    const bool is_high = rule.excludes_high ? number >= rule.high : number > rule.high;
    if (is_low || is_high || !std::isfinite(number))
        problems.error("VALUE_NOT_IN_RANGE", at.text(), "out of range",
                       fmt::format("{}, range {}{} to {}", number,
                                   rule.excludes_low ? "above " : "", rule.low, rule.high));
}

void Walk::array(const Json& value, const Rule& rule, const Pointer& at) {
    if (value.empty()) {
        problems.error("EMPTY_ENTITY", at.text(), "empty array");
        return;
    }
    if (!rule.lengths.empty() && !is_listed(rule.lengths, std::to_string(value.size())))
        problems.error("ARRAY_LENGTH_NOT_IN_LIST", at.text(), "wrong number of elements",
                       fmt::format("{}, not {}", value.size(), rule.lengths));
    std::set<std::string> seen;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const Pointer here = at / i;
        // The validator tells of a list's wrong element at the list, except in the document's own
        // lists.
        const Kind kind = element_kind(rule.kind);
        const bool is_told_here =
            at.depth() < 2 || !(kind == Kind::object || kind == Kind::index_map);
        if (!matches(value[i], kind, is_told_here ? here : at, at.depth() > 1)) continue;
        if (rule.kind == Kind::objects)
            object(value[i], *rule.shape, here);
        else if (rule.kind == Kind::index_maps)
            index_map(value[i], rule, here);
        else
            element(value[i], rule, here);
        if (rule.is_unique &&
            !seen.insert(value[i].dump(-1, ' ', false, Json::error_handler_t::replace)).second)
            problems.error("DUPLICATE_ELEMENTS", here.text(), "element twice", brief(value[i]));
    }
}

void Walk::index_map(const Json& value, const Rule& rule, const Pointer& at) {
    if (value.empty()) problems.error("EMPTY_ENTITY", at.text(), "empty object");
    for (const auto& [name, index] : value.items()) {
        const Pointer here = at / std::string_view(name);
        if (matches(index, Kind::integer, here, false)) reference(index, rule, here);
    }
}

void Walk::property(const Json& value, const Rule& rule, const Pointer& at) {
    if (!matches(value, rule.kind, at, false)) return;
    switch (rule.kind) {
        case Kind::object:
            return object(value, *rule.shape, at);
        case Kind::index_map:
            return index_map(value, rule, at);
        case Kind::objects:
        case Kind::integers:
        case Kind::numbers:
        case Kind::strings:
        case Kind::index_maps:
            return array(value, rule, at);
        default:
            return element(value, rule, at);
    }
}

void Walk::extension(const std::string& name, const Json& value, const ObjectShape& shape,
                     const Pointer& at) {
    if (!declared.contains(name)) {
        problems.error("UNDECLARED_EXTENSION", at.text(),
                       "extension is not declared in extensionsUsed", name);
        return;
    }
    if (!matches(value, Kind::object, at, false)) return;
    bool is_known = false;
    for (const ExtensionRule& rule : extension_rules()) {
        if (rule.name != name) continue;
        is_known = true;
        if (rule.host != shape.name) continue;
        if (rule.shape != nullptr) object(value, *rule.shape, at);
        return;
    }
    if (is_known)
        problems.error("UNEXPECTED_EXTENSION_OBJECT", at.text(), "extension is not for this object",
                       name);
}

void Walk::extensions(const Json& value, const ObjectShape& shape, const Pointer& at) {
    if (!matches(value, Kind::object, at, false)) return;
    for (const auto& [name, content] : value.items())
        extension(name, content, shape, at / std::string_view(name));
    if (shape.name != "material" || value.size() < 2) return;
    const bool is_unlit = value.contains("KHR_materials_unlit");
    if (!is_unlit && !value.contains("KHR_materials_pbrSpecularGlossiness")) return;
    std::string names;
    for (const auto& [name, content] : value.items()) names += (names.empty() ? "" : ", ") + name;
    problems.note(Severity::warning, "MULTIPLE_EXTENSIONS", at.text(),
                  is_unlit ? "extensions that exclude each other; an unlit surface shows base "
                             "color and emission alone"
                           : "extensions that exclude each other; specular and glossiness stand in "
                             "for ior and specular, the others are drawn over them",
                  names);
}

const Rule* find_rule(const ObjectShape& shape, std::string_view name) {
    for (const Rule& rule : shape.rules)
        if (rule.name == name) return &rule;
    return nullptr;
}

void Walk::object(const Json& value, const ObjectShape& shape, const Pointer& at) {
    for (const auto& [name, content] : value.items()) {
        const Pointer here = at / std::string_view(name);
        if (const Rule* const rule = find_rule(shape, name)) {
            property(content, *rule, here);
            if (!rule->needs.empty() && find(value, rule->needs) == nullptr)
                problems.error("UNSATISFIED_DEPENDENCY", here.text(),
                               fmt::format("'{}' must be defined as well", rule->needs));
        } else if (name == "extensions") {
            extensions(content, shape, here);
        } else if (name == "extras") {
            if (!content.is_object())
                problems.note(Severity::information, "NON_OBJECT_EXTRAS", here.text(),
                              "extras should be an object");
        } else if (name == "name") {
            matches(content, Kind::string, here, false);
        } else if (shape.is_closed) {
            problems.note(Severity::warning, "UNEXPECTED_PROPERTY", here.text(),
                          "unexpected property");
        }
    }
    for (const Rule& rule : shape.rules)
        if (rule.is_required && find(value, rule.name) == nullptr)
            problems.error("UNDEFINED_PROPERTY", at.text(),
                           fmt::format("property '{}' must be defined", rule.name));
}

void note_unused(Walk& walk) {
    for (const std::string_view name :
         {"accessors", "buffers", "bufferViews", "cameras", "images", "materials", "meshes",
          "nodes", "samplers", "skins", "textures"})
        for (std::size_t i = 0; i < count_at(walk.root, name); ++i)
            if (walk.referenced[name].empty() || !walk.referenced[name][i])
                walk.problems.note(Severity::information, "UNUSED_OBJECT", pointer_text(name, i),
                                   "nothing uses this object");
}

}  // namespace

void check_schema(const Json& json, Problems& problems) {
    Walk walk{.root = json, .problems = problems, .declared = {}, .referenced = {}};
    for (std::size_t i = 0; i < count_at(json, "extensionsUsed"); ++i)
        if (const Json& name = *element_at(json, "extensionsUsed", i); name.is_string())
            walk.declared.insert(name.get<std::string>());
    walk.object(json, document_shape(), Pointer());
    note_unused(walk);
}

}  // namespace facet::scene::gltf
