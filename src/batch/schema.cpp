// The form of a job file as a JSON Schema.
// SPDX-License-Identifier: MIT
#include "batch/schema.h"

#include "base/text.h"
#include "batch/job_file.h"
#include "tables/settings_text.h"

namespace facet::batch {
namespace {

using tables::Setting;
using tables::Settings;

Json any_of(std::initializer_list<Json> parts) {
    Json out = Json::object();
    for (const Json& part : parts) out["anyOf"].push_back(part);
    return out;
}
Json array_of(const Json& items) { return {{"type", "array"}, {"items", items}}; }
Json tuple_of(const Json& items, int count) {
    return {{"type", "array"}, {"items", items}, {"minItems", count}, {"maxItems", count}};
}
const Json any_text = {{"type", "string"}};
const Json any_number = {{"type", "number"}};

Json whole(double low, double high) {
    return {{"type", "integer"}, {"minimum", low}, {"maximum", high}};
}

/// One value of a setting.
struct ValueOf {
    const Setting& row;

    Json operator()(tables::Extent Settings::*) const {
        return any_of(
            {{{"type", "string"}, {"pattern", "^[0-9]+x[0-9]+$"}}, tuple_of(whole(1, 16384), 2)});
    }
    Json operator()(tables::Text Settings::*) const {
        const auto words = tables::choices(row);
        if (words.empty()) return {{"type", {"string", "number"}}};
        Json names = words;
        for (const std::string& word : words)
            if (const auto code = base::parse_integer(word)) names.push_back(*code);
        return {{"enum", names}};
    }
    Json real() const {
        return any_of(
            {{{"type", "number"}, {"minimum", row.range.low}, {"maximum", row.range.high}},
             {{"type", "string"}, {"pattern", "^[-+0-9.eE]+$"}}});
    }
    Json operator()(tables::Number Settings::*) const { return real(); }
    Json operator()(tables::OptionalNumber Settings::*) const { return real(); }
    Json operator()(tables::Count Settings::*) const {
        return any_of(
            {whole(row.range.low, row.range.high), {{"type", "string"}, {"pattern", "^[0-9]+$"}}});
    }
    Json operator()(tables::Flag Settings::*) const {
        return {{"enum", {true, false, 0, 1, "0", "1"}}};
    }
    Json operator()(tables::List Settings::*) const {
        return any_of({any_text, array_of(any_text)});
    }
};

Json random_schema() {
    return {{"type", "object"},
            {"required", {"random"}},
            {"additionalProperties", false},
            {"properties",
             {{"random", any_of({tuple_of(any_number, 2),
                                 tuple_of(tuple_of(any_number, 3), 2),
                                 {{"type", "array"}, {"items", any_text}, {"minItems", 1}}})},
              {"count", whole(1, 1e6)},
              {"seed", whole(0, 9007199254740992.0)}}},
            {"description",
             "drawn within [low, high], between two vectors, or from a list of "
             "texts: count values that multiply, or one for each item"}};
}

Json sphere_schema() {
    return {{"type", "object"},
            {"required", {"sphere"}},
            {"additionalProperties", false},
            {"properties",
             {{"sphere", whole(1, 1e6)},
              {"elevation", tuple_of(any_number, 2)},
              {"distance", {{"type", "number"}, {"exclusiveMinimum", 0}}},
              {"target", tuple_of(any_number, 3)}}},
            {"description", "that many cameras, spread evenly around the model"}};
}

const Json random_reference = {{"$ref", "#/definitions/random"}};

Json setting_schema(const Setting& row) {
    const Json value = std::visit(ValueOf{row}, row.field);
    Json schema = any_of({value, array_of(value), random_reference});
    if (row.key == "camera") schema["anyOf"].push_back({{"$ref", "#/definitions/sphere"}});
    if (row.key == "set") schema = {{"$ref", "#/definitions/set"}};
    schema["description"] = std::string(row.help);
    return schema;
}

Json set_schema() {
    const Json vector = tuple_of(any_number, 3);
    const Json value = any_of({{{"type", {"number", "string", "boolean"}}}, vector});
    const Json paths = {
        {"type", "object"},
        {"additionalProperties", any_of({value, array_of(value), random_reference})}};
    const Json fixed = {{"type", "object"}, {"additionalProperties", value}};
    return any_of(
        {paths, any_text, array_of(any_text), array_of(array_of(any_text)), array_of(fixed)});
}

Json members() {
    Json properties = {
        {"scene",
         {{"anyOf", {any_text, array_of(any_text)}},
          {"description",
           "files relative to the job file, patterns (*, ?, [a-z], **), or "
           "builtin:NAME"}}},
        {"output", {{"$ref", "#/properties/output"}}},
        {"frames",
         {{"type", "object"},
          {"additionalProperties", false},
          {"properties",
           {{"orbit", whole(1, 100000)},
            {"animation", {{"type", {"string", "integer"}}}},
            {"fps", {{"type", "number"}, {"exclusiveMinimum", 0}, {"maximum", 1000}}}}},
          {"oneOf", {{{"required", {"orbit"}}}, {{"required", {"animation"}}}}},
          {"description",
           "orbit: a turntable of that many frames; animation: that one of the "
           "file, fps frames a second (24)"}}}};
    for (const Setting& row : tables::settings)
        if (is_job_key(row)) properties[std::string(row.key)] = setting_schema(row);
    return properties;
}

}  // namespace

Json job_schema() {
    const Json item = {{"$ref", "#/definitions/item"}};
    const auto with = [](const char* key) { return Json{{"required", {key}}}; };
    const auto in_defaults = [&](const char* key) {
        return Json{{"required", {"defaults"}}, {"properties", {{"defaults", with(key)}}}};
    };
    const auto in_items = [&](const char* key) {
        return Json{{"properties", {{"items", {{"items", with(key)}}}}}};
    };
    return {{"$schema", "http://json-schema.org/draft-07/schema#"},
            {"title", "A job of facet batch"},
            {"type", "object"},
            {"required", {"facet", "items"}},
            {"additionalProperties", false},
            {"properties",
             {{"$schema", any_text},
              {"facet", {{"const", 1}, {"description", "version of this form"}}},
              {"output",
               {{"type", "string"},
                {"minLength", 1},
                {"description",
                 "the files: out/{scene}-{index:05}.png; placeholders {scene} {folder} "
                 "{index} {camera} {frame} and every key; {key:5} pads with zeros"}}},
              {"defaults", item},
              {"items", {{"type", "array"}, {"items", item}, {"minItems", 1}}},
              {"data_set",
               {{"type", "string"},
                {"description",
                 "folder of manifest.jsonl, transforms.json and "
                 "names.json"}}}}},
            {"allOf",
             {any_of({in_defaults("scene"), in_items("scene")}),
              any_of({with("output"), in_defaults("output"), in_items("output")})}},
            {"definitions",
             {{"item",
               {{"type", "object"}, {"additionalProperties", false}, {"properties", members()}}},
              {"set", set_schema()},
              {"random", random_schema()},
              {"sphere", sphere_schema()}}}};
}

}  // namespace facet::batch
