// The loop around the workers.
// SPDX-License-Identifier: MIT
#include "batch/loop.h"

#include "batch/crew.h"
#include "batch/interrupts.h"
#include "batch/queues.h"

#include <poll.h>
#include <spdlog/fmt/fmt.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <unordered_map>

namespace facet::batch {
namespace {

using base::ErrorCode;
using Seconds = std::chrono::duration<double>;

/// Given ahead of what is drawn: one is written, one drawn, one read.
constexpr std::size_t most_in_flight = 3;
/// After a signal, for items that are nearly done; the contract gives two seconds in all.
constexpr Seconds last_orders{1.5};
constexpr int look_up_ms = 200;

std::string signal_name(int number) {
    const char* const name = ::sigdescr_np(number);
    return fmt::format("signal {}{}", number, name == nullptr ? "" : fmt::format(" ({})", name));
}

class Loop {
public:
    Loop(const LoopInputs& in, ResultsFile& results, Outcome& outcome)
        : job_(in.job),
          options_(in.options),
          results_(results),
          outcome_(outcome),
          queues_(in.job, in.items),
          crew_(in.worker, outcome.workers) {}

    base::Status work() {
        const Interrupts interrupts;
        const auto start = Clock::now();
        while (true) {
            if (const int signal = interrupts.signal(); signal != 0 && outcome_.signal == 0) {
                outcome_.signal = signal;
                abandon();
                give_up_at_ =
                    Clock::now() + std::chrono::duration_cast<Clock::duration>(last_orders);
            }
            if (auto given = give_out(); !given) return given;
            if (!is_busy() || (outcome_.signal != 0 && Clock::now() >= give_up_at_)) break;
            if (auto heard = listen(interrupts); !heard) return heard;
            if (auto timed = check_times(); !timed) return timed;
            if (fatal_) return base::fail(*fatal_);
            tell_progress(Seconds(Clock::now() - start).count());
        }
        for (Hand& hand : crew_.hands()) crew_.dismiss(hand);
        return {};
    }

private:
    void abandon() {
        queues_.clear();
        suspects_.clear();
    }

    [[nodiscard]] bool is_busy() {
        return std::ranges::any_of(crew_.hands(),
                                   [](const Hand& hand) { return !hand.in_flight.empty(); });
    }

    /// Towards the end nobody takes what another could begin at once.
    [[nodiscard]] std::size_t most_ahead() {
        const std::size_t share = queues_.size() / crew_.hands().size();
        return std::clamp<std::size_t>(share, 1, most_in_flight);
    }

    base::Status give_out() {
        for (Hand& hand : crew_.hands()) {
            // A suspect goes alone: whatever happens then is its own doing.
            if (hand.is_alone) continue;
            if (!suspects_.empty() && hand.in_flight.empty()) {
                const std::size_t item = suspects_.front();
                suspects_.pop_front();
                if (auto given = crew_.give(hand, item); !given) return given;
                hand.is_alone = true;
                continue;
            }
            while (hand.in_flight.size() < most_ahead()) {
                const auto item = queues_.next(hand.queue);
                if (!item) break;
                if (auto given = crew_.give(hand, *item); !given) return given;
            }
        }
        return {};
    }

    base::Status listen(const Interrupts& interrupts) {
        std::vector<pollfd> files;
        for (const Hand& hand : crew_.hands())
            files.push_back({.fd = hand.results, .events = POLLIN, .revents = 0});
        const timespec patience{.tv_sec = 0, .tv_nsec = look_up_ms * 1'000'000L};
        if (::ppoll(files.data(), files.size(), &patience, &interrupts.mask()) <= 0) return {};
        std::vector<std::string> lines;
        for (std::size_t i = 0; i < files.size(); ++i) {
            if (files[i].revents == 0) continue;
            Hand& hand = crew_.hands()[i];
            for (std::string& line : crew_.hear(hand)) take(hand, std::move(line), lines);
            if ((files[i].revents & (POLLHUP | POLLERR)) != 0) bury(hand, lines);
        }
        return record(lines);
    }

    /// One result: kept for the file, or tried again.
    void take(Hand& hand, std::string line, std::vector<std::string>& lines) {
        const auto found = parse_record(line, options_.limits);
        if (!found) return;  // a driver that writes to any file it finds
        const std::size_t item = found->item;
        const auto place = std::ranges::find(hand.in_flight, item);
        if (place == hand.in_flight.end()) return;
        if (place == hand.in_flight.begin()) hand.oldest_since = Clock::now();
        hand.in_flight.erase(place);
        hand.is_alone = false;
        Json json = found->json;
        const int code = json.value("code", 0);
        const unsigned attempts = ++attempts_[item];
        if (code == base::exit_code(ErrorCode::no_backend)) {
            fatal_ = base::Error{.code = ErrorCode::no_backend,
                                 .what = json["error"].value("message", "no usable GL backend")};
            return;
        }
        const bool is_odd = code == base::exit_code(ErrorCode::internal) ||
                            code == base::exit_code(ErrorCode::temporary);
        if (is_odd && attempts <= options_.retries && outcome_.signal == 0) {
            suspects_.push_back(item);
            return;
        }
        json["attempts"] = attempts;
        finish(std::move(json), found->is_done, lines);
    }

    void finish(Json json, bool is_done, std::vector<std::string>& lines) {
        attempts_.erase(json["item"].get<std::size_t>());
        lines.push_back(text_of(json));
        ended_.push_back(std::move(json));
        ++(is_done ? outcome_.done : outcome_.failed);
        if (!is_done && options_.fail_fast) abandon();
    }

    base::Status record(const std::vector<std::string>& lines) {
        if (lines.empty()) return {};
        if (auto written = results_.append(lines); !written) return written;
        if (options_.on_item)
            for (const Json& json : ended_) options_.on_item(json);
        ended_.clear();
        return {};
    }

    /// A worker is gone: whoever was alone with it was its end, of several anyone may have been.
    void bury(Hand& hand, std::vector<std::string>& lines) {
        const int status = crew_.stop(hand);
        ++outcome_.deaths;
        const std::deque<std::size_t> items = std::exchange(hand.in_flight, {});
        if (items.size() == 1) {
            const std::size_t item = items.front();
            const bool is_over = outcome_.signal != 0;
            if (++attempts_[item] <= options_.retries || is_over) {
                if (!is_over) suspects_.push_back(item);
                return;
            }
            const bool was_killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
            fail(item,
                 {.code = ErrorCode::internal,
                  .what = "the worker died",
                  .found = WIFSIGNALED(status) ? signal_name(WTERMSIG(status))
                                               : fmt::format("status {}", WEXITSTATUS(status)),
                  .remedy =
                      was_killed ? "where memory ran out, fewer --jobs or a smaller size" : ""},
                 lines);
            return;
        }
        for (const std::size_t item : items) suspects_.push_back(item);
    }

    base::Status check_times() {
        if (options_.item_timeout_s <= 0.0) return {};
        std::vector<std::string> lines;
        for (Hand& hand : crew_.hands()) {
            if (hand.in_flight.empty() ||
                Seconds(Clock::now() - hand.oldest_since).count() < options_.item_timeout_s)
                continue;
            crew_.stop(hand);
            ++outcome_.deaths;
            std::deque<std::size_t> items = std::exchange(hand.in_flight, {});
            const std::size_t late = items.front();
            items.pop_front();
            ++attempts_[late];
            fail(late,
                 {.code = ErrorCode::limit_reached,
                  .what = fmt::format("took longer than {} seconds", options_.item_timeout_s),
                  .remedy = "--item-timeout gives it more"},
                 lines);
            for (; !items.empty(); items.pop_back()) queues_.put_back(hand.queue, items.back());
        }
        return record(lines);
    }

    void fail(std::size_t index, base::Error error, std::vector<std::string>& lines) {
        ItemResult result{.item = index, .error = std::move(error), .attempts = attempts_[index]};
        result.output = recorded_path(job_, job_.output_of(index));
        result.scene = recorded_path(job_, job_.scene_of(index));
        finish(to_json(result), false, lines);
    }

    void tell_progress(double seconds) {
        if (!options_.progress) return;
        const std::size_t ended = outcome_.done + outcome_.failed;
        const double total = static_cast<double>(outcome_.total - outcome_.skipped);
        const double rate = seconds > 0.0 ? static_cast<double>(ended) * 60.0 / seconds : 0.0;
        options_.progress(
            static_cast<double>(ended) / total,
            fmt::format("{} of {}, {} failed, {:.0f} a minute", outcome_.skipped + ended,
                        outcome_.total, outcome_.failed, rate));
    }

    const Job& job_;
    const RunOptions& options_;
    ResultsFile& results_;
    Outcome& outcome_;
    Queues queues_;
    std::deque<std::size_t> suspects_;  ///< to be rendered with nothing beside them
    std::unordered_map<std::size_t, unsigned> attempts_;
    std::vector<Json> ended_;  ///< of the lines that are being recorded
    std::optional<base::Error> fatal_;
    Clock::time_point give_up_at_;
    Crew crew_;
};

}  // namespace

base::Status render_items(const LoopInputs& in, ResultsFile& results, Outcome& outcome) {
    return Loop(in, results, outcome).work();
}

}  // namespace facet::batch
