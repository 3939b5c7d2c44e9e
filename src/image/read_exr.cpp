// Reads OpenEXR: scanlines and tiles, every flat part and every layer, as floats.
// SPDX-License-Identifier: MIT
#include "image/bytes.h"
#include "image/checks.h"
#include "image/dispatch.h"
#include "image/exr_header.h"

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace facet::image::exr {
namespace {

/// A file in memory as the library wants it. The library expects its own exceptions from here.
class MemoryInput : public Imf::IStream {
public:
    explicit MemoryInput(FileBytes file) : Imf::IStream("memory"), file_(file) {}
    bool read(char out[], int count) override {
        const std::size_t wanted = count < 0 ? 0 : static_cast<std::size_t>(count);
        if (count < 0 || at_ > file_.size() || wanted > file_.size() - at_)
            throw IEX_NAMESPACE::InputExc("the file is cut short");
        std::memcpy(out, file_.data() + at_, wanted);
        at_ += wanted;
        return at_ < file_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = static_cast<std::size_t>(position); }
    void clear() override {}

private:
    FileBytes file_;
    std::size_t at_ = 0;
};

/// R G B, X Y Z, U V, and alpha behind them all (gray is Y A); others in between, as the file has
/// them, by name.
std::size_t rank(const std::string& channel) {
    constexpr std::string_view order = "RGBXYZUV";
    if (channel == "A") return order.size() + 1;
    const std::size_t at =
        channel.size() == 1 ? order.find(channel.front()) : std::string_view::npos;
    return at == std::string_view::npos ? order.size() : at;
}

/// The layers of a part, empty images still, with the file's name for each channel.
struct LayerPlan {
    Layer layer;
    std::vector<std::string> sources;  ///< "" for a channel that the file lacks
};

/// A colour layer that lacks one of R, G and B gets it, as zeros.
void complete_color(std::vector<std::pair<std::string, std::string>>& channels,
                    base::Warnings& warnings) {
    const auto has = [&](std::string_view name) {
        return std::ranges::any_of(channels, [&](const auto& c) { return c.first == name; });
    };
    if (!has("R") && !has("G") && !has("B")) return;
    for (const char* name : {"R", "G", "B"}) {
        if (has(name)) continue;
        channels.emplace_back(name, "");
        warnings.push_back({.file = {},
                            .where = "header",
                            .what = "a colour channel is missing and taken as 0",
                            .found = name,
                            .remedy = {}});
    }
}

std::vector<LayerPlan> plan_layers(const Part& part, const std::string& prefix,
                                   base::Warnings& warnings) {
    std::vector<std::pair<std::string, std::vector<std::pair<std::string, std::string>>>> found;
    for (const Channel& channel : part.channels) {
        const ChannelPlace place = place_of(channel.name);
        auto group = std::ranges::find(found, place.layer, &decltype(found)::value_type::first);
        if (group == found.end()) {
            found.push_back({place.layer, {}});
            group = found.end() - 1;
        }
        group->second.emplace_back(place.channel, channel.name);
    }
    std::vector<LayerPlan> plans;
    for (auto& [name, channels] : found) {
        complete_color(channels, warnings);
        std::ranges::stable_sort(
            channels, [](const auto& a, const auto& b) { return rank(a.first) < rank(b.first); });
        LayerPlan plan;
        plan.layer.name = prefix.empty() ? name : name.empty() ? prefix : prefix + "." + name;
        for (auto& [channel, source] : channels) {
            plan.layer.channels.push_back(channel);
            plan.sources.push_back(source);
        }
        plans.push_back(std::move(plan));
    }
    return plans;
}

void read_part(Imf::MultiPartInputFile& file, int index, const Part& part,
               std::vector<LayerPlan>& plans) {
    Imf::InputPart input(file, index);
    const Imath::Box2i window(Imath::V2i(part.window[0], part.window[1]),
                              Imath::V2i(part.window[2], part.window[3]));
    if (input.header().dataWindow() != window)
        throw IEX_NAMESPACE::InputExc("the header is ambiguous");
    Imf::FrameBuffer buffer;
    for (LayerPlan& plan : plans) {
        const std::size_t count = plan.sources.size();
        plan.layer.image = Image(part.size, static_cast<std::uint32_t>(count), Sample::f32);
        float* const pixels = plan.layer.image.as<float>().data();
        for (std::size_t c = 0; c < count; ++c) {
            if (plan.sources[c].empty()) continue;
            buffer.insert(plan.sources[c],
                          Imf::Slice::Make(Imf::FLOAT, pixels + c, window, count * sizeof(float),
                                           count * sizeof(float) * part.size.width));
        }
    }
    input.setFrameBuffer(buffer);
    input.readPixels(part.window[1], part.window[3]);
}

/// The layer that decode() gives, by the rule of its main_layer().
const LayerPlan& main_plan(const std::vector<LayerPlan>& plans) {
    for (const LayerPlan& plan : plans)
        if (plan.layer.name.empty()) return plan;
    for (const LayerPlan& plan : plans)
        if (plan.sources.size() >= 3) return plan;
    return plans.front();
}

void warn_of_skipped(const Part& part, base::Warnings& warnings) {
    warnings.push_back({.file = {},
                        .where = "header",
                        .what = "a part of the EXR is deep or subsampled and is left out",
                        .found = part.name,
                        .remedy = {}});
}

bool is_readable(const Part& part) {
    return !part.is_deep && std::ranges::all_of(part.channels, [](const Channel& c) {
        return c.x_sampling == 1 && c.y_sampling == 1;
    });
}

}  // namespace

bool sniff(FileBytes file) {
    using namespace std::string_view_literals;
    return starts_with(file, "\x76\x2F\x31\x01"sv);
}

base::Result<Header> read_header(FileBytes file, const base::Limits& limits) {
    const auto parts = read_parts(file, limits);
    if (!parts) return tl::unexpected(parts.error());
    const Part& part = parts->front();
    base::Warnings unused;
    const auto plans = plan_layers(part, "", unused);
    const LayerPlan& main = main_plan(plans);
    return Header{tables::ImageFormat::exr, part.size,
                  static_cast<std::uint32_t>(main.sources.size()), Sample::f32};
}

base::Result<Picture> read(FileBytes file, const base::Limits& limits, base::Warnings& warnings) {
    auto parts = read_parts(file, limits);
    if (!parts) return tl::unexpected(parts.error());
    MemoryInput stream(file);
    Imf::MultiPartInputFile input(stream, 0);
    if (static_cast<std::size_t>(input.parts()) != parts->size())
        return damaged(0, "the headers are ambiguous");
    Picture picture;
    picture.format = tables::ImageFormat::exr;
    picture.metadata = std::move(parts->front().strings);
    for (std::size_t i = 0; i < parts->size(); ++i) {
        const Part& part = (*parts)[i];
        if (!is_readable(part)) {
            warn_of_skipped(part, warnings);
            continue;
        }
        auto plans = plan_layers(part, i == 0 ? "" : part.name, warnings);
        read_part(input, static_cast<int>(i), part, plans);
        for (LayerPlan& plan : plans) picture.layers.push_back(std::move(plan.layer));
    }
    return picture;
}

}  // namespace facet::image::exr
