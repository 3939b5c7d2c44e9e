// An explanation as a tree of lines.
// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "explain/told.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <map>

namespace facet::explain {
namespace {

using frame::ExplainedPixel;
using frame::ExplainedPoint;
using shared::ExplainedSurface;
using tables::TextureSlot;

struct Node {
    std::string label;
    std::string value;
    std::vector<Node> children;
    Node& add(std::string name, std::string text = {}) {
        return children.emplace_back(Node{std::move(name), std::move(text), {}});
    }
};

/// Columns that UTF-8 text takes; its letters are all of width one here.
std::size_t width_of(const std::string& text) {
    std::size_t count = 0;
    for (const char c : text) count += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
    return count;
}

void print(const Node& node, const std::string& before, std::string& out) {
    for (std::size_t i = 0; i < node.children.size(); ++i) {
        const Node& child = node.children[i];
        const bool is_last = i + 1 == node.children.size();
        const std::string head = before + (is_last ? "└─ " : "├─ ") + child.label;
        constexpr std::size_t column = 34;
        const std::size_t used = width_of(head);
        out += head;
        if (!child.value.empty())
            out += std::string(used + 2 < column ? column - used : 2, ' ') + child.value;
        out += "\n";
        print(child, before + (is_last ? "   " : "│  "), out);
    }
}

std::string number(double value) { return fmt::format("{:.4g}", value == 0.0 ? 0.0 : value); }
std::string numbers(const DVec3& v) { return number(v.x) + " " + number(v.y) + " " + number(v.z); }
std::string numbers(const math::Vec4& v) { return numbers(DVec3(v)); }
std::string numbers(const math::Vec3& v) { return numbers(DVec3(v)); }

class Teller {
public:
    Teller(const Explained& explained, const base::Texts& texts)
        : explained_(explained), texts_(texts) {}

    void tell(const Pixel& pixel, Node& root) const {
        const ExplainedPixel& sample = pixel.samples[pixel.shown];
        if (pixel.samples.size() > 1)
            root.add(t("sample"),
                     fmt::format("{} / {}  ({:+.3f} {:+.3f} px)", pixel.shown + 1,
                                 pixel.samples.size(), sample.jitter_px.x, sample.jitter_px.y));
        if (sample.opaque)
            tell_point(*sample.opaque, root.add(t("surface"), name_of(*sample.opaque)));
        if (sample.background_nit)
            root.add(t("background"), numbers(*sample.background_nit) + " nit");
        else if (!sample.opaque)
            root.add(t("background"), t("nothing"));
        for (const ExplainedPoint& layer : sample.blended) {
            Node& node = root.add(t("over_it"), name_of(layer));
            node.add(t("opacity"), number(static_cast<double>(layer.surface.base_color.w)));
            tell_point(layer, node);
        }
        if (sample.vignetting < 1.0F)
            root.add(t("vignetting"),
                     fmt::format("× {}", number(static_cast<double>(sample.vignetting))));
        if (pixel.samples.size() > 1) tell_samples(pixel, root);
        Node& sum = root.add(t("sum"), numbers(pixel.sum) + " nit");
        if (pixel.alpha < 1.0) sum.add(t("coverage"), number(pixel.alpha));
        root.add(t("exposure"),
                 fmt::format("× {}{} = {}", number(explained_.exposure),
                             explained_.is_exposure_automatic ? " (" + t("automatic") + ")" : "",
                             numbers(pixel.sum * explained_.exposure)));
        if (explained_.white_balance_k)
            root.add(t("white_balance"), fmt::format("{} K", *explained_.white_balance_k));
        std::string code;
        for (std::size_t c = 0; c < (pixel.alpha < 1.0 ? 4U : 3U); ++c)
            code += (c == 0 ? "" : " ") + fmt::format("{}", pixel.code[c]);
        root.add(t("tonemap"), fmt::format("{}, {}, {} bit: {}", explained_.tonemap, shown_gamut(),
                                           explained_.bits, code));
    }

private:
    [[nodiscard]] std::string shown_gamut() const {
        return explained_.gamut == "srgb" ? "sRGB" : explained_.gamut;
    }
    [[nodiscard]] std::string t(const char* key) const {
        return texts_(fmt::format("explain.{}", key));
    }

    [[nodiscard]] std::string name_of(const ExplainedPoint& point) const {
        return fmt::format("{}, {} {}",
                           base::escaped(object_name(explained_.scene, point.surface.ids.x)),
                           t("material"), base::escaped(material_of(point).name));
    }
    [[nodiscard]] const scene::Material& material_of(const ExplainedPoint& point) const {
        return explained_.scene.materials[point.surface.ids.y - 1];
    }

    /// "0.8 0.2 0.1 × gold_base 0.5 0.5 0.5".
    [[nodiscard]] std::string factor(const scene::Material& material, TextureSlot slot,
                                     const std::string& value, const std::string& texel) const {
        const auto& texture = material.texture(slot);
        if (!texture) return fmt::format("{} {}", t("factor"), value);
        return fmt::format("{} {} × {} {}", t("factor"), value,
                           base::escaped(explained_.scene.images[texture->image.index].name, 40),
                           texel);
    }

    void tell_material(const ExplainedPoint& point, Node& node) const {
        const ExplainedSurface& s = point.surface;
        const scene::Material& material = material_of(point);
        const tables::MaterialValues& v = material.values;
        const auto one = [](float x) { return number(static_cast<double>(x)); };
        const bool has_vertex_color = s.vertex_color != math::Vec4(1.0F);
        node.add(t("base_color"),
                 fmt::format("{}   = {}{}", numbers(s.base_color),
                             factor(material, TextureSlot::base_color_texture,
                                    numbers(v.base_color), numbers(s.base_texel)),
                             has_vertex_color ? fmt::format(" × {} {}", t("vertex_color"),
                                                            numbers(s.vertex_color))
                                              : ""));
        if (s.ids.z == 0) {
            node.add(t("metallic"),
                     fmt::format("{}   = {}", one(s.numbers.x),
                                 factor(material, TextureSlot::metallic_roughness_texture,
                                        one(v.metallic), one(s.orm_texel.z))));
            Node& rough =
                node.add(t("roughness"),
                         fmt::format("{}   = {}", one(s.numbers.y),
                                     factor(material, TextureSlot::metallic_roughness_texture,
                                            one(v.roughness), one(s.orm_texel.y))));
            if (s.normal_texel.w > 0.0F)
                rough.add(t("bumps"), fmt::format("r = (r⁴ + α²)^¼, α = {} × {}",
                                                  one(s.normal_texel.w), one(v.normal_scale)));
            if (s.numbers.w != s.numbers.y) rough.add(t("for_lights"), one(s.numbers.w));
            if (s.orm_texel.w > 0.0F) {
                // Where rays or the horizon find what is occluded the map has no say.
                const float of_map = 1.0F + v.ao_strength * (s.orm_texel.x - 1.0F);
                constexpr float codes = 1.0F / 255.0F;  // it is stored in 8 bits
                node.add("AO", std::fabs(of_map - s.numbers.z) > codes
                                   ? fmt::format("{}   {}", one(s.numbers.z), t("occlusion_found"))
                                   : fmt::format("{}   = 1 + {} × ({} {} − 1)", one(s.numbers.z),
                                                 one(v.ao_strength), t("map"), one(s.orm_texel.x)));
            }
            if (material.texture(TextureSlot::normal_texture))
                node.add(t("normal_map"),
                         fmt::format("{}   × {}", numbers(s.normal_texel), one(v.normal_scale)));
        }
        if (s.coat.x > 0.0F)
            node.add(t("coat"), fmt::format("{}, {} {}, {} {}", one(s.coat.x), t("roughness"),
                                            one(s.coat.y), t("reflected"), one(s.coat.z)));
        if (math::Vec3(s.sheen) != math::Vec3(0.0F))
            node.add(t("sheen"), fmt::format("{} {}, {} {}", t("reflected"), numbers(s.sheen),
                                             t("roughness"), one(s.sheen.w)));
        if (v.emissive != math::Vec3(0.0F))
            node.add(t("emission"), numbers(s.emissive_nit) + " nit");
    }

    void tell_light(const shared::ExplainedLight& light, Node& node) const {
        const auto one = [](float x) { return number(static_cast<double>(x)); };
        node.add(t("comes_from"),
                 light.to_light.w > 0.0F
                     ? fmt::format("{}, {} m", numbers(light.to_light), one(light.to_light.w))
                     : numbers(light.to_light));
        node.add(t("illuminance"), numbers(light.illuminance_lux) + " lx");
        node.add("n·l  n·h  v·h", fmt::format("{}  {}  {}", one(light.cosines.x),
                                              one(light.cosines.y), one(light.cosines.z)));
        if (light.cosines.x <= 0.0F) {
            node.add(t("behind"));
            return;
        }
        node.add("D", one(light.d_g_v.x) + " 1/sr");
        node.add("G", fmt::format("{}   V = G / (4 n·v n·l) = {}", one(light.d_g_v.y),
                                  one(light.d_g_v.z)));
        node.add("F", numbers(light.f));
        node.add("kd", numbers(light.k_d));
        node.add("ks", numbers(light.k_s));
        node.add(t("diffuse"), numbers(light.diffuse) + " 1/sr");
        node.add(t("specular"), numbers(light.specular) + " 1/sr");
        node.add(t("shadow"), one(light.cosines.w));
        tell(of_light(light), node, "f × E × n·l × shadow");
    }

    void tell(const Contribution& c, Node& node, const char* formula) const {
        Node& sum =
            node.add(t("contribution"), fmt::format("{} nit   = {}", numbers(c.sum()), formula));
        sum.add(t("diffuse"), numbers(c.diffuse));
        sum.add(t("specular"), numbers(c.specular));
    }

    void tell_point(const ExplainedPoint& point, Node& node) const {
        const ExplainedSurface& s = point.surface;
        node.add(t("position"), numbers(s.position) + " m");
        node.add(t("normal"), numbers(s.normal));
        node.add(t("to_eye"), fmt::format("{}, n·v {}", numbers(s.to_eye),
                                          number(static_cast<double>(s.normal.w))));
        tell_material(point, node);
        if (s.ids.z != 0) {
            node.add(t("shows"), numbers(shown_by(point)) + " nit, " + t("unlit"));
            return;
        }
        for (const shared::ExplainedLight& light : point.lights) {
            const scene::Light& from = light_of(explained_.scene, light);
            const auto kind = tables::light_kinds[static_cast<std::size_t>(from.kind)].key;
            tell_light(light, node.add(t("light"),
                                       fmt::format("{} ({})", base::escaped(from.name), kind)));
        }
        Node& environment = node.add(t("environment"));
        environment.add(t("irradiance"), numbers(s.irradiance) + " nit");
        environment.add(t("prefiltered"), numbers(s.prefiltered) + " nit");
        environment.add(t("weight_diffuse"), numbers(s.environment_diffuse));
        environment.add(t("weight_specular"), numbers(s.environment_specular));
        tell(of_environment(s), environment, t("environment_formula").c_str());
        const Balance shares = balance_of(s);
        const bool has_far_side = shares.gone_through != DVec3(0.0);
        if (has_far_side) {
            Node& far = node.add(t("far_side"));
            far.add(t("weight"), numbers(shares.gone_through));
            far.add(t("contribution"), numbers(s.far_nit) + " nit");
        }
        Node& balance = node.add(t("balance"));
        balance.add(t("reflected"), numbers(shares.reflected));
        balance.add(t("transmitted"), numbers(shares.transmitted));
        if (has_far_side) balance.add(t("gone_through"), numbers(shares.gone_through));
        balance.add(t("absorbed"), numbers(shares.absorbed));
        node.add(t("shows"), numbers(shown_by(point)) + " nit");
    }

    void tell_samples(const Pixel& pixel, Node& root) const {
        Node& all = root.add(t("samples"), t("mean_of"));
        for (std::size_t i = 0; i < pixel.samples.size(); ++i) {
            const ExplainedPixel& sample = pixel.samples[i];
            const std::string what = sample.opaque ? name_of(*sample.opaque) : t("background");
            all.add(fmt::format("{}", i + 1),
                    fmt::format("{} nit   {}", numbers(composed(sample).radiance), what));
            constexpr std::size_t most = 32;
            if (i + 1 == most && pixel.samples.size() > most) {
                all.add("…", fmt::format("{}", pixel.samples.size() - most));
                break;
            }
        }
    }

    const Explained& explained_;
    const base::Texts& texts_;
};

}  // namespace

std::string tree_of(const Explained& explained, const Pixel& pixel, const base::Texts& texts) {
    Node root;
    Teller(explained, texts).tell(pixel, root);
    std::string out = fmt::format("{} {},{}  {}x{}\n", texts("explain.pixel"), pixel.x, pixel.y,
                                  explained.picture.width, explained.picture.height);
    print(root, "", out);
    return out;
}

}  // namespace facet::explain
