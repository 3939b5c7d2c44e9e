// meshoptimizer's codecs behind a gate; the only place that names the library.
// SPDX-License-Identifier: MIT
#include "scene/gltf/meshopt.h"

#include <spdlog/fmt/fmt.h>

#include <string>

#ifdef FACET_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

namespace facet::scene::gltf {
namespace {

using base::ErrorCode;

base::Status shape_fault(const char* member, std::string what, std::size_t found) {
    return base::fail({.code = ErrorCode::input_invalid,
                       .where = member,
                       .what = std::move(what),
                       .found = std::to_string(found),
                       .remedy = "export the model again"});
}

/// Strides that a filter works on; empty: any.
std::string_view strides_of(MeshoptFilter filter) {
    switch (filter) {
        case MeshoptFilter::octahedral:
        case MeshoptFilter::color:
            return "4 or 8";
        case MeshoptFilter::quaternion:
            return "8";
        case MeshoptFilter::none:
        case MeshoptFilter::exponential:
            break;
    }
    return {};
}

bool fits_filter(MeshoptFilter filter, std::size_t stride) {
    const std::string_view strides = strides_of(filter);
    return strides.empty() || stride == 8 || (stride == 4 && strides != "8");
}

base::Result<base::Bytes> lacking(std::string what) {
    return base::fail({.code = ErrorCode::feature_missing, .what = std::move(what)});
}

#ifdef FACET_HAS_MESHOPT

/// High half of a stream's first byte, and the newest version that the library reads (appendix A).
struct Header {
    unsigned kind;
    unsigned newest;
};
Header header_of(MeshoptMode mode) {
    switch (mode) {
        case MeshoptMode::attributes:
            return {0xA0, 0};
        case MeshoptMode::triangles:
            return {0xE0, 1};
        case MeshoptMode::indices:
            break;
    }
    return {0xD0, 1};
}

/// Errors: input_invalid (another kind of stream), feature_missing (a newer version).
base::Result<base::Bytes> check_header(const MeshoptStream& stream) {
    if (stream.bytes.empty())
        return base::fail({.code = ErrorCode::input_invalid, .what = "compressed data is empty"});
    const auto first = std::to_integer<unsigned>(stream.bytes[0]);
    const Header header = header_of(stream.mode);
    if ((first & 0xF0U) != header.kind)
        return base::fail({.code = ErrorCode::input_invalid,
                           .what = "compressed data is not of this mode",
                           .found = fmt::format("starts with {:#04x}, not {:#04x}", first,
                                                header.kind | header.newest)});
    if (const unsigned version = first & 0x0FU; version > header.newest)
        return lacking(fmt::format("compressed data is of version {}, this build reads up to {}",
                                   version, header.newest));
    return base::Bytes{};
}

int decode_into(base::Bytes& out, const MeshoptStream& stream) {
    const auto* const from = reinterpret_cast<const unsigned char*>(stream.bytes.data());
    switch (stream.mode) {
        case MeshoptMode::attributes:
            return meshopt_decodeVertexBuffer(out.data(), stream.count, stream.stride_bytes, from,
                                              stream.bytes.size());
        case MeshoptMode::triangles:
            return meshopt_decodeIndexBuffer(out.data(), stream.count, stream.stride_bytes, from,
                                             stream.bytes.size());
        case MeshoptMode::indices:
            break;
    }
    return meshopt_decodeIndexSequence(out.data(), stream.count, stream.stride_bytes, from,
                                       stream.bytes.size());
}

void apply_filter(base::Bytes& out, const MeshoptStream& stream) {
    switch (stream.filter) {
        case MeshoptFilter::octahedral:
            return meshopt_decodeFilterOct(out.data(), stream.count, stream.stride_bytes);
        case MeshoptFilter::quaternion:
            return meshopt_decodeFilterQuat(out.data(), stream.count, stream.stride_bytes);
        case MeshoptFilter::exponential:
            return meshopt_decodeFilterExp(out.data(), stream.count, stream.stride_bytes);
        case MeshoptFilter::none:
        case MeshoptFilter::color:
            break;
    }
}

/// What the library's numbers mean (its sources return nothing else).
std::string_view reason_of(int code) {
    if (code == -2) return "it is cut off";
    if (code == -3) return "bytes are left over";
    return "its header is wrong";
}

#endif

}  // namespace

base::Status check_shape(const MeshoptStream& stream) {
    const std::size_t stride = stream.stride_bytes;
    if (stream.mode == MeshoptMode::attributes) {
        if (stride < 4 || stride > 256 || stride % 4 != 0)
            return shape_fault("byteStride", "stride is not a multiple of 4 up to 256", stride);
        if (!fits_filter(stream.filter, stride))
            return shape_fault(
                "byteStride",
                fmt::format("stride for this filter is not {}", strides_of(stream.filter)), stride);
        return {};
    }
    if (stride != 2 && stride != 4)
        return shape_fault("byteStride", "stride of indices is not 2 or 4", stride);
    if (stream.filter != MeshoptFilter::none)
        return base::fail({.code = ErrorCode::input_invalid,
                           .where = "filter",
                           .what = "indices cannot have a filter"});
    if (stream.mode == MeshoptMode::triangles && stream.count % 3 != 0)
        return shape_fault("count", "count is not a multiple of 3", stream.count);
    return {};
}

base::Result<base::Bytes> decode(const MeshoptStream& stream) {
#ifdef FACET_HAS_MESHOPT
    if (auto header = check_header(stream); !header) return header;
    if (stream.filter == MeshoptFilter::color) return lacking("the filter COLOR is not there");
    base::Bytes out(stream.count * stream.stride_bytes);
    if (const int code = decode_into(out, stream); code != 0)
        return base::fail(
            {.code = ErrorCode::input_invalid,
             .what = "compressed data is broken",
             .found = fmt::format("{}; {} bytes for {} elements of {}", reason_of(code),
                                  stream.bytes.size(), stream.count, stream.stride_bytes),
             .remedy = "export the model again"});
    apply_filter(out, stream);
    return out;
#else
    (void)stream;
    return lacking("built without meshoptimizer");
#endif
}

}  // namespace facet::scene::gltf
