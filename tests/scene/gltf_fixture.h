// Small glTF documents made in memory, for the tests of the importer.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/thread_pool.h"
#include "scene/load.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace facet::test {

using Json = nlohmann::json;

inline std::string base64(std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group =
                group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63U];
    }
    return out;
}

/// A document with one buffer that grows with each accessor.
struct Document {
    Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}};
    std::string bytes;
    std::size_t placeholder_bytes = 0;  ///< of a second buffer, which has none

    /// A buffer view over `data`; its index.
    std::size_t view(std::string_view data) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}});
        bytes += data;
        return json["bufferViews"].size() - 1;
    }
    /// An accessor of `values` as they are in memory; its index.
    template <class T>
    std::size_t accessor(const char* type, int component, std::size_t count,
                         const std::vector<T>& values) {
        const std::size_t index =
            view({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
        json["accessors"].push_back({{"bufferView", index},
                                     {"componentType", component},
                                     {"count", count},
                                     {"type", type}});
        return json["accessors"].size() - 1;
    }
    std::size_t floats(const char* type, std::size_t components, const std::vector<float>& values) {
        return accessor(type, 5126, values.size() / components, values);
    }
    /// Positions with their bounds, as glTF wants them.
    std::size_t positions(const std::vector<float>& values) {
        const std::size_t index = floats("VEC3", 3, values);
        std::vector<float> low(values.begin(), values.begin() + 3);
        std::vector<float> high = low;
        for (std::size_t i = 0; i < values.size(); ++i) {
            low[i % 3] = std::min(low[i % 3], values[i]);
            high[i % 3] = std::max(high[i % 3], values[i]);
        }
        json["accessors"][index]["min"] = low;
        json["accessors"][index]["max"] = high;
        return index;
    }
    [[nodiscard]] Json finished() const {
        Json out = json;
        if (!bytes.empty())
            out["buffers"] = {{{"byteLength", bytes.size()},
                               {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
        if (placeholder_bytes > 0) out["buffers"].push_back({{"byteLength", placeholder_bytes}});
        return out;
    }
    [[nodiscard]] std::string text() const { return finished().dump(); }
    [[nodiscard]] std::string glb() const {
        Json out = json;
        if (!bytes.empty()) out["buffers"] = {{{"byteLength", bytes.size()}}};
        if (placeholder_bytes > 0) out["buffers"].push_back({{"byteLength", placeholder_bytes}});
        std::string text = out.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string bin = bytes;
        bin.resize((bin.size() + 3) / 4 * 4, '\0');
        std::string file = "glTF";
        const auto add_u32 = [&](std::size_t value) {
            for (unsigned shift = 0; shift < 32; shift += 8)
                file += static_cast<char>(value >> shift & 0xFFU);
        };
        add_u32(2);
        add_u32(12 + 8 + text.size() + (bin.empty() ? 0 : 8 + bin.size()));
        add_u32(text.size());
        file += "JSON" + text;
        if (bin.empty()) return file;
        add_u32(bin.size());
        return file + std::string("BIN\0", 4) + bin;
    }
};

/// One triangle in the plane z = 0, counter-clockwise seen from +z, with indices; mesh 0 on node 0.
inline Document triangle() {
    Document d;
    const std::size_t position = d.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const std::size_t index = d.accessor<std::uint16_t>("SCALAR", 5123, 3, {0, 1, 2});
    d.json["meshes"] = {
        {{"primitives", {{{"attributes", {{"POSITION", position}}}, {"indices", index}}}}}};
    d.json["nodes"] = {{{"mesh", 0}, {"name", "Node"}}};
    return d;
}
inline Json& primitive(Document& d) { return d.json["meshes"][0]["primitives"][0]; }

inline base::Result<scene::Loaded> load_text(const std::string& text,
                                             const scene::LoadOptions& options = {},
                                             const base::Limits& limits = {}) {
    base::ThreadPool pool(1);
    return scene::load_bytes(std::as_bytes(std::span(text.data(), text.size())), "test.gltf",
                             options, limits, pool);
}
inline base::Result<scene::Loaded> load_document(const Document& d,
                                                 const scene::LoadOptions& options = {},
                                                 const base::Limits& limits = {}) {
    return load_text(d.text(), options, limits);
}
/// An empty scene, and a failed test, where the document does not load.
inline scene::Loaded loaded_or_fail(const Document& d, const scene::LoadOptions& options = {}) {
    auto loaded = load_document(d, options);
    EXPECT_TRUE(loaded.has_value()) << base::to_line(loaded.error());
    return loaded ? std::move(*loaded) : scene::Loaded{};
}

}  // namespace facet::test
