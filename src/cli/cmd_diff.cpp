// facet diff: two pictures compared by number and as a heat map.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "base/file.h"
#include "base/text.h"
#include "cli/flags.h"
#include "cli/output_gate.h"
#include "image/compare.h"
#include "image/read.h"
#include "image/write.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

namespace facet::cli {
namespace {

using base::Result;

struct DiffOptions {
    std::string a;
    std::string b;
    std::string mask;
    std::string output;
    std::optional<double> max_rmse;
    std::optional<double> max_error;
    std::optional<double> min_psnr;
};

Result<image::Picture> read(const std::string& path) {
    const base::Limits limits;
    const auto bytes = base::read_file(path, limits.file_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    auto picture = image::decode_picture(*bytes, limits);
    if (!picture) return tl::unexpected(base::in_file(picture.error(), path));
    return picture;
}

}  // namespace
}  // namespace facet::cli
