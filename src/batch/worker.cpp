// A worker: a process of its own that renders items as it is told.
// SPDX-License-Identifier: MIT
#include "batch/worker.h"

#include "base/cache_folder.h"
#include "base/file.h"
#include "base/text.h"
#include "batch/input_hash.h"
#include "batch/renderer.h"
#include "batch/state.h"

#include <malloc.h>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <new>
#include <thread>

namespace facet::batch {
namespace {

std::uint64_t peak_rss_bytes() {
    struct rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

base::Error out_of_memory() {
    return {.code = base::ErrorCode::limit_reached,
            .what = "out of memory",
            .remedy = "a smaller size, or fewer --jobs"};
}

/// The folder of an output, made; what cannot be written is told before it is rendered.
base::Status make_place(const std::filesystem::path& output) {
    std::error_code error;
    const std::filesystem::path folder = output.parent_path();
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (!error && !folder.empty() && !std::filesystem::is_directory(folder, error) && !error)
        error = std::make_error_code(std::errc::not_a_directory);
    if (!error) return base::check_writable(output);
    const bool is_full = error == std::errc::no_space_on_device;
    return base::fail(
        {.code = is_full ? base::ErrorCode::temporary : base::ErrorCode::input_invalid,
         .file = folder.string(),
         .what = "cannot be made: " + error.message()});
}

/// Numbers of items, as they come in.
class Orders {
public:
    explicit Orders(int file) : file_(file) {}

    /// What is waiting; where nothing is, waits for something. Empty at the end.
    std::deque<std::size_t>& waiting() {
        while (!ended_ && (waiting_.empty() || has_more())) read();
        return waiting_;
    }

private:
    [[nodiscard]] bool has_more() const {
        pollfd one{.fd = file_, .events = POLLIN, .revents = 0};
        return ::poll(&one, 1, 0) > 0;
    }
    void read() {
        std::array<char, 4096> bytes{};
        const ssize_t count = ::read(file_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) return;
        if (count <= 0) {
            ended_ = true;
            return;
        }
        text_.append(bytes.data(), static_cast<std::size_t>(count));
        for (std::size_t end = 0; (end = text_.find('\n')) != std::string::npos;) {
            if (const auto index = base::parse_integer(text_.substr(0, end)))
                waiting_.push_back(static_cast<std::size_t>(*index));
            text_.erase(0, end + 1);
        }
    }

    int file_;
    bool ended_ = false;
    std::string text_;
    std::deque<std::size_t> waiting_;
};

/// Result lines, whole ones whichever thread sends them.
class Reports {
public:
    explicit Reports(int file) : file_(file) {}
    void send(const ItemResult& result) {
        const std::string line = to_line(result) + '\n';
        const std::lock_guard lock(mutex_);
        for (std::size_t put = 0; put < line.size();) {
            const ssize_t count = ::write(file_, line.data() + put, line.size() - put);
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) std::_Exit(1);  // the parent is gone
            put += static_cast<std::size_t>(count);
        }
    }

private:
    int file_;
    std::mutex mutex_;
};

/// Writes pictures beside the drawing of the next one.
class Writer {
public:
    Writer(const Job& job, Reports& reports)
        : job_(job), reports_(reports), thread_([this] { run(); }) {}
    ~Writer() {
        {
            const std::lock_guard lock(mutex_);
            ended_ = true;
        }
        changed_.notify_all();
        thread_.join();
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    /// Waits while the one before is not written: one picture in hand, not a heap of them.
    void write(Drawn drawn, ItemResult result) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !next_; });
        next_.emplace(std::move(drawn), std::move(result));
        changed_.notify_all();
    }

private:
    void run() {
        while (true) {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [&] { return next_ || ended_; });
            if (!next_) return;
            auto [drawn, result] = std::move(*next_);
            next_.reset();
            changed_.notify_all();
            lock.unlock();
            write_one(drawn, result);
        }
    }
    void write_one(Drawn& drawn, ItemResult& result) {
        try {
            const auto written = render::write_picture(drawn.file, drawn.request, drawn.rendered);
            if (written) {
                result.sha256 = written->sha256;
                for (const auto& side : written->sides)
                    result.sides.push_back(recorded_path(job_, side));
            } else {
                result.error = written.error();
            }
        } catch (const std::bad_alloc&) {
            result.error = out_of_memory();
        }
        result.ms = drawn.rendered.ms;
        result.peak_rss = peak_rss_bytes();
        reports_.send(result);
    }

    const Job& job_;
    Reports& reports_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<std::pair<Drawn, ItemResult>> next_;
    bool ended_ = false;
    std::thread thread_;
};

class Worker {
public:
    Worker(const WorkerInputs& in, int results)
        : in_(in),
          log_(in.level),
          pool_(in.thread_count),
          hashes_(in.limits),
          renderer_({.job = in.job,
                     .pool = pool_,
                     .log = log_,
                     .asset_bytes = in.asset_bytes,
                     .cache_folder = base::cache_folder()}),
          reports_(results),
          writer_(in.job, reports_) {}

    void render(std::size_t index, const std::deque<std::size_t>& next) {
        ItemResult result{.item = index, .program = in_.program};
        try {
            const auto item = in_.job.item(index);
            if (!item) return fail(result, item.error());
            result.output = recorded_path(in_.job, item->output);
            result.scene = recorded_path(in_.job, item->scene);
            result.varied = item->varied;
            // Before anything is read: a file that changes later is then found to have changed.
            result.input = hashes_.of(in_.job, *item);
            if (auto place = make_place(item->output); !place) return fail(result, place.error());
            if (!next.empty())
                if (const auto after = in_.job.item(next.front())) renderer_.prepare(*after);
            auto drawn = renderer_.draw(*item);
            if (!drawn) return fail(result, drawn.error());
            result.exposure = drawn->rendered.exposure;
            result.warnings = drawn->rendered.warnings;
            result.shot = drawn->shot;
            writer_.write(std::move(*drawn), std::move(result));
        } catch (const std::bad_alloc&) {
            fail(result, out_of_memory());
        } catch (const std::exception& fault) {
            fail(result, {.what = "internal error", .found = fault.what()});
        }
    }

private:
    void fail(ItemResult& result, base::Error error) {
        result.error = std::move(error);
        result.peak_rss = peak_rss_bytes();
        reports_.send(result);
    }

    const WorkerInputs& in_;
    base::Log log_;
    base::ThreadPool pool_;
    InputHashes hashes_;
    Renderer renderer_;
    Reports reports_;
    Writer writer_;
};

}  // namespace

void work(const WorkerInputs& in, int commands, int results) {
    // Decoded pictures go back to the system when they are freed, and what is read back for every
    // picture does not: glibc would in time keep both.
    ::mallopt(M_MMAP_THRESHOLD, 4 << 20);
    ::mallopt(M_TRIM_THRESHOLD, 32 << 20);
    ::mallopt(M_ARENA_MAX, 2);
    // Called once in a process: its GL is set up before any library of it is loaded.
    ::setenv("LP_NUM_THREADS", in.thread_count == 1 ? "0" : std::to_string(in.thread_count).c_str(),
             0);
    gl::prepare_environment(0);
    Worker worker(in, results);
    Orders orders(commands);
    while (true) {
        auto& waiting = orders.waiting();
        if (waiting.empty()) return;
        const std::size_t index = waiting.front();
        waiting.pop_front();
        worker.render(index, waiting);
    }
}

}  // namespace facet::batch
