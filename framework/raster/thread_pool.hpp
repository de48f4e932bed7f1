// Threads that live as long as the renderer and share out the items of a loop.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace glint {

class ThreadPool {
  public:
    // The caller is one of them; >= 1. Error where the system has no more.
    explicit ThreadPool(int threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    int threads() const { return static_cast<int>(workers_.size()) + 1; }

    // Calls task(item, thread) for every item 0..items-1, thread being 0..threads()-1; items are
    // handed out in order. Returns when all are done; the first exception is thrown on.
    template <class Task>
    void run(std::size_t items, Task&& task) {
        start(items, [&task](std::size_t item, int thread) { task(item, thread); });
    }

  private:
    using Call = std::function<void(std::size_t, int)>;
    void start(std::size_t items, const Call& call);
    void work(int thread);
    void stop();
    void take_items(int thread);

    std::vector<std::thread> workers_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::atomic<std::uint64_t> round_{0};
    std::atomic<std::size_t> next_{0};
    std::atomic<int> busy_{0};
    std::size_t items_ = 0;
    const Call* call_ = nullptr;
    std::exception_ptr failure_;
    bool stop_ = false;
};

}  // namespace glint
