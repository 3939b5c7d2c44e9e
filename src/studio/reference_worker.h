// The path-traced reference, progressing in the background on the view that is shown.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/image.h"
#include "tables/settings.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace facet::render {
struct Job;
struct Plan;
}  // namespace facet::render

namespace facet::studio {

/// How far a reference has come.
struct ReferencePicture {
    image::Image radiance;  ///< f32 [height, width, 4], nit, rows from the top
    double samples = 0.0;   ///< per pixel
    bool is_last = false;
};

/// One reference at a time, on threads of low priority: the studio's own comes first.
class ReferenceWorker {
public:
    /// `wake`: called from the worker's thread when take() has something new.
    explicit ReferenceWorker(std::function<void()> wake) : wake_(std::move(wake)) {}
    ~ReferenceWorker() { stop(); }
    ReferenceWorker(const ReferenceWorker&) = delete;
    ReferenceWorker& operator=(const ReferenceWorker&) = delete;

    /// Begins anew. The scene is copied; its pictures are shared. `plan` has the size.
    void start(const render::Job& job, const render::Plan& plan, const tables::Settings& settings,
               std::uint32_t samples);
    /// Ends the reference; what it has so far is forgotten.
    void stop();
    [[nodiscard]] bool is_running() const { return running_; }
    /// The newest picture, once.
    [[nodiscard]] std::optional<ReferencePicture> take();
    /// Why there is no picture; empty where nothing went wrong.
    [[nodiscard]] std::string trouble() const;

private:
    struct Work;
    void run(const std::shared_ptr<const Work>& work);
    void give(ReferencePicture picture);

    std::function<void()> wake_;
    std::thread thread_;
    std::atomic<bool> cancelled_ = false;
    std::atomic<bool> running_ = false;
    mutable std::mutex mutex_;
    std::optional<ReferencePicture> newest_;
    std::string trouble_;
};

}  // namespace facet::studio
