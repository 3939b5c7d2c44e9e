// The G-buffer: its targets, and the pass that fills it.
// SPDX-License-Identifier: MIT
#pragma once

#include "frame/permutations.h"
#include "frame/upload/gpu_scene.h"
#include "gl/pipeline.h"

namespace facet::frame {

/// What the frame wants of the G-buffer beyond the classic targets.
struct GBufferSpec {
    math::Extent size;
    bool emissive = false;
    bool specular = false;  ///< some material reflects as no plain dielectric does
    bool ids = false;
    bool triangles = false;  ///< for rays that begin at what is seen
    bool operator==(const GBufferSpec&) const = default;

    /// Where a target stands among the framebuffer's.
    [[nodiscard]] int specular_place() const { return emissive ? 4 : 3; }
    [[nodiscard]] int ids_place() const { return specular_place() + (specular ? 1 : 0); }
    [[nodiscard]] int triangles_place() const { return ids_place() + (ids ? 1 : 0); }
};

/// 20 bytes a pixel: RGBA16 albedo (a: unlit), RG16 octahedral normal, RGBA8 metallic, roughness,
/// AO, and D32F. Formats cost llvmpipe the same, and its sRGB8 is off by 0.8 %
/// (docs/decisions/003).
struct GBuffer {
    GBufferSpec spec;
    gl::Texture albedo;
    gl::Texture normal;
    gl::Texture metal_rough_ao;
    gl::Texture emissive_nit;  ///< RGBA32F; 1x1 where not asked for
    gl::Texture specular;      ///< RGBA16: F0 of dielectrics, strength; 1x1 where not asked for
    gl::Texture ids;           ///< RG32UI: object, material; 1x1 where not asked for
    gl::Texture triangles;     ///< RG32UI: draw, triangle; 1x1 where not asked for
    gl::Texture depth;
    gl::Framebuffer framebuffer;

    [[nodiscard]] static base::Result<GBuffer> create(const gl::Context& gl,
                                                      const GBufferSpec& spec);
};

/// Makes every target black. No pass reads what is not covered, but lanes of a software renderer
/// that are masked out do, and what they hold can choose another path through its texture filter
/// for the lanes beside them: results an ulp apart, by what was drawn before.
void clear(const gl::Context& gl, const GBuffer& gbuffer);

/// Where the frame's uniform blocks are bound.
enum BlockBinding : GLuint { view_binding = 0, draw_binding = 1, display_binding = 2 };

class GBufferPass {
public:
    explicit GBufferPass(const gl::ShaderSources& sources) : sources_(&sources) {}
    /// Clears, and draws every opaque instance of `scene` in `order` (indices into its draws).
    /// Errors: internal when the driver rejects a program; names the GLSL file and line.
    [[nodiscard]] base::Status run(const gl::Context& gl, const GpuScene& scene,
                                   const std::vector<std::size_t>& order, const GBuffer& out);

private:
    struct Key {
        MaterialKey material;
        bool emissive = false;
        bool specular = false;
        bool ids = false;
        bool triangles = false;
        auto operator<=>(const Key&) const = default;
    };
    [[nodiscard]] base::Result<gl::Program> make(const gl::Context& gl, const Key& key) const;

    const gl::ShaderSources* sources_;
    Permutations<Key> programs_;
};

/// Units of the textures that materials of this key look up.
void bind_material_samplers(const gl::Context& gl, const gl::Program& program,
                            const MaterialKey& key);
/// Binds a draw's textures and uniform block, and draws its triangles.
void draw_instance(const gl::Context& gl, const GpuScene& scene, const Draw& draw);

}  // namespace facet::frame
