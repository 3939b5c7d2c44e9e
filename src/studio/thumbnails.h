// Pictures of the presets: a ball of each, drawn by the frame itself.
// SPDX-License-Identifier: MIT
#pragma once

#include "studio/stage.h"
#include "studio/ui_renderer.h"

#include <memory>
#include <string>
#include <vector>

namespace facet::studio {

class Thumbnails {
public:
    explicit Thumbnails(const StageTools& tools);
    ~Thumbnails();
    Thumbnails(const Thumbnails&) = delete;
    Thumbnails& operator=(const Thumbnails&) = delete;

    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    [[nodiscard]] static Slot slot_of(std::size_t preset) {
        return static_cast<Slot>(static_cast<std::uintptr_t>(Slot::first_thumbnail) + preset);
    }
    /// Draws the next that is missing. Errors: those of rendering.
    [[nodiscard]] base::Status step(UiRenderer& pictures);
    [[nodiscard]] bool is_finished() const { return next_ >= names_.size(); }

private:
    [[nodiscard]] base::Status open();

    StageTools tools_;
    std::vector<std::string> names_;
    std::size_t next_ = 0;
    std::unique_ptr<render::Session> session_;
};

}  // namespace facet::studio
