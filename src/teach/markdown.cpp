// A lesson's Markdown as HTML, by md4c's parser.
// SPDX-License-Identifier: MIT
#include "teach/markdown.h"

#include "base/text.h"
#include "teach/formula.h"

#include <md4c.h>
#include <spdlog/fmt/fmt.h>

#include <limits>
#include <optional>

namespace facet::teach {
namespace {

constexpr unsigned flags = MD_FLAG_TABLES | MD_FLAG_LATEXMATHSPANS | MD_FLAG_NOHTML;

std::string_view text_of(const MD_ATTRIBUTE& attribute) { return {attribute.text, attribute.size}; }

/// One pass over a text. Subclasses say what to do; md4c's callbacks stop at the first error.
class Walker {
public:
    virtual ~Walker() = default;
    base::Status walk(std::string_view markdown) {
        MD_PARSER parser{};
        parser.flags = flags;
        parser.enter_block = [](MD_BLOCKTYPE t, void* d, void* self) {
            return static_cast<Walker*>(self)->done([&](Walker& w) { w.enter_block(t, d); });
        };
        parser.leave_block = [](MD_BLOCKTYPE t, void* d, void* self) {
            return static_cast<Walker*>(self)->done([&](Walker& w) { w.leave_block(t, d); });
        };
        parser.enter_span = [](MD_SPANTYPE t, void* d, void* self) {
            return static_cast<Walker*>(self)->done([&](Walker& w) { w.enter_span(t, d); });
        };
        parser.leave_span = [](MD_SPANTYPE t, void* d, void* self) {
            return static_cast<Walker*>(self)->done([&](Walker& w) { w.leave_span(t, d); });
        };
        parser.text = [](MD_TEXTTYPE t, const MD_CHAR* text, MD_SIZE size, void* self) {
            return static_cast<Walker*>(self)->done([&](Walker& w) { w.text(t, {text, size}); });
        };
        if (markdown.size() > std::numeric_limits<MD_SIZE>::max() / 2)
            return base::fail({.code = base::ErrorCode::limit_reached, .what = "too long a text"});
        const int code =
            md_parse(markdown.data(), static_cast<MD_SIZE>(markdown.size()), &parser, this);
        if (error_) return tl::unexpected(*error_);
        if (code != 0)
            return base::fail({.code = base::ErrorCode::internal, .what = "md4c failed"});
        return {};
    }

protected:
    virtual void enter_block(MD_BLOCKTYPE type, void* detail) = 0;
    virtual void leave_block(MD_BLOCKTYPE type, void* detail) = 0;
    virtual void enter_span(MD_SPANTYPE type, void* detail) = 0;
    virtual void leave_span(MD_SPANTYPE type, void* detail) = 0;
    virtual void text(MD_TEXTTYPE type, std::string_view text) = 0;
    void fail(base::Error error) {
        if (!error_) error_ = std::move(error);
    }

private:
    template <class Do>
    int done(const Do& act) {
        if (!error_) act(*this);
        return error_ ? 1 : 0;
    }
    std::optional<base::Error> error_;
};

Figure figure_of(std::string_view source) {
    const std::size_t colon = source.find(':');
    if (colon == std::string_view::npos) return {"", std::string(source), ""};
    return {std::string(source.substr(0, colon)), std::string(source.substr(colon + 1)), ""};
}

bool is_safe_link(std::string_view url) {
    if (url.starts_with("https://") || url.starts_with("http://") || url.starts_with('#'))
        return true;
    return url.find(':') == std::string_view::npos && !url.starts_with('/');
}

class HtmlWriter : public Walker {
public:
    explicit HtmlWriter(const FigureMaker& figure) : figure_(figure) {}
    std::string out;

private:
    void enter_block(MD_BLOCKTYPE type, void* detail) override {
        if (type == MD_BLOCK_P) {
            paragraph_ = out.size();
            has_words_ = false;
        }
        if (type == MD_BLOCK_H) {
            level_ = static_cast<MD_BLOCK_H_DETAIL*>(detail)->level;
            if (level_ == 1) title_at_ = out.size();
            out += fmt::format("<h{}>", level_);
        }
        if (type == MD_BLOCK_CODE) {
            const std::string_view language =
                text_of(static_cast<MD_BLOCK_CODE_DETAIL*>(detail)->lang);
            out += fmt::format("<pre class=\"{}\"><code>", language == "sh" ? "shell" : "code");
        }
        if (type == MD_BLOCK_TD || type == MD_BLOCK_TH) {
            const MD_ALIGN align = static_cast<MD_BLOCK_TD_DETAIL*>(detail)->align;
            out += fmt::format("<{}{}>", type == MD_BLOCK_TD ? "td" : "th",
                               align == MD_ALIGN_RIGHT ? " class=\"right\"" : "");
        }
        out += plain_tag(type, false);
    }
    void leave_block(MD_BLOCKTYPE type, void*) override {
        if (type == MD_BLOCK_P) end_paragraph();
        if (type == MD_BLOCK_H) {
            out += fmt::format("</h{}>\n", level_);
            if (level_ == 1) out.resize(title_at_);
        }
        if (type == MD_BLOCK_CODE) out += "</code></pre>\n";
        if (type == MD_BLOCK_TD) out += "</td>";
        if (type == MD_BLOCK_TH) out += "</th>";
        out += plain_tag(type, true);
    }
    void enter_span(MD_SPANTYPE type, void* detail) override {
        if (type == MD_SPAN_IMG) {
            shown_ = figure_of(text_of(static_cast<MD_SPAN_IMG_DETAIL*>(detail)->src));
            return;
        }
        if (!shown_) has_words_ = true;
        if (type == MD_SPAN_LATEXMATH || type == MD_SPAN_LATEXMATH_DISPLAY) formula_.emplace();
        if (type == MD_SPAN_A) {
            const std::string_view url = text_of(static_cast<MD_SPAN_A_DETAIL*>(detail)->href);
            if (!is_safe_link(url))
                fail({.code = base::ErrorCode::input_invalid,
                      .what = "a link that is neither https nor to a page beside this one",
                      .found = std::string(url)});
            out += fmt::format("<a href=\"{}\">", base::markup_escaped(url));
        }
        if (!shown_) out += span_tag(type, false);
    }
    void leave_span(MD_SPANTYPE type, void*) override {
        if (type == MD_SPAN_IMG) return end_figure();
        if (formula_ && (type == MD_SPAN_LATEXMATH || type == MD_SPAN_LATEXMATH_DISPLAY)) {
            auto set = mathml(*formula_, type == MD_SPAN_LATEXMATH_DISPLAY);
            if (!set) fail(set.error());
            if (set) out += *set;
            formula_.reset();
        }
        if (type == MD_SPAN_A) out += "</a>";
        if (!shown_) out += span_tag(type, true);
    }
    void text(MD_TEXTTYPE type, std::string_view text) override {
        if (type == MD_TEXT_NULLCHAR) return;
        if (formula_) {
            *formula_ += text;
            return;
        }
        std::string& to = shown_ ? shown_->caption : out;
        if (type == MD_TEXT_BR) {
            to += shown_ ? " " : "<br>";
        } else if (type == MD_TEXT_SOFTBR) {
            to += shown_ ? " " : "\n";
        } else {
            if (!shown_) has_words_ = true;
            // Entities (&nbsp;) are HTML's own already.
            to += shown_ || type == MD_TEXT_ENTITY ? std::string(text) : base::markup_escaped(text);
        }
    }

    static std::string_view plain_tag(MD_BLOCKTYPE type, bool closing) {
        switch (type) {
            case MD_BLOCK_QUOTE:
                return closing ? "</blockquote>\n" : "<blockquote>";
            case MD_BLOCK_UL:
                return closing ? "</ul>\n" : "<ul>";
            case MD_BLOCK_OL:
                return closing ? "</ol>\n" : "<ol>";
            case MD_BLOCK_LI:
                return closing ? "</li>\n" : "<li>";
            case MD_BLOCK_HR:
                return closing ? "" : "<hr>\n";
            case MD_BLOCK_TABLE:
                return closing ? "</table></div>\n" : "<div class=\"table\"><table>";
            case MD_BLOCK_THEAD:
                return closing ? "</thead>\n" : "<thead>";
            case MD_BLOCK_TBODY:
                return closing ? "</tbody>\n" : "<tbody>";
            case MD_BLOCK_TR:
                return closing ? "</tr>\n" : "<tr>";
            default:
                return "";
        }
    }
    static std::string_view span_tag(MD_SPANTYPE type, bool closing) {
        switch (type) {
            case MD_SPAN_EM:
                return closing ? "</em>" : "<em>";
            case MD_SPAN_STRONG:
                return closing ? "</strong>" : "<strong>";
            case MD_SPAN_CODE:
                return closing ? "</code>" : "<code>";
            default:
                return "";
        }
    }
    /// A paragraph of figures alone is none: they stand by themselves.
    void end_paragraph() {
        if (!has_words_) {
            out += "\n";
            return;
        }
        out.insert(paragraph_, "<p>");
        out += "</p>\n";
    }
    void end_figure() {
        if (!shown_) return;
        const Figure figure = *std::exchange(shown_, {});
        auto made = figure_(figure);
        if (!made) return fail(made.error());
        if (figure.kind == "number") has_words_ = true;
        out += *made;
    }

    const FigureMaker& figure_;
    std::optional<Figure> shown_;
    std::optional<std::string> formula_;
    std::size_t paragraph_ = 0;
    std::size_t title_at_ = 0;
    unsigned level_ = 0;
    bool has_words_ = false;
};

/// Collects what is asked for; formulas as LaTeX.
class Collector : public Walker {
public:
    std::vector<Figure> figures;
    std::vector<std::string> shells;
    std::vector<std::vector<std::string>> sections{{}};

private:
    void enter_block(MD_BLOCKTYPE type, void* detail) override {
        line_.clear();
        if (type == MD_BLOCK_H && static_cast<MD_BLOCK_H_DETAIL*>(detail)->level == 2)
            sections.emplace_back();
        is_heading_ = type == MD_BLOCK_H;
        is_shell_ = type == MD_BLOCK_CODE &&
                    text_of(static_cast<MD_BLOCK_CODE_DETAIL*>(detail)->lang) == "sh";
        if (type == MD_BLOCK_CODE) is_heading_ = true;  // code is no text
        if (is_shell_) shells.emplace_back();
    }
    void leave_block(MD_BLOCKTYPE, void*) override {
        if (!is_heading_ && !line_.empty()) sections.back().push_back(line_);
        line_.clear();
        is_shell_ = false;
    }
    void enter_span(MD_SPANTYPE type, void* detail) override {
        if (type != MD_SPAN_IMG) return;
        figures.push_back(figure_of(text_of(static_cast<MD_SPAN_IMG_DETAIL*>(detail)->src)));
        is_caption_ = true;
    }
    void leave_span(MD_SPANTYPE type, void*) override {
        if (type == MD_SPAN_IMG) is_caption_ = false;
    }
    void text(MD_TEXTTYPE type, std::string_view text) override {
        const std::string_view said = type == MD_TEXT_SOFTBR || type == MD_TEXT_BR ? " " : text;
        if (is_shell_)
            shells.back() += text;
        else if (is_caption_)
            figures.back().caption += said;
        else
            line_ += type == MD_TEXT_LATEXMATH ? plain_formula(said) : std::string(said);
    }
    std::string line_;
    bool is_heading_ = false;
    bool is_shell_ = false;
    bool is_caption_ = false;
};

Collector collected(std::string_view markdown) {
    Collector collector;
    (void)collector.walk(markdown);  // nothing in it fails
    return collector;
}

}  // namespace

base::Result<std::string> html_of(std::string_view markdown, const FigureMaker& figure) {
    HtmlWriter writer(figure);
    if (auto walked = writer.walk(markdown); !walked) return tl::unexpected(walked.error());
    return std::move(writer.out);
}

std::vector<Figure> figures_of(std::string_view markdown) { return collected(markdown).figures; }

std::vector<std::string> shell_blocks(std::string_view markdown) {
    return collected(markdown).shells;
}

std::vector<std::string> plain_section(std::string_view markdown, std::size_t index) {
    const Collector collector = collected(markdown);
    return index < collector.sections.size() ? collector.sections[index]
                                             : std::vector<std::string>{};
}

}  // namespace facet::teach
