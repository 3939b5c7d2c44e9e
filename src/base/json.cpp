// JSON from outside, parsed within limits.
// SPDX-License-Identifier: MIT
#include "base/json.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace facet::base {
namespace {

/// Builds the document from parser events and stops at the first thing that is out of bounds.
template <class Json>
class Builder final : public nlohmann::json_sax<Json> {
public:
    using number_integer_t = typename Json::number_integer_t;
    using number_unsigned_t = typename Json::number_unsigned_t;
    using number_float_t = typename Json::number_float_t;
    using string_t = typename Json::string_t;
    using binary_t = typename Json::binary_t;

    explicit Builder(const Limits& limits) : limits_(limits) {}

    bool null() override { return put(Json(nullptr)); }
    bool boolean(bool value) override { return put(Json(value)); }
    bool number_integer(number_integer_t value) override { return put(Json(value)); }
    bool number_unsigned(number_unsigned_t value) override { return put(Json(value)); }
    bool number_float(number_float_t value, const string_t& text) override {
        if (!std::isfinite(value))
            return stop(ErrorCode::input_invalid, "number does not fit", text);
        constexpr double exact = 9007199254740992.0;  // 2^53
        // `1.0` is an integer in JSON; tinygltf takes it for one only when it is written as one.
        if (std::fabs(value) <= exact && std::trunc(value) == value) {
            const auto whole = static_cast<number_integer_t>(value);
            return whole < 0 ? put(Json(whole)) : put(Json(static_cast<number_unsigned_t>(whole)));
        }
        return put(Json(value));
    }
    bool string(string_t& value) override {
        const bool is_exempt = value.starts_with("data:");
        if (value.size() > limits_.json_string_bytes && !is_exempt)
            return stop(ErrorCode::limit_reached, "JSON string too long",
                        fmt::format("{} bytes", value.size()));
        return put(Json(std::move(value)));
    }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        if (name.size() > limits_.json_string_bytes)
            return stop(ErrorCode::limit_reached, "JSON key too long",
                        fmt::format("{} bytes", name.size()));
        const auto [slot, is_new] = stack_.back()->emplace(name, nullptr);
        if (!is_new) {
            stop(ErrorCode::input_invalid, "duplicate key", name);
            error_.where = place_of_innermost() + "/" + pointer_key(name);
            return false;
        }
        slot_ = &slot.value();
        return true;
    }
    bool parse_error(std::size_t at, const std::string& token,
                     const nlohmann::detail::exception& fault) override {
        // "[json.exception.parse_error.101] parse error at line 3, column 7: syntax error …": only
        // the end of it is for the user.
        std::string text = fault.what();
        if (text.find("number overflow") != std::string::npos) {
            error_ = {.code = ErrorCode::input_invalid,
                      .where = fmt::format("@{:#x}", at),
                      .what = "number does not fit",
                      .found = token};
            return false;
        }
        unsigned line = 0;
        unsigned column = 0;
        if (const auto start = text.find("at line "); start != std::string::npos)
            std::sscanf(text.c_str() + start, "at line %u, column %u", &line, &column);
        if (const auto end = text.find(": "); end != std::string::npos) text.erase(0, end + 2);
        error_ = {
            .code = ErrorCode::input_invalid,
            .where = line > 0 ? fmt::format("{}:{}", line, column) : fmt::format("@{:#x}", at),
            .what = "not valid JSON",
            .found = text};
        return false;
    }

    Error error_;
    Json root_;

private:
    bool stop(ErrorCode code, std::string what, std::string found) {
        error_ = {.code = code, .what = std::move(what), .found = std::move(found)};
        return false;
    }
    /// The pointer of the innermost container that is open.
    std::string place_of_innermost() const {
        std::string out;
        for (std::size_t i = 1; i < stack_.size(); ++i) {
            const Json& outer = *stack_[i - 1];
            std::size_t index = 0;
            for (auto it = outer.begin(); it != outer.end(); ++it, ++index)
                if (&*it == stack_[i])
                    out +=
                        "/" + (outer.is_object() ? pointer_key(it.key()) : std::to_string(index));
        }
        return out;
    }
    /// Where the next value goes; null at a limit.
    Json* place(Json&& value) {
        if (++values_ > limits_.json_values) {
            stop(ErrorCode::limit_reached, "too many JSON values",
                 fmt::format("more than {}", limits_.json_values));
            return nullptr;
        }
        if (stack_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        if (stack_.back()->is_array()) {
            stack_.back()->push_back(std::move(value));
            return &stack_.back()->back();
        }
        *slot_ = std::move(value);
        return slot_;
    }
    bool put(Json&& value) { return place(std::move(value)) != nullptr; }
    bool open(Json&& value) {
        if (stack_.size() >= limits_.json_depth)
            return stop(ErrorCode::limit_reached, "JSON nested too deep",
                        fmt::format("more than {}", limits_.json_depth));
        Json* const placed = place(std::move(value));
        if (placed == nullptr) return false;
        // Elements of an outer array do not move while an inner one is open: only the innermost
        // grows.
        stack_.push_back(placed);
        return true;
    }
    bool close() {
        stack_.pop_back();
        return true;
    }

    const Limits& limits_;
    std::vector<Json*> stack_;
    Json* slot_ = nullptr;
    std::size_t values_ = 0;
};

}  // namespace

template <class Json>
Result<Json> parse_json(std::string_view text, const Limits& limits) {
    if (text.size() > limits.json_bytes)
        return fail({.code = ErrorCode::limit_reached,
                     .what = "JSON text too large",
                     .found = fmt::format("{} bytes, limit {}", text.size(), limits.json_bytes)});
    if (text.starts_with("\xEF\xBB\xBF"))
        return fail({.code = ErrorCode::input_invalid,
                     .where = "@0x0",
                     .what = "not valid JSON: starts with a byte order mark",
                     .remedy = "save it as UTF-8 without BOM"});
    Builder<Json> builder(limits);
    bool parsed = false;
    try {
        parsed = Json::sax_parse(text.begin(), text.end(), &builder);
    } catch (const nlohmann::json::exception& fault) {
        builder.error_ = {.code = ErrorCode::input_invalid,
                          .what = std::string("not valid JSON: ") + fault.what()};
    }
    if (!parsed) return fail(std::move(builder.error_));
    return std::move(builder.root_);
}

template Result<nlohmann::json> parse_json(std::string_view, const Limits&);
template Result<nlohmann::ordered_json> parse_json(std::string_view, const Limits&);

}  // namespace facet::base
