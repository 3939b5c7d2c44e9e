// Formulas: LaTeX to MathML Core.
// SPDX-License-Identifier: MIT
#include "teach/formula.h"

#include "base/text.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <optional>

namespace facet::teach {
namespace {

constexpr std::size_t deepest = 40;

struct Named {
    std::string_view name;
    std::string_view text;
};
constexpr Named identifiers[] = {
    {"alpha", "α"}, {"beta", "β"},    {"gamma", "γ"},  {"delta", "δ"},  {"epsilon", "ε"},
    {"eta", "η"},   {"theta", "θ"},   {"kappa", "κ"},  {"lambda", "λ"}, {"mu", "μ"},
    {"nu", "ν"},    {"xi", "ξ"},      {"pi", "π"},     {"rho", "ρ"},    {"sigma", "σ"},
    {"tau", "τ"},   {"phi", "φ"},     {"varphi", "φ"}, {"chi", "χ"},    {"psi", "ψ"},
    {"omega", "ω"}, {"Omega", "Ω"},   {"Phi", "Φ"},    {"Lambda", "Λ"}, {"Delta", "Δ"},
    {"infty", "∞"}, {"partial", "∂"}, {"ell", "ℓ"},    {"hbar", "ħ"},   {"dots", "…"},
    {"ldots", "…"}, {"cdots", "⋯"},
};
constexpr Named operators[] = {
    {"cdot", "⋅"},   {"times", "×"},  {"leq", "≤"},    {"le", "≤"},         {"geq", "≥"},
    {"ge", "≥"},     {"approx", "≈"}, {"neq", "≠"},    {"to", "→"},         {"pm", "±"},
    {"in", "∈"},     {"sim", "∼"},    {"propto", "∝"}, {"rightarrow", "→"}, {"mid", "|"},
    {"langle", "⟨"}, {"rangle", "⟩"}, {"lbrace", "{"}, {"rbrace", "}"},     {"perp", "⊥"},
    {"equiv", "≡"},  {"ll", "≪"},     {"gg", "≫"},     {"mapsto", "↦"},     {"|", "‖"},
    {"{", "{"},      {"}", "}"},
};
constexpr Named large[] = {{"int", "∫"}, {"sum", "∑"}, {"prod", "∏"}};
constexpr std::string_view functions[] = {"cos", "sin", "tan",    "exp",    "ln",  "log",
                                          "max", "min", "arccos", "arctan", "lim", "erf"};
constexpr Named spaces[] = {{",", "0.17em"}, {";", "0.28em"}, {":", "0.22em"}, {"!", "-0.17em"},
                            {" ", "0.3em"},  {"quad", "1em"}, {"qquad", "2em"}};
constexpr Named accents[] = {
    {"vec", "→"}, {"hat", "^"}, {"bar", "¯"}, {"overline", "¯"}, {"tilde", "~"}};

template <std::size_t n>
std::optional<std::string_view> find(const Named (&list)[n], std::string_view name) {
    for (const Named& one : list)
        if (one.name == name) return one.text;
    return std::nullopt;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A piece of MathML, and how scripts sit on it.
struct Piece {
    std::string text;
    bool limits = false;  ///< scripts go above and below where the formula is displayed
};

class Parser {
public:
    Parser(std::string_view text, bool display) : text_(text), display_(display) {}

    base::Result<std::string> run() {
        std::string out = row("");
        if (!error_.empty()) return fail();
        if (at_ < text_.size()) {
            error_ = fmt::format("a closing {} without its opening", text_.substr(at_, 8));
            return fail();
        }
        return out;
    }

private:
    [[nodiscard]] tl::unexpected<base::Error> fail() const {
        return base::fail({.code = base::ErrorCode::input_invalid,
                           .what = "a formula that cannot be set: " + error_,
                           .found = std::string(text_),
                           .remedy = "facet help lessons lists what formulas may hold"});
    }
    void complain(std::string what) {
        if (error_.empty()) error_ = std::move(what);
    }

    void skip_spaces() {
        while (at_ < text_.size() &&
               (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t'))
            ++at_;
    }
    [[nodiscard]] bool starts(std::string_view what) const {
        return text_.substr(at_).starts_with(what);
    }

    /// The command at a backslash: its name. at_ is behind it afterwards.
    std::string_view command() {
        const std::size_t begin = ++at_;
        if (at_ < text_.size() && !is_letter(text_[at_]))
            return text_.substr(begin, (++at_) - begin);
        while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    /// `{...}` as it stands.
    std::string_view raw_group() {
        skip_spaces();
        if (at_ >= text_.size() || text_[at_] != '{') {
            complain("an argument in { } is missing");
            return {};
        }
        const std::size_t begin = ++at_;
        const std::size_t end = text_.find('}', begin);
        if (end == std::string_view::npos) {
            complain("a } is missing");
            at_ = text_.size();
            return {};
        }
        at_ = end + 1;
        return text_.substr(begin, end - begin);
    }

    /// Everything up to `end` ("" is the end of the text, which } and \right end too).
    std::string row(std::string_view end) {
        if (++depth_ > deepest) complain("too deep");
        std::string out;
        while (error_.empty()) {
            skip_spaces();
            if (at_ >= text_.size()) {
                if (!end.empty()) complain(fmt::format("{} is missing", end));
                break;
            }
            if (!end.empty() && starts(end)) {
                at_ += end.size();
                break;
            }
            if (text_[at_] == '}' || starts("\\right") || starts("\\end")) {
                // \rightarrow is no end.
                if (!(starts("\\right") && text_.size() > at_ + 6 && is_letter(text_[at_ + 6]))) {
                    if (!end.empty()) complain(fmt::format("{} is missing", end));
                    break;
                }
            }
            if (is_aligned_ && (text_[at_] == '&' || starts("\\\\"))) break;
            out += scripted();
        }
        --depth_;
        return out;
    }

    std::string group() {
        skip_spaces();
        if (at_ < text_.size() && text_[at_] == '{') {
            ++at_;
            return "<mrow>" + row("}") + "</mrow>";
        }
        return atom().text;
    }

    /// An atom with what is above and below it.
    std::string scripted() {
        Piece base = atom();
        std::string below, above;
        for (;;) {
            skip_spaces();
            if (at_ >= text_.size() || (text_[at_] != '^' && text_[at_] != '_')) break;
            std::string& script = text_[at_++] == '^' ? above : below;
            if (!script.empty()) complain("two scripts in one place");
            script = group();
            if (!error_.empty()) return {};
        }
        while (at_ < text_.size() && text_[at_] == '\'') {
            ++at_;
            above += "<mo>′</mo>";
        }
        if (below.empty() && above.empty()) return base.text;
        const bool limits = base.limits && display_;
        const std::string_view tag = below.empty()   ? (limits ? "mover" : "msup")
                                     : above.empty() ? (limits ? "munder" : "msub")
                                                     : (limits ? "munderover" : "msubsup");
        return fmt::format("<{0}>{1}{2}{3}</{0}>", tag, base.text, below, above);
    }

    Piece atom() {
        skip_spaces();
        if (at_ >= text_.size()) {
            complain("something is missing at its end");
            return {};
        }
        const char c = text_[at_];
        if (c == '\\') return after_backslash();
        if (c == '{') {
            ++at_;
            return {"<mrow>" + row("}") + "</mrow>"};
        }
        if (is_digit(c)) {
            const std::size_t begin = at_;
            while (at_ < text_.size() &&
                   (is_digit(text_[at_]) ||
                    (text_[at_] == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))))
                ++at_;
            return {fmt::format("<mn>{}</mn>", text_.substr(begin, at_ - begin))};
        }
        const std::string_view one = character();
        if (one.size() > 1 || is_letter(c)) return {fmt::format("<mi>{}</mi>", one)};
        if (c == '-') return {"<mo>−</mo>"};
        if (std::string_view("()[]").find(c) != std::string_view::npos)
            return {fmt::format("<mo stretchy=\"false\">{}</mo>", one)};
        if (std::string_view("+=<>,.;:/|!*~").find(c) == std::string_view::npos)
            complain(fmt::format("the sign {}", one));
        if (c == '|') return {"<mo stretchy=\"false\">|</mo>"};
        return {fmt::format("<mo>{}</mo>", base::markup_escaped(one))};
    }

    /// One UTF-8 character.
    std::string_view character() {
        const std::size_t begin = at_++;
        while (at_ < text_.size() && (static_cast<unsigned char>(text_[at_]) & 0xC0U) == 0x80U)
            ++at_;
        return text_.substr(begin, at_ - begin);
    }

    std::string delimiter() {
        skip_spaces();
        if (at_ >= text_.size()) {
            complain("a bracket is missing");
            return {};
        }
        if (text_[at_] == '\\') {
            const std::string_view name = command();
            if (const auto text = find(operators, name)) return std::string(*text);
            complain(fmt::format("no bracket \\{}", name));
            return {};
        }
        const std::string_view one = character();
        return one == "." ? "" : base::markup_escaped(one);
    }

    Piece fenced() {
        const std::string open = delimiter();
        const std::string inner = row("\\right");
        const std::string close = delimiter();
        return {fmt::format("<mrow><mo>{}</mo>{}<mo>{}</mo></mrow>", open, inner, close)};
    }

    Piece aligned() {
        const std::string_view name = raw_group();
        if (name != "aligned") {
            complain(fmt::format("\\begin{{{}}}", name));
            return {};
        }
        const bool outer = std::exchange(is_aligned_, true);
        std::string rows;
        std::string cells;
        while (error_.empty()) {
            cells += "<mtd>" + row("") + "</mtd>";
            if (at_ < text_.size() && text_[at_] == '&') {
                ++at_;
                continue;
            }
            rows += "<mtr>" + std::exchange(cells, {}) + "</mtr>";
            if (starts("\\\\")) {
                at_ += 2;
                continue;
            }
            if (!starts("\\end")) {
                complain("\\end{aligned} is missing");
                break;
            }
            at_ += 4;
            raw_group();
            break;
        }
        is_aligned_ = outer;
        return {"<mtable class=\"aligned\" displaystyle=\"true\">" + rows + "</mtable>"};
    }

    Piece after_backslash() {
        const std::string_view name = command();
        if (const auto text = find(identifiers, name)) return {fmt::format("<mi>{}</mi>", *text)};
        if (const auto text = find(operators, name)) return {fmt::format("<mo>{}</mo>", *text)};
        if (const auto text = find(large, name))
            return {fmt::format("<mo>{}</mo>", *text), name != "int"};
        if (const auto width = find(spaces, name))
            return {fmt::format("<mspace width=\"{}\"/>", *width)};
        if (std::ranges::find(functions, name) != std::end(functions)) {
            const bool limits = name == "max" || name == "min" || name == "lim";
            return {fmt::format("<mi>{}</mi>", name), limits};
        }
        if (const auto mark = find(accents, name))
            return {fmt::format("<mover accent=\"true\">{}<mo>{}</mo></mover>", group(), *mark)};
        if (name == "frac" || name == "tfrac") {
            const std::string above = group();
            return {fmt::format("<mfrac>{}{}</mfrac>", above, group())};
        }
        if (name == "sqrt") {
            skip_spaces();
            if (at_ < text_.size() && text_[at_] == '[') {
                ++at_;
                const std::string index = row("]");
                const std::string inside = group();
                return {fmt::format("<mroot>{}<mrow>{}</mrow></mroot>", inside, index)};
            }
            return {fmt::format("<msqrt>{}</msqrt>", group())};
        }
        if (name == "left") return fenced();
        if (name == "begin") return aligned();
        if (name == "text")
            return {fmt::format("<mtext>{}</mtext>", base::markup_escaped(raw_group()))};
        if (name == "mathrm" || name == "operatorname")
            return {fmt::format("<mi mathvariant=\"normal\">{}</mi>",
                                base::markup_escaped(raw_group()))};
        if (name == "mathbf")
            return {fmt::format("<mi class=\"bold\">{}</mi>", base::markup_escaped(raw_group()))};
        complain(fmt::format("\\{} is not among the commands", name));
        return {};
    }

    std::string_view text_;
    bool display_;
    bool is_aligned_ = false;
    std::size_t at_ = 0;
    std::size_t depth_ = 0;
    std::string error_;
};

}  // namespace

base::Result<std::string> mathml(std::string_view latex, bool display) {
    auto inner = Parser(latex, display).run();
    if (!inner) return inner;
    // The source stays with it: what is copied, and read aloud where MathML is not.
    return fmt::format(
        "<math{}><semantics><mrow>{}</mrow><annotation encoding=\"application/x-tex\">{}"
        "</annotation></semantics></math>",
        display ? " display=\"block\"" : "", *inner, base::markup_escaped(latex));
}

std::string plain_formula(std::string_view latex) {
    std::string out;
    for (std::size_t at = 0; at < latex.size();) {
        if (latex[at] != '\\') {
            if (latex[at] != '{' && latex[at] != '}') out += latex[at];
            ++at;
            continue;
        }
        std::size_t end = at + 1;
        while (end < latex.size() && is_letter(latex[end])) ++end;
        const std::string_view name = latex.substr(at + 1, end - at - 1);
        if (name == "cdot") {
            while (!out.empty() && out.back() == ' ') out.pop_back();
            while (end < latex.size() && latex[end] == ' ') ++end;
        }
        if (const auto text = find(identifiers, name))
            out += *text;
        else if (const auto sign = find(operators, name))
            out += name == "cdot" ? "·" : *sign;
        at = std::max(end, at + 2);
    }
    return out;
}

}  // namespace facet::teach
