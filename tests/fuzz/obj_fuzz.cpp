// libFuzzer's way in; CMakeLists.txt says how to run it.
#include "tests/fuzz/obj_promise.hpp"

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    glint::keeps_promise({reinterpret_cast<const char*>(data), size});
    return 0;
}
