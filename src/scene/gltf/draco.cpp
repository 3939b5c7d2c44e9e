// Draco's codec behind a gate; the only place that names the library.
// SPDX-License-Identifier: MIT
#include "scene/gltf/draco.h"

#ifdef FACET_HAS_DRACO

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <optional>
#include <type_traits>

namespace facet::scene::gltf {
namespace {

using base::ErrorCode;

base::Error draco_fault(std::string where, std::string what, std::string found = {}) {
    return {.code = ErrorCode::input_invalid,
            .where = std::move(where),
            .what = std::move(what),
            .found = std::move(found),
            .remedy = "export the model again"};
}

/// What a stream says of itself before its data.
struct DracoCounts {
    std::uint32_t faces = 0;
    std::uint32_t points = 0;        ///< or, of an edgebreaker, vertices: no more than points
    std::uint32_t split_tables = 0;  ///< attributes with seams of their own
};

/// A decoder of the library that stops where a count is not that of the file's accessors, or would
/// take more memory than there is. Its two steps are where the library knows the counts and has
/// not used them yet.
template <class Decoder>
class Guarded final : public Decoder {
public:
    explicit Guarded(const DracoStream& stream) : stream_(stream) {}
    [[nodiscard]] const std::optional<base::Error>& fault() const { return fault_; }

protected:
    bool DecodeConnectivity() override {
        const auto counts = peek_counts();
        return counts && are_expected(*counts) && Decoder::DecodeConnectivity();
    }

    bool DecodeAllAttributes() override {
        const draco::PointCloud& cloud = *this->point_cloud();
        if (cloud.num_points() != stream_.point_count) return refuse_points(cloud.num_points());
        // Values as coded (4 bytes a component) and as decoded (up to 8), and their map.
        std::size_t point_bytes = 4;
        for (int i = 0; i < cloud.num_attributes(); ++i)
            point_bytes +=
                static_cast<std::size_t>(std::max<int>(cloud.attribute(i)->num_components(), 1)) *
                    12 +
                4;
        return takes(stream_.point_count, point_bytes) && Decoder::DecodeAllAttributes();
    }

private:
    /// Draco bitstream 2.2, "Decode edgebreaker connectivity data" and "sequential".
    std::optional<DracoCounts> peek_counts() {
        draco::DecoderBuffer ahead = *this->buffer();
        DracoCounts counts;
        std::uint8_t tables = 0;
        constexpr bool is_edgebreaker = std::is_same_v<Decoder, draco::MeshEdgebreakerDecoder>;
        if constexpr (is_edgebreaker) {
            if (!draco::DecodeVarint(&counts.points, &ahead) ||
                !draco::DecodeVarint(&counts.faces, &ahead) || !ahead.Decode(&tables))
                return std::nullopt;
            counts.split_tables = tables;
        } else if (!draco::DecodeVarint(&counts.faces, &ahead) ||
                   !draco::DecodeVarint(&counts.points, &ahead)) {
            return std::nullopt;
        }
        return counts;
    }

    bool are_expected(const DracoCounts& counts) {
        const std::size_t faces = counts.faces;
        const bool fits = stream_.is_strip
                              ? faces <= stream_.index_count
                              : faces == stream_.index_count / 3 && stream_.index_count % 3 == 0;
        if (!fits) {
            fault_ = draco_fault(stream_.where, "compressed triangles are not those of the indices",
                                 fmt::format("{} triangles, but the accessor has {} indices", faces,
                                             stream_.index_count));
            return false;
        }
        if (counts.points > stream_.point_count) return refuse_points(counts.points);
        // Corners, their opposites and vertices, the same for each table of seams, and the faces.
        return takes(faces, 96 + std::size_t{48} * (counts.split_tables + 1)) &&
               takes(stream_.point_count, 32);
    }

    bool refuse_points(std::size_t found) {
        fault_ =
            draco_fault(stream_.where, "compressed vertices are not as many as the accessors have",
                        fmt::format("{}, but the accessors have {}", found, stream_.point_count));
        return false;
    }

    bool takes(std::size_t count, std::size_t bytes_each) {
        const std::size_t left = stream_.memory_bytes - taken_;
        if (count > left / bytes_each) {
            fault_ = {.code = ErrorCode::limit_reached,
                      .where = stream_.where,
                      .what = "compressed data needs more memory than allowed",
                      .found = fmt::format("{} elements of {} bytes more, {} bytes left", count,
                                           bytes_each, left),
                      .remedy = "raise --max-memory"};
            return false;
        }
        taken_ += count * bytes_each;
        return true;
    }

    const DracoStream& stream_;
    std::optional<base::Error> fault_;
    std::size_t taken_ = 0;
};

template <class Decoder>
base::Status run(const DracoStream& stream, draco::DecoderBuffer& buffer, draco::Mesh& mesh) {
    Guarded<Decoder> decoder(stream);
    std::string reason;
    try {
        const draco::DecoderOptions options;
        const draco::Status status = decoder.Decode(options, &buffer, &mesh);
        if (status.ok()) return {};
        reason = status.error_msg_string();
    } catch (const std::bad_alloc&) {
        throw;  // told as a limit
    } catch (const std::exception& fault) {
        reason = fault.what();
    }
    if (decoder.fault()) return base::fail(*decoder.fault());
    return base::fail(draco_fault(stream.where, "compressed data is broken",
                                  reason.empty() ? std::string() : "Draco: " + reason));
}

base::Status decode_into(const DracoStream& stream, draco::Mesh& mesh) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(stream.bytes.data()), stream.bytes.size());
    draco::DecoderBuffer ahead = buffer;
    draco::DracoHeader header{};
    if (!draco::PointCloudDecoder::DecodeHeader(&ahead, &header).ok())
        return base::fail(draco_fault(stream.where, "compressed data does not start as Draco"));
    if (header.version_major != 2 || header.version_minor != 2)
        return base::fail({.code = ErrorCode::feature_missing,
                           .where = stream.where,
                           .what = fmt::format("Draco bitstream {}.{} is not there, 2.2 is",
                                               header.version_major, header.version_minor)});
    if (header.encoder_type != draco::TRIANGULAR_MESH)
        return base::fail(draco_fault(stream.where, "compressed data has no triangles"));
    if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING)
        return run<draco::MeshEdgebreakerDecoder>(stream, buffer, mesh);
    if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING)
        return run<draco::MeshSequentialDecoder>(stream, buffer, mesh);
    return base::fail(draco_fault(stream.where, "compressed data is of an unknown method",
                                  std::to_string(header.encoder_method)));
}

/// One number as the stream has it.
template <class In>
double number_at(const std::byte* at, bool is_normalized) {
    In value;
    std::memcpy(&value, at, sizeof value);
    const auto number = static_cast<double>(value);
    if constexpr (std::is_integral_v<In>)
        return is_normalized ? number / static_cast<double>(std::numeric_limits<In>::max())
                             : number;
    else
        return number;
}

using Reader = double (*)(const std::byte*, bool);
/// Null for types that no accessor can have.
Reader reader_of(draco::DataType type) {
    switch (type) {
        case draco::DT_INT8:
            return number_at<std::int8_t>;
        case draco::DT_UINT8:
            return number_at<std::uint8_t>;
        case draco::DT_INT16:
            return number_at<std::int16_t>;
        case draco::DT_UINT16:
            return number_at<std::uint16_t>;
        case draco::DT_INT32:
            return number_at<std::int32_t>;
        case draco::DT_UINT32:
            return number_at<std::uint32_t>;
        case draco::DT_FLOAT32:
            return number_at<float>;
        default:
            return nullptr;
    }
}

/// Stores `number`; false where the type cannot hold it.
template <class Out>
bool put(double number, std::byte* to) {
    if constexpr (std::is_integral_v<Out>)
        if (!(number >= static_cast<double>(std::numeric_limits<Out>::lowest()) &&
              number <= static_cast<double>(std::numeric_limits<Out>::max())) ||
            number != std::floor(number))
            return false;
    const auto value = static_cast<Out>(number);
    std::memcpy(to, &value, sizeof value);
    return true;
}

using Writer = bool (*)(double, std::byte*);
Writer writer_of(Component component) {
    switch (component) {
        case Component::i8:
            return put<std::int8_t>;
        case Component::u8:
            return put<std::uint8_t>;
        case Component::i16:
            return put<std::int16_t>;
        case Component::u16:
            return put<std::uint16_t>;
        case Component::u32:
            return put<std::uint32_t>;
        case Component::f32:
            break;
    }
    return put<float>;
}

/// The stream's attribute, its values where they can be read without a further look.
base::Result<const draco::PointAttribute*> find_attribute(const draco::Mesh& mesh,
                                                          const DracoAttribute& wanted,
                                                          std::size_t point_count) {
    const draco::PointAttribute* const found = mesh.GetAttributeByUniqueId(wanted.id);
    if (found == nullptr)
        return base::fail(draco_fault(wanted.where, "no such attribute in the compressed data",
                                      std::to_string(wanted.id)));
    if (found->num_components() != static_cast<int>(wanted.components))
        return base::fail(draco_fault(wanted.where,
                                      "compressed attribute has another number of components",
                                      fmt::format("{}, but the accessor has {}",
                                                  found->num_components(), wanted.components)));
    const auto stride = static_cast<std::size_t>(found->byte_stride());
    const std::size_t packed =
        wanted.components * static_cast<std::size_t>(draco::DataTypeLength(found->data_type()));
    const bool is_whole = reader_of(found->data_type()) != nullptr && found->buffer() != nullptr &&
                          stride >= packed && found->byte_offset() == 0 &&
                          found->buffer()->data_size() / stride >= found->size() &&
                          (found->is_mapping_identity() ? found->size() >= point_count
                                                        : found->indices_map_size() >= point_count);
    if (!is_whole)
        return base::fail(draco_fault(wanted.where, "compressed attribute cannot be read"));
    return found;
}

base::Result<base::Bytes> values_of(const draco::Mesh& mesh, const DracoAttribute& wanted,
                                    std::size_t point_count) {
    const auto found = find_attribute(mesh, wanted, point_count);
    if (!found) return tl::unexpected(found.error());
    const draco::PointAttribute& attribute = **found;
    const auto size = static_cast<std::size_t>(draco::DataTypeLength(attribute.data_type()));
    const auto stride = static_cast<std::size_t>(attribute.byte_stride());
    const auto* const from = reinterpret_cast<const std::byte*>(attribute.buffer()->data());
    const Reader read = reader_of(attribute.data_type());
    const Writer write = writer_of(wanted.component);
    // Whole numbers that mean fractions do so in the accessor too, unless that has floats.
    const bool is_scaled = attribute.normalized() && wanted.component == Component::f32;
    const std::size_t out_size = component_bytes(wanted.component);
    base::Bytes out(point_count * wanted.components * out_size);
    std::byte* to = out.data();
    for (std::size_t p = 0; p < point_count; ++p) {
        const std::size_t value =
            attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(p))).value();
        if (value >= attribute.size())
            return base::fail(
                draco_fault(wanted.where, "compressed attribute lacks a value", std::to_string(p)));
        for (std::size_t c = 0; c < wanted.components; ++c, to += out_size)
            if (!write(read(from + value * stride + c * size, is_scaled), to))
                return base::fail(draco_fault(
                    wanted.where, "compressed attribute does not fit the accessor's type",
                    fmt::format("vertex {}", p)));
    }
    return out;
}

base::Result<std::vector<std::uint32_t>> indices_of(const draco::Mesh& mesh,
                                                    const DracoStream& stream) {
    std::vector<std::uint32_t> out;
    out.reserve(std::size_t{mesh.num_faces()} * 3);
    for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
        for (const draco::PointIndex& point : mesh.face(face)) {
            if (point.value() >= stream.point_count)
                return base::fail(draco_fault(
                    stream.where, "compressed index is out of range",
                    fmt::format("{}, but there are {}", point.value(), stream.point_count)));
            out.push_back(point.value());
        }
    return out;
}

}  // namespace

base::Result<DracoMesh> decode_draco(const DracoStream& stream) {
    draco::Mesh mesh;
    if (auto decoded = decode_into(stream, mesh); !decoded) return tl::unexpected(decoded.error());
    auto indices = indices_of(mesh, stream);
    if (!indices) return tl::unexpected(indices.error());
    DracoMesh out{.indices = std::move(*indices), .attributes = {}};
    for (const DracoAttribute& wanted : stream.attributes) {
        auto values = values_of(mesh, wanted, stream.point_count);
        if (!values) return tl::unexpected(values.error());
        out.attributes.push_back(std::move(*values));
    }
    return out;
}

}  // namespace facet::scene::gltf

#else

namespace facet::scene::gltf {

base::Result<DracoMesh> decode_draco(const DracoStream& stream) {
    return base::fail({.code = base::ErrorCode::feature_missing,
                       .where = stream.where,
                       .what = "built without Draco"});
}

}  // namespace facet::scene::gltf

#endif
