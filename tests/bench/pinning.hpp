// Which processor cores the calling thread, and those that it starts, may run on.
#pragma once

#include <sched.h>

namespace glint {

// While it lives, only the first cores of those that there were, as taskset would.
class Pinned {
  public:
    explicit Pinned(int cores) {
        sched_getaffinity(0, sizeof before_, &before_);
        cpu_set_t some;
        CPU_ZERO(&some);
        for (int core = 0; core < CPU_SETSIZE && cores > 0; ++core) {
            if (CPU_ISSET(core, &before_)) {
                CPU_SET(core, &some);
                --cores;
            }
        }
        sched_setaffinity(0, sizeof some, &some);
    }
    ~Pinned() { sched_setaffinity(0, sizeof before_, &before_); }
    Pinned(const Pinned&) = delete;
    Pinned& operator=(const Pinned&) = delete;

  private:
    cpu_set_t before_{};
};

}  // namespace glint
