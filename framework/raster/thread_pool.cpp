#include "framework/raster/thread_pool.hpp"

#include "framework/math/error.hpp"

#include <string>

namespace glint {
namespace {

// Loops of one frame follow each other within microseconds: a short wait awake saves the
// operating system's wake-up.
constexpr int spins = 4000;

void pause_briefly() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#else
    std::this_thread::yield();
#endif
}

}  // namespace

ThreadPool::ThreadPool(int threads) {
    try {
        for (int i = 1; i < threads; ++i) {
            workers_.emplace_back([this, i] { work(i); });
        }
    } catch (...) {
        stop();
        throw Error("threads: the system starts no more than " + std::to_string(this->threads()) +
                    " of " + std::to_string(threads) + "; ask for fewer");
    }
}

ThreadPool::~ThreadPool() {
    stop();
}

void ThreadPool::stop() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
        round_.fetch_add(1, std::memory_order_release);
    }
    wake_.notify_all();
    for (std::thread& worker : workers_) {
        worker.join();
    }
}

void ThreadPool::start(std::size_t items, const Call& call) {
    call_ = &call;
    items_ = items;
    next_.store(0, std::memory_order_relaxed);
    failure_ = nullptr;
    if (items > 1 && !workers_.empty()) {
        busy_.store(static_cast<int>(workers_.size()), std::memory_order_relaxed);
        {
            const std::lock_guard lock(mutex_);
            round_.fetch_add(1, std::memory_order_release);
        }
        wake_.notify_all();
    }
    take_items(0);
    for (int i = 0; busy_.load(std::memory_order_acquire) != 0; ++i) {
        if (i < spins) {
            pause_briefly();
        } else {
            std::this_thread::yield();  // more threads than cores: let them work
        }
    }
    if (failure_) {
        std::rethrow_exception(failure_);
    }
}

void ThreadPool::take_items(int thread) {
    try {
        for (std::size_t i = next_.fetch_add(1, std::memory_order_relaxed); i < items_;
             i = next_.fetch_add(1, std::memory_order_relaxed)) {
            (*call_)(i, thread);
        }
    } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_) {
            failure_ = std::current_exception();
        }
        next_.store(items_, std::memory_order_relaxed);
    }
}

void ThreadPool::work(int thread) {
    std::uint64_t seen = 0;
    for (;;) {
        for (int i = 0; i < spins && round_.load(std::memory_order_acquire) == seen; ++i) {
            pause_briefly();
        }
        if (round_.load(std::memory_order_acquire) == seen) {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [&] { return round_.load(std::memory_order_acquire) != seen; });
        }
        seen = round_.load(std::memory_order_acquire);
        if (stop_) {
            return;
        }
        take_items(thread);
        busy_.fetch_sub(1, std::memory_order_release);
    }
}

}  // namespace glint
