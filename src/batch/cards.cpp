// Finished pictures made small, and compared with earlier ones.
// SPDX-License-Identifier: MIT
#include "batch/cards.h"

#include "base/file.h"
#include "base/text.h"
#include "batch/state.h"
#include "image/compare.h"
#include "image/mips.h"
#include "image/write.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace facet::batch {
namespace {

namespace fs = std::filesystem;
using image::Image;

constexpr std::uint32_t heat_px = 512;  // no file has it at full size

/// The picture as it was shown when it was rendered: radiance by its own exposure.
base::Result<image::Picture> read(const fs::path& path) {
    const base::Limits limits;
    const auto bytes = base::read_file(path, limits.file_bytes);
    if (!bytes) return tl::unexpected(base::in_file(bytes.error(), path.string()));
    auto picture = image::decode_picture(*bytes, limits);
    if (!picture) return tl::unexpected(base::in_file(picture.error(), path.string()));
    Image& beauty = picture->layers.front().image;
    if (!tables::row(picture->format).scene_linear) return picture;
    for (const auto& [key, text] : picture->metadata) {
        const auto exposure = key == "facet.exposure" ? base::parse_number(text) : std::nullopt;
        if (!exposure) continue;
        const auto values = beauty.as<float>();
        for (std::size_t i = 0; i < values.size(); ++i)
            if (i % beauty.channels < 3) values[i] *= static_cast<float>(*exposure);
    }
    return picture;
}

Image eight_bits(Image picture) {
    if (picture.sample == image::Sample::f32)
        for (float& value : picture.as<float>()) value = std::clamp(value, 0.0F, 1.0F);
    return image::to_rgba8(std::move(picture));
}

std::string thumbnail(Image picture, std::uint32_t side_px) {
    const auto levels = image::build_mips(eight_bits(std::move(picture)), true);
    const auto fits = [&](const Image& level) {
        return std::max(level.size.width, level.size.height) <= side_px;
    };
    const auto level = std::ranges::find_if(levels, fits);
    const Image& small = level == levels.end() ? levels.back() : *level;
    const auto bytes = image::encode(small, {.format = tables::ImageFormat::webp, .metadata = {}});
    if (!bytes) return {};
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return "data:image/webp;base64," + base::base64(text);
}

void compare(const Job& job, const CardOptions& options, const image::Picture& picture,
             Card& card) {
    const fs::path path = *options.baseline / recorded_path(job, job.output_of(card.item));
    std::error_code error;
    if (!fs::exists(path, error)) {
        card.problem = "not in the baseline";
        return;
    }
    card.earlier = path;
    const auto earlier = read(path);
    if (!earlier) {
        card.problem = base::to_line(earlier.error());
        return;
    }
    const auto difference = image::compare(*earlier, picture, {.heat = image::Heat::flip});
    if (!difference) {
        card.problem = base::to_line(difference.error());
        return;
    }
    card.flip = difference->flip;
    if (!options.with_pictures) return;
    card.baseline = thumbnail(image::shown(*earlier), options.side_px);
    if (difference->max_error > 0.0) card.heat = thumbnail(difference->heat, heat_px);
}

void fill(const Job& job, const CardOptions& options, Card& card) {
    if (card.result.is_null()) {
        card.problem = "not rendered";
        return;
    }
    if (card.result.value("status", "") != "done") {
        card.problem = card.result["error"].value("message", "failed");
        return;
    }
    const auto picture = read(job.output_of(card.item));
    if (!picture) {
        card.problem = base::to_line(picture.error());
        return;
    }
    if (options.with_pictures) card.picture = thumbnail(image::shown(*picture), options.side_px);
    if (options.baseline) compare(job, options, *picture, card);
}

}  // namespace

std::vector<Card> make_cards(const Job& job, const std::vector<std::size_t>& items,
                             std::vector<Json> results, const CardOptions& options,
                             base::ThreadPool& pool) {
    std::vector<Card> cards(items.size());
    std::atomic<std::size_t> made = 0;
    std::mutex telling;
    pool.parallel_for(cards.size(), [&](std::size_t i) {
        cards[i].item = items[i];
        cards[i].result = std::move(results[i]);
        fill(job, options, cards[i]);
        const double share = static_cast<double>(++made) / static_cast<double>(cards.size());
        const std::lock_guard lock(telling);
        if (options.progress) options.progress(share, "report");
    });
    return cards;
}

}  // namespace facet::batch
