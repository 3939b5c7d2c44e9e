// How the viewport shows the scene.
// SPDX-License-Identifier: MIT
#include "studio/look.h"

#include <algorithm>
#include <string_view>

namespace facet::studio {
namespace {

/// Views that are sums of AOVs: those whose key begins or ends so.
struct Sum {
    std::string_view key;
    std::string_view begin;
    std::string_view end;
};
constexpr Sum sums[] = {{"diffuse", "diffuse_", ""},
                        {"specular", "specular_", ""},
                        {"direct", "", "_direct"},
                        {"indirect", "", "_indirect"}};

std::vector<View> make_views() {
    std::vector<View> out = {{"beauty", {}}};
    for (const Sum& sum : sums) {
        View view{std::string(sum.key), {}};
        for (std::size_t i = 0; i < tables::aovs.size(); ++i)
            if (tables::aovs[i].key.starts_with(sum.begin) &&
                tables::aovs[i].key.ends_with(sum.end))
                view.aovs.push_back(static_cast<tables::Aov>(i));
        if (!view.aovs.empty()) out.push_back(std::move(view));
    }
    out.push_back({"furnace", {}, true});
    for (std::size_t i = 0; i < tables::aovs.size(); ++i)
        out.push_back({std::string(tables::aovs[i].key), {static_cast<tables::Aov>(i)}});
    return out;
}

}  // namespace

const std::vector<View>& views() {
    static const std::vector<View> all = make_views();
    return all;
}

const View& view_by_key(const std::string& key) {
    const auto found =
        std::find_if(views().begin(), views().end(), [&](const View& v) { return v.key == key; });
    return found == views().end() ? views().front() : *found;
}

}  // namespace facet::studio
