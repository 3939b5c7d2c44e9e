// What became of an item.
// SPDX-License-Identifier: MIT
#include "batch/result.h"

#include "base/json.h"
#include "tables/message_json.h"

namespace facet::batch {
namespace {

Json matrix_rows(const math::Mat4& m) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) {
        Json numbers = Json::array();
        for (int column = 0; column < 4; ++column) numbers.push_back(m[column][row]);
        rows.push_back(std::move(numbers));
    }
    return rows;
}

Json shot_object(const Shot& shot) {
    Json object = {{"width", shot.size.width},
                   {"height", shot.size.height},
                   {"cx", static_cast<double>(shot.size.width) * 0.5},
                   {"cy", static_cast<double>(shot.size.height) * 0.5}};
    if (shot.ortho_height_m > 0.0) {
        object["ortho_height_m"] = shot.ortho_height_m;
    } else {
        object["fl_x"] = shot.focal_x_px;
        object["fl_y"] = shot.focal_y_px;
    }
    object["world_from_camera"] = matrix_rows(shot.world_from_camera);
    return object;
}

std::string text_at(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

Json to_json(const ItemResult& r) {
    Json object = {{"item", r.item},
                   {"output", r.output},
                   {"scene", r.scene},
                   {"sha256", r.sha256.empty() ? Json(nullptr) : Json(r.sha256)},
                   {"status", r.is_done() ? "done" : "failed"},
                   {"error", r.error ? Json(tables::message_object(*r.error)) : Json(nullptr)},
                   {"code", r.error ? base::exit_code(r.error->code) : 0},
                   {"ms",
                    {{"load", r.ms.load},
                     {"upload", r.ms.upload},
                     {"render", r.ms.render},
                     {"write", r.ms.write}}},
                   {"peak_rss", r.peak_rss},
                   {"attempts", r.attempts},
                   {"exposure", r.exposure},
                   {"input", r.input},
                   {"program", r.program}};
    for (const auto& [key, label] : r.varied) object["varied"][key] = label;
    if (!r.sides.empty()) object["sides"] = r.sides;
    for (const base::Warning& warning : r.warnings)
        object["warnings"].push_back(tables::message_object(warning));
    if (r.shot) object["camera"] = shot_object(*r.shot);
    return object;
}

std::string to_line(const ItemResult& result) { return text_of(to_json(result)); }

base::Result<Record> parse_record(std::string_view line, const base::Limits& limits) {
    auto json = base::parse_json<Json>(line, limits);
    if (!json) return tl::unexpected(json.error());
    const auto item = json->find("item");
    if (item == json->end() || !item->is_number_unsigned())
        return base::fail(
            {.code = base::ErrorCode::input_invalid, .what = "not the result of an item"});
    Record record{.item = item->get<std::size_t>(),
                  .output = text_at(*json, "output"),
                  .sha256 = text_at(*json, "sha256"),
                  .input = text_at(*json, "input"),
                  .program = text_at(*json, "program"),
                  .is_done = text_at(*json, "status") == "done"};
    if (const auto sides = json->find("sides"); sides != json->end() && sides->is_array())
        for (const Json& side : *sides)
            if (side.is_string()) record.sides.push_back(side.get<std::string>());
    record.json = std::move(*json);
    return record;
}

}  // namespace facet::batch
