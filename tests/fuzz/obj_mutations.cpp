// obj_mutations [times] [seed]: spoils the files of tests/data/obj in many ways and lets the
// reader have each; the same seed spoils them the same way. Run from the project's folder.
#include "tests/fuzz/obj_promise.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace {

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t n) {
    return n == 0 ? 0 : random() % n;
}

std::vector<std::string> read_corpus() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator("tests/data/obj")) {
        if (entry.is_regular_file()) {
            paths.push_back(entry.path());
        }
    }
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> corpus;
    for (const auto& path : paths) {
        std::ifstream file(path, std::ios::binary);
        corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return corpus;
}

// What readers of numbers and of lines stumble over.
const std::string& nasty(Random& random) {
    static const std::vector<std::string> words = {"0",
                                                   "-1",
                                                   "-0",
                                                   "1e38",
                                                   "1e39",
                                                   "-1e999",
                                                   "1e-999",
                                                   "0e999",
                                                   "nan",
                                                   "-inf",
                                                   "1.",
                                                   ".5",
                                                   ".",
                                                   "1e",
                                                   "//",
                                                   "1//",
                                                   "1/1/1",
                                                   "-2147483648",
                                                   "2147483648",
                                                   "4294967297",
                                                   "99999999999999999999",
                                                   "\\\n",
                                                   "\r\n",
                                                   "\r",
                                                   "\n",
                                                   "\n\n",
                                                   " \t ",
                                                   "#",
                                                   std::string(1, '\0'),
                                                   "\xEF\xBB\xBF",
                                                   "\xff",
                                                   "f ",
                                                   "\nf 1 2 3\n",
                                                   "\nv ",
                                                   "\nvt ",
                                                   "\nvn 0 0 0\n",
                                                   "\nusemtl ",
                                                   "\nmtllib ",
                                                   "cube.obj",
                                                   "two words.mtl",
                                                   ".",
                                                   "..",
                                                   "/",
                                                   "\nnewmtl ",
                                                   "\nKd ",
                                                   "\nNs ",
                                                   "\nmap_Kd ",
                                                   "-s 1 1 1 ",
                                                   "\nf 1 1 1\n",
                                                   std::string(300, '9'),
                                                   "\no ",
                                                   "\ncurv ",
                                                   "\nzz "};
    return words[below(random, words.size())];
}

void mutate(std::string& text, const std::vector<std::string>& corpus, Random& random) {
    const std::size_t at = below(random, text.size() + 1);
    const std::size_t length = below(random, std::min<std::size_t>(text.size() - at, 24) + 1);
    switch (below(random, 7)) {
        case 0:  // another byte
            text.replace(at, std::min<std::size_t>(length, 1), 1, static_cast<char>(random()));
            break;
        case 1:
            text.insert(at, nasty(random));
            break;
        case 2:
            text.replace(at, length, nasty(random));
            break;
        case 3:
            text.erase(at, length);
            break;
        case 4:  // twice
            text.insert(below(random, text.size() + 1), text.substr(at, length));
            break;
        case 5:  // cut short
            text.resize(at);
            break;
        default: {  // a piece of another file
            const std::string& other = corpus[below(random, corpus.size())];
            text.insert(at, other.substr(below(random, other.size()), below(random, 200)));
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int times = argc > 1 ? std::atoi(argv[1]) : 20000;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    const std::vector<std::string> corpus = read_corpus();
    if (corpus.empty()) {
        std::cerr << "no files in tests/data/obj\n";
        return 1;
    }
    std::cout << times << " mutations of " << corpus.size() << " files, seed " << seed
              << std::endl;  // now: a crash must not lose it
    Random random(seed);
    int read = 0;
    for (int i = 0; i < times; ++i) {
        std::string text = corpus[below(random, corpus.size())];
        for (std::size_t n = below(random, 3) + 1; n > 0; --n) {
            mutate(text, corpus, random);
        }
        read += glint::keeps_promise(text) ? 1 : 0;
    }
    std::cout << read << " read, " << times - read << " refused, all as promised\n";
    return read == 0 || read == times ? 1 : 0;  // then they tried nothing
}
