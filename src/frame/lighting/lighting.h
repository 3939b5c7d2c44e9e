// The lighting pass: G-buffer, lights and environment to radiance.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/environment/environment_maps.h"
#include "frame/gbuffer/gbuffer.h"
#include "frame/lighting/light_lists.h"
#include "frame/rays/rays.h"
#include "frame/shadow/shadow_textures.h"
#include "frame/shared.h"
#include "tables/aovs.h"

#include <string>
#include <vector>

namespace facet::frame {

/// Which parts of shade.glsl a program has.
struct ShadeKey {
    bool environment = true;
    bool local_lights = false;
    bool area_lights = false;        ///< some of them have a size
    bool light_profiles = false;     ///< some of them have a profile
    bool shadow_maps = false;        ///< of lights, and
    bool occlusion = false;          ///< of the environment, from what the eye sees; or
    bool visibility = false;         ///< of lights, and
    bool indirect = false;           ///< indirect light, as rays found them
    bool sample_light = false;       ///< and at this very sample, where that is not enough
    std::vector<tables::Aov> paths;  ///< light paths, a target each in place of their sum
    auto operator<=>(const ShadeKey&) const = default;
};
[[nodiscard]] std::string defines(const ShadeKey& key);

/// Lights on the GL's side.
struct LightBuffers {
    gl::Buffer lights, tiles, indices, profiles;
    gl::Texture lights_texture, tiles_texture, indices_texture, profiles_texture;
    gl::Texture ltc_table;      ///< RGBA32F, brdf/ltc.h
    gl::Texture sheen_table;    ///< R32F, brdf/sheen.h
    gl::Sampler table_sampler;  ///< of both
};
[[nodiscard]] base::Result<LightBuffers> make_light_buffers(const gl::Context& gl);
void update_lights(const gl::Context& gl, const LightBuffers& buffers, const PackedLights& lights);
void update_lists(const gl::Context& gl, const LightBuffers& buffers, const LightLists& lists);

/// What light arrives by: used by lighting and blend. Everything outlives the call.
struct ShadeInputs {
    ShadeKey key;
    const EnvironmentMaps& environment;
    const LightBuffers& lights;
    const RayTextures& rays;
    const ShadowTextures& shadows;
    const gl::Texture& occlusion;
};
void set_shade_samplers(const gl::Context& gl, const gl::Program& program);
void bind_shade_textures(const gl::Context& gl, const ShadeInputs& in);

/// What a pass draws into.
struct DrawTarget {
    const gl::Framebuffer& framebuffer;
    math::Extent size;
};

/// Where radiance goes: RGBA32F [height, width, 4], linear Rec.709 in nit, associated alpha. It
/// shares the G-buffer's depth: passes test against it while lighting reads it, and none writes it,
/// which GL allows after a texture barrier.
struct RadianceTarget {
    math::Extent size;
    std::vector<gl::Texture> colors;  ///< one, or one a light path
    gl::Framebuffer framebuffer;
    /// `depth` outlives the target.
    [[nodiscard]] static base::Result<RadianceTarget> create(const gl::Context& gl,
                                                             math::Extent size,
                                                             const gl::Texture& depth,
                                                             std::size_t color_count = 1);
    void clear(const gl::Context& gl) const;
    [[nodiscard]] DrawTarget target() const { return {framebuffer, size}; }
};

class LightingPass {
public:
    explicit LightingPass(const gl::ShaderSources& sources) : sources_(&sources) {}
    /// Writes the pixels where the G-buffer has a surface.
    [[nodiscard]] base::Status run(const gl::Context& gl, const GBuffer& gbuffer,
                                   const ShadeInputs& in, const gl::VertexArray& empty,
                                   const DrawTarget& out);

private:
    struct Key {
        ShadeKey shade;
        bool emissive = false;
        bool specular = false;
        auto operator<=>(const Key&) const = default;
    };
    const gl::ShaderSources* sources_;
    Permutations<Key> programs_;
};

}  // namespace facet::frame
