// Renders one item after another, and keeps what they share.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/log.h"
#include "base/thread_pool.h"
#include "batch/result.h"
#include "gl/context.h"
#include "render/assets.h"
#include "render/picture_file.h"

#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <optional>

namespace facet::render {
class Session;
struct Plan;
}  // namespace facet::render

namespace facet::batch {

/// A picture that waits to be written.
struct Drawn {
    render::PictureFile file;
    render::Request request;
    render::Rendered rendered;
    std::optional<Shot> shot;
};

class Renderer {
public:
    struct Inputs {
        const Job& job;
        base::ThreadPool& pool;
        base::Log& log;
        std::size_t asset_bytes = 0;           ///< that read scenes and environments may take
        std::filesystem::path cache_folder{};  ///< render::Request's
    };
    explicit Renderer(const Inputs& in);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Begins to read what an item needs and is not there, beside what is drawn meanwhile.
    void prepare(const Item& item);
    /// Errors: as render::render_to_file() but for writing; what was shared before still is.
    [[nodiscard]] base::Result<Drawn> draw(const Item& item);

private:
    struct Loading {
        std::string scene;
        std::future<void> done;  ///< into assets_
    };
    [[nodiscard]] base::Status show(const render::Request& request, const render::Plan& plan,
                                    render::Rendered& out);
    /// The one exposure of a sequence: that of its first frame.
    [[nodiscard]] base::Result<double> exposure_of(std::size_t first);

    Inputs in_;
    render::Assets assets_;
    gl::Backend backend_ = gl::Backend::automatic;  ///< that gl_ was asked for
    std::optional<gl::Context> gl_;
    std::unique_ptr<render::Session> session_;
    std::string shown_;  ///< the session's scene and how it was read; empty: none
    std::optional<Loading> loading_;
    std::map<std::size_t, double> exposures_;  ///< by a sequence's first item
};

}  // namespace facet::batch
