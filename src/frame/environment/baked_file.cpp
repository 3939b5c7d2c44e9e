// Baked environments that are kept in files.
// SPDX-License-Identifier: MIT
#include "frame/environment/baked_file.h"

#include "base/build_id.h"
#include "base/disk_cache.h"
#include "base/hash.h"

#include <gnu/libc-version.h>
#include <spdlog/fmt/fmt.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

namespace facet::frame {
namespace {

struct BakedHeader {
    std::uint32_t face_px = 0;
    std::uint32_t overflowed = 0;
    float unit_nit = 1.0F;
    std::uint32_t pad0 = 0;
};
static_assert(sizeof(BakedHeader) == 16 && std::is_trivially_copyable_v<BakedHeader>);

/// glibc has its sines and powers with and without fused multiplication, and takes what the
/// processor can do: they may differ in the last bit, and a folder may serve several machines.
std::string arithmetic() {
    std::string out = std::string("glibc ") + ::gnu_get_libc_version();
#if defined(__x86_64__)
    if (__builtin_cpu_supports("fma") != 0) out += " fma";
    if (__builtin_cpu_supports("fma4") != 0) out += " fma4";
    if (__builtin_cpu_supports("avx2") != 0) out += " avx2";
#endif
    return out;
}

std::size_t baked_bytes(const BakedEnvironment& baked) {
    std::size_t bytes = sizeof(BakedHeader) + baked.irradiance.size() * sizeof(std::uint16_t);
    for (const auto& level : baked.radiance) bytes += level.size() * sizeof(std::uint16_t);
    for (const CubeMip& mip : baked.kept) bytes += mip.texels.size() * sizeof(Lanes);
    return bytes;
}

/// Takes values off the front of bytes, as many as a vector is long.
class Cutter {
public:
    explicit Cutter(std::span<const std::byte> bytes) : left_(bytes) {}
    template <class T>
    bool take(T* out, std::size_t count) {
        static_assert(std::is_trivially_copyable_v<T>);
        if (count > left_.size() / sizeof(T)) return false;
        std::memcpy(out, left_.data(), count * sizeof(T));
        left_ = left_.subspan(count * sizeof(T));
        return true;
    }
    template <class T>
    bool take(std::vector<T>& out, std::size_t count) {
        if (count > left_.size() / sizeof(T)) return false;  // before memory is asked for
        out.resize(count);
        return take(out.data(), count);
    }
    [[nodiscard]] bool is_empty() const { return left_.empty(); }

private:
    std::span<const std::byte> left_;
};

template <class T>
void append(base::Bytes& out, std::span<const T> values) {
    const auto bytes = std::as_bytes(values);
    const std::size_t at = out.size();
    out.resize(at + bytes.size());
    std::memcpy(out.data() + at, bytes.data(), bytes.size());
}

std::size_t half_count(std::uint32_t side) { return std::size_t{6} * side * side * 4; }

bool is_sound(const BakedHeader& header) {
    return std::has_single_bit(header.face_px) && header.face_px >= baked_face_min_px &&
           header.face_px <= baked_face_max_px && header.overflowed <= 1 &&
           std::isfinite(header.unit_nit) && header.unit_nit >= 1.0F;
}

}  // namespace

std::string bake_key(const image::Image& latlong, float rotation_deg, float intensity,
                     base::ThreadPool& pool) {
    const std::string build = base::build_id();
    if (build.empty()) return "";
    base::Sha256 hash;
    hash.add_text("facet baked environment");
    hash.add_text(build);
    hash.add_text(arithmetic());
    hash.add_text(fmt::format("{} {} {} {}", latlong.size.width, latlong.size.height,
                              std::bit_cast<std::uint32_t>(rotation_deg),
                              std::bit_cast<std::uint32_t>(intensity)));
    hash.add_text(base::sha256_of_blocks(latlong.bytes, pool));
    return hash.hex();
}

base::Bytes bytes_of(const BakedEnvironment& baked) {
    const BakedHeader header{.face_px = baked.face_px,
                             .overflowed = baked.overflowed ? 1U : 0U,
                             .unit_nit = baked.unit_nit};
    base::Bytes out;
    out.reserve(baked_bytes(baked));
    append(out, std::span(&header, 1));
    append(out, std::span(baked.irradiance));
    for (const auto& level : baked.radiance) append(out, std::span(level));
    for (const CubeMip& mip : baked.kept) append(out, std::span(mip.texels));
    return out;
}

std::optional<BakedEnvironment> baked_from(std::span<const std::byte> bytes) {
    Cutter cutter(bytes);
    BakedHeader header;
    if (!cutter.take(&header, 1) || !is_sound(header)) return std::nullopt;
    BakedEnvironment out{.face_px = header.face_px,
                         .unit_nit = header.unit_nit,
                         .overflowed = header.overflowed != 0};
    if (!cutter.take(out.irradiance, half_count(BakedEnvironment::irradiance_px)))
        return std::nullopt;
    const std::uint32_t levels = baked_level_count(header.face_px);
    for (std::uint32_t level = 0; level < levels; ++level)
        if (!cutter.take(out.radiance.emplace_back(), half_count(header.face_px >> level)))
            return std::nullopt;
    for (std::uint32_t level = BakedEnvironment::first_kept; level < levels; ++level) {
        CubeMip& mip = out.kept.emplace_back();
        mip.side = header.face_px >> level;
        if (!cutter.take(mip.texels, 6 * mip.stride() * mip.stride())) return std::nullopt;
    }
    return cutter.is_empty() ? std::optional(std::move(out)) : std::nullopt;
}

BakedEnvironment baked_environment(const image::Image& latlong, const EnvironmentSettings& settings,
                                   base::ThreadPool& pool, base::Warnings& warnings) {
    const auto bake = [&] {
        auto baked = bake_environment(latlong, settings.rotation_deg, settings.intensity, pool);
        warn_of(baked, warnings);
        return baked;
    };
    const std::string key = settings.cache_folder.empty() ? ""
                                                          : bake_key(latlong, settings.rotation_deg,
                                                                     settings.intensity, pool);
    if (key.empty()) return bake();
    const base::DiskCache cache(settings.cache_folder / "environments");
    if (const auto entry = cache.find(key, pool))
        if (auto known = baked_from(entry->payload())) {
            warn_of(*known, warnings);
            return std::move(*known);
        }
    BakedEnvironment baked = bake();
    if (auto kept = cache.put(key, bytes_of(baked), pool); !kept)
        warnings.push_back({.file = kept.error().file,
                            .what = kept.error().what,
                            .found = kept.error().found,
                            .remedy = kept.error().remedy,
                            .spares_result = true});
    return baked;
}

}  // namespace facet::frame
