// Pages: a lesson as one HTML file that needs nothing beside it, and the index of all.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/texts.h"
#include "teach/gallery.h"
#include "teach/markdown.h"

#include <span>
#include <string>

namespace facet::teach {

/// Where a page is linked to; empty: nowhere.
struct PageLink {
    std::string file;
    std::string title;
};
struct PageLinks {
    PageLink before, after;
};

/// What pages are made with. Everything outlives the maker.
class PageMaker {
public:
    /// Errors: internal (the style or the script is missing).
    [[nodiscard]] static base::Result<PageMaker> create(const base::Texts& texts, Gallery& gallery);

    /// Renders, computes, and sets the lesson. Errors: input_invalid (a figure that is not there, a
    /// formula), those of the renderer; with the file of the text.
    [[nodiscard]] base::Result<std::string> lesson_page(const Lesson& lesson,
                                                        const PageLinks& links);
    /// The index, with the first picture of each lesson.
    [[nodiscard]] base::Result<std::string> index_page(std::span<const Lesson> lessons);

private:
    PageMaker(const base::Texts& texts, Gallery& gallery) : texts_(&texts), gallery_(&gallery) {}
    [[nodiscard]] base::Result<std::string> figure(const Lesson& lesson, const Figure& figure);
    [[nodiscard]] base::Result<std::string> strip(const Strip& strip, const Figure& figure);
    [[nodiscard]] std::string plot(const Plot& plot, const Figure& figure);
    [[nodiscard]] base::Result<std::string> live(const Live& live, const Figure& figure);
    [[nodiscard]] std::string numbers(const Lesson& lesson);
    [[nodiscard]] std::string whole(const std::string& title, const std::string& nav,
                                    const std::string& body, bool is_live) const;
    [[nodiscard]] std::string_view t(std::string_view key) const { return (*texts_)(key); }

    const base::Texts* texts_;
    Gallery* gallery_;
    Answers answers_;
    std::string style_;
    std::string script_;
};

/// The first paragraph of a lesson's text, without marks.
[[nodiscard]] std::string summary_of(const Lesson& lesson, std::string_view language);

}  // namespace facet::teach
