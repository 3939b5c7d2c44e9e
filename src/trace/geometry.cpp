// The triangles of a scene as rays meet them.
// SPDX-License-Identifier: MIT
#include "trace/geometry.h"

#include "scene/lobes.h"
#include "trace/surface.h"

#include <embree3/rtcore.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace facet::trace {
namespace {

using math::Vec3;

/// Embree's own bytes a triangle, measured on FlightHelmet with a robust scene, rounded up.
constexpr std::uint64_t bytes_per_triangle = 200;

/// What a filter needs beside the ray; Embree hands it through.
struct Context {
    RTCIntersectContext embree;
    const scene::Scene* scene = nullptr;
    const Textures* textures = nullptr;
    bool culls = false;
    Vec3 transmittance{1.0F};
};

const scene::Material& material_of(const Context& context, const RTCHit& hit) {
    return context.scene->material_of(context.scene->instances[hit.geomID]);
}

float coverage(const Context& context, const RTCHit& hit) {
    return coverage_at(*context.scene, *context.textures,
                       {.instance = hit.geomID, .triangle = hit.primID, .u = hit.u, .v = hit.v});
}

Vec3 normal_of(const RTCHit& hit) { return {hit.Ng_x, hit.Ng_y, hit.Ng_z}; }

/// Drops back faces that the camera does not see, and holes of alpha masks.
void filter_hit(const RTCFilterFunctionNArguments* arguments) {
    const auto& context = *reinterpret_cast<const Context*>(arguments->context);
    const auto& ray = *reinterpret_cast<const RTCRay*>(arguments->ray);
    const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
    const scene::Material& material = material_of(context, hit);
    const bool back = math::dot(normal_of(hit), Vec3(ray.dir_x, ray.dir_y, ray.dir_z)) > 0.0F;
    if (context.culls && back && !material.double_sided) arguments->valid[0] = 0;
    if (material.alpha_mode == scene::AlphaMode::mask && coverage(context, hit) == 0.0F)
        arguments->valid[0] = 0;
}

/// Whether light goes through it that is not bent.
bool is_clear(const scene::Material& material) {
    return material.alpha_mode != scene::AlphaMode::opaque ||
           (scene::has_lobe(material, tables::Lobe::transmission) && !scene::has_volume(material));
}

/// Lets light through holes and, in part, through what is blended and thin glass.
void filter_shadow(const RTCFilterFunctionNArguments* arguments) {
    auto& context = *reinterpret_cast<Context*>(arguments->context);
    const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
    const auto& ray = *reinterpret_cast<const RTCRay*>(arguments->ray);
    const scene::Material& material = material_of(context, hit);
    if (!is_clear(material)) return;
    const float covered = coverage(context, hit);
    const Vec3 straight = straight_share(*context.scene, *context.textures,
                                         {.instance = hit.geomID,
                                          .triangle = hit.primID,
                                          .normal = normal_of(hit),
                                          .u = hit.u,
                                          .v = hit.v},
                                         {ray.dir_x, ray.dir_y, ray.dir_z});
    context.transmittance *= Vec3(1.0F - covered) + straight * covered;
    constexpr float nothing = 1e-3F;
    const Vec3& left = context.transmittance;
    if (std::max({left.x, left.y, left.z}) > nothing) arguments->valid[0] = 0;
}

/// Embree takes no other.
bool is_finite(const Ray& ray) {
    const Vec3 sum = ray.origin + ray.direction;
    return std::isfinite(sum.x + sum.y + sum.z);
}

RTCRay embree_ray(const Ray& ray) {
    return {.org_x = ray.origin.x,
            .org_y = ray.origin.y,
            .org_z = ray.origin.z,
            .tnear = ray.near_m,
            .dir_x = ray.direction.x,
            .dir_y = ray.direction.y,
            .dir_z = ray.direction.z,
            .time = 0.0F,
            .tfar = ray.far_m,
            .mask = ~0U,
            .id = 0,
            .flags = 0};
}

base::Error embree_error(RTCDevice device) {
    const RTCError code = rtcGetDeviceError(device);
    if (code == RTC_ERROR_OUT_OF_MEMORY)
        return {.code = base::ErrorCode::limit_reached,
                .what = "out of memory while the triangles were sorted for rays",
                .remedy = "a smaller scene, or a machine with more memory"};
    return {.what = "Embree refused the scene",
            .found = fmt::format("error {}", static_cast<int>(code))};
}

}  // namespace

struct Geometry::Impl {
    struct DeviceDeleter {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    };
    struct SceneDeleter {
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };
    using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, DeviceDeleter>;
    using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, SceneDeleter>;

    const scene::Scene* scene = nullptr;
    const Textures* textures = nullptr;
    Device device;
    EmbreeScene embree;

    [[nodiscard]] bool add(const scene::Instance& instance, std::uint32_t index) const;
    [[nodiscard]] Context context(RTCIntersectContextFlags flags) const {
        Context out{.embree = {}, .scene = scene, .textures = textures};
        rtcInitIntersectContext(&out.embree);
        out.embree.flags = flags;
        return out;
    }
};

bool Geometry::Impl::add(const scene::Instance& instance, std::uint32_t index) const {
    const scene::Mesh& mesh = scene->meshes[instance.mesh.index];
    const scene::Material& material = scene->material_of(instance);
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    if (geometry == nullptr) return false;
    auto* positions = static_cast<Vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX,
                                                                 0, RTC_FORMAT_FLOAT3, sizeof(Vec3),
                                                                 mesh.positions_m.size()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.indices.size() / 3));
    const bool whole = positions != nullptr && indices != nullptr;
    if (whole) {
        for (std::size_t i = 0; i < mesh.positions_m.size(); ++i)
            positions[i] = Vec3(instance.world_from_object * math::Vec4(mesh.positions_m[i], 1.0F));
        std::copy(mesh.indices.begin(), mesh.indices.end(), indices);
        if (material.alpha_mode != scene::AlphaMode::opaque || !material.double_sided)
            rtcSetGeometryIntersectFilterFunction(geometry, filter_hit);
        if (is_clear(material)) rtcSetGeometryOccludedFilterFunction(geometry, filter_shadow);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(embree.get(), geometry, index);
    }
    rtcReleaseGeometry(geometry);
    return whole;
}

Geometry::Geometry(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;
Geometry::~Geometry() = default;

base::Result<Geometry> Geometry::build(const scene::Scene& scene, const Textures& textures,
                                       const base::Limits& limits) {
    const std::uint64_t bytes = scene.triangle_count() * bytes_per_triangle;
    if (bytes > limits.memory_bytes)
        return base::fail({.code = base::ErrorCode::limit_reached,
                           .file = "--reference",
                           .what = fmt::format("the triangles need {} MiB, the limit is {} MiB",
                                               bytes >> 20U, limits.memory_bytes >> 20U),
                           .found = fmt::format("{} triangles", scene.triangle_count()),
                           .remedy = "--max-memory raises the limit"});
    auto impl = std::make_unique<Impl>();
    impl->scene = &scene;
    impl->textures = &textures;
    // One thread builds: which of two coincident triangles a ray meets must not depend on how many
    // there are.
    impl->device.reset(rtcNewDevice("threads=1,set_affinity=0"));
    if (impl->device == nullptr) return base::fail(embree_error(nullptr));
    impl->embree.reset(rtcNewScene(impl->device.get()));
    rtcSetSceneFlags(impl->embree.get(),
                     RTC_SCENE_FLAG_ROBUST);  // no light between neighbouring triangles
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i)
        if (!impl->add(scene.instances[i], i)) return base::fail(embree_error(impl->device.get()));
    rtcCommitScene(impl->embree.get());
    if (rtcGetDeviceError(impl->device.get()) != RTC_ERROR_NONE)
        return base::fail(embree_error(impl->device.get()));
    return Geometry(std::move(impl));
}

Ray behind(const Ray& ray, const Hit& hit) {
    Ray rest = ray;
    rest.near_m = std::nextafter(hit.distance_m, 1e30F) * (1.0F + 1e-6F);
    return rest;
}

bool Geometry::intersect(const Ray& ray, Viewer viewer, Hit& hit) const {
    if (!is_finite(ray)) return false;
    Context context =
        impl_->context(viewer == Viewer::camera ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                                : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    context.culls = viewer == Viewer::camera;
    RTCRayHit query{.ray = embree_ray(ray), .hit = {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(impl_->embree.get(), &context.embree, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    hit = {query.hit.geomID, query.hit.primID, normal_of(query.hit),
           query.ray.tfar,   query.hit.u,      query.hit.v};
    return true;
}

Vec3 Geometry::transmittance(const Ray& ray) const {
    if (!is_finite(ray)) return Vec3(0.0F);
    Context context = impl_->context(RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
    RTCRay query = embree_ray(ray);
    rtcOccluded1(impl_->embree.get(), &context.embree, &query);
    return query.tfar < 0.0F ? Vec3(0.0F) : context.transmittance;
}

}  // namespace facet::trace
