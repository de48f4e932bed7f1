// The statements of an OBJ go through tinyobjloader, a line at a time. It takes what it cannot
// read for 0 and forgets line numbers; so each line's spelling is checked before it sees it, and
// the builder, which knows the line, checks what the numbers mean.
#include "framework/geometry/obj.hpp"

#include "framework/geometry/mtl.hpp"
#include "framework/geometry/obj_builder.hpp"
#include "framework/geometry/obj_spelling.hpp"
#include "framework/geometry/obj_text.hpp"
#include "framework/math/error.hpp"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <istream>
#include <set>
#include <streambuf>

namespace glint {
namespace {

class ObjReader {
  public:
    ObjReader(std::string_view text, const std::filesystem::path& path)
        : statements_(text), path_(path), builder_(path) {}

    // The next line for tinyobjloader; false at the end.
    bool next(std::string& line) {
        while (const auto s = statements_.next()) {
            builder_.at(s->line);
            line.assign(s->keyword);
            if (checked(*s, line)) {
                line += '\n';
                return true;
            }
        }
        return false;
    }
    ObjBuilder& builder() { return builder_; }
    Obj finish();

  private:
    // Adds the words of the statement to the line, if tinyobjloader is to have it.
    bool checked(const Statement& s, std::string& line) {
        if (s.keyword == "v") {
            add_numbers(s, 3, line);
        } else if (s.keyword == "vt") {
            add_numbers(s, 1, line);
        } else if (s.keyword == "vn") {
            add_normal(s, line);
        } else if (s.keyword == "f") {
            add_corners(s, line);
        } else {
            take_over(s);
            return false;
        }
        return true;
    }
    void add_numbers(const Statement& s, int least, std::string& line);
    void add_normal(const Statement& s, std::string& line);
    void add_corners(const Statement& s, std::string& line);
    void take_over(const Statement& s);
    void read_libraries(std::string_view names);
    void read_library(const std::string& name);

    Statements statements_;
    const std::filesystem::path& path_;
    ObjBuilder builder_;
    std::set<std::string, std::less<>> libraries_;
    Tally unknown_;
    std::string unknown_keyword_;
};

void ObjReader::add_numbers(const Statement& s, int least, std::string& line) {
    std::string_view arguments = s.arguments;
    int count = 0;
    for (std::string_view word = take_word(arguments); !word.empty(); word = take_word(arguments)) {
        if (!is_number(word)) {
            builder_.fail(shown(word) + " is not a finite number");
        }
        ++count;
        (line += ' ') += word;
    }
    if (count < least) {
        builder_.fail(std::string(s.keyword) + " needs at least " + std::to_string(least) +
                      (least == 1 ? " number" : " numbers") + ", this has " +
                      std::to_string(count));
    }
}

void ObjReader::add_normal(const Statement& s, std::string& line) {
    std::string_view arguments = s.arguments;
    for (std::string_view word = take_word(arguments); !word.empty(); word = take_word(arguments)) {
        if (is_nan_or_inf(word)) {
            line += " 0 0 0";
            return;
        }
    }
    add_numbers(s, 3, line);
}

void ObjReader::add_corners(const Statement& s, std::string& line) {
    std::string_view arguments = s.arguments;
    int count = 0;
    for (std::string_view word = take_word(arguments); !word.empty(); word = take_word(arguments)) {
        if (!is_corner(word)) {
            builder_.fail(shown(word) +
                          " is not a corner of a face: v, v/t, v//n or v/t/n, "
                          "counted from 1 or backwards from -1");
        }
        ++count;
        // after a last slash tinyobjloader would read the next word
        (line += ' ') += word.substr(0, word.find_last_not_of('/') + 1);
    }
    if (count < 3) {
        builder_.fail("a face needs at least 3 corners, this has " + std::to_string(count));
    }
}

void ObjReader::take_over(const Statement& s) {
    if (s.keyword == "usemtl") {
        builder_.use_material(s.arguments);
    } else if (s.keyword == "mtllib") {
        read_libraries(s.arguments);
    } else if (!is_keyword(s.keyword)) {
        builder_.fail(shown(s.keyword) + " does not begin an OBJ statement");
    } else if (!is_passed_over(s.keyword)) {
        unknown_keyword_ = unknown_.count == 0 ? s.keyword : unknown_keyword_;
        unknown_.add(s.line);
    }
}

// One name with spaces in it, if there is such a file, or several.
void ObjReader::read_libraries(std::string_view names) {
    std::string all(names);
    std::replace(all.begin(), all.end(), '\\', '/');
    if (is_file(path_.parent_path() / all)) {
        read_library(all);
        return;
    }
    std::string_view rest = all;
    for (std::string_view name = take_word(rest); !name.empty(); name = take_word(rest)) {
        read_library(std::string(name));
    }
}

void ObjReader::read_library(const std::string& name) {
    if (!libraries_.insert(name).second) {
        return;
    }
    const std::filesystem::path file = path_.parent_path() / name;
    try {
        builder_.add_materials(parse_mtl(read_obj_text(file), file, builder_.warnings()));
    } catch (const Error& e) {
        builder_.warn(e.what());
    }
}

Obj ObjReader::finish() {
    if (unknown_.count != 0) {
        builder_.at(unknown_.first_line);
        builder_.warn(
            shown(unknown_keyword_) + " is not an OBJ statement: passed over" +
            (unknown_.count > 1 ? " (and " + std::to_string(unknown_.count - 1) + " more)" : ""));
    }
    return builder_.finish();
}

// A stream that holds one line: when tinyobjloader calls back, the builder still knows which.
class LineFeed : public std::streambuf {
  public:
    explicit LineFeed(ObjReader& reader) : reader_(reader) {}

  private:
    int_type underflow() override {
        if (!reader_.next(line_)) {
            return traits_type::eof();
        }
        setg(line_.data(), line_.data(), line_.data() + line_.size());
        return traits_type::to_int_type(line_.front());
    }
    ObjReader& reader_;
    std::string line_;
};

tinyobj::callback_t callbacks() {
    tinyobj::callback_t calls;
    calls.vertex_cb = [](void* to, float x, float y, float z, float /*w*/) {
        static_cast<ObjBuilder*>(to)->add_position({x, y, z});
    };
    calls.texcoord_cb = [](void* to, float u, float v, float /*w*/) {
        static_cast<ObjBuilder*>(to)->add_uv({u, v});
    };
    calls.normal_cb = [](void* to, float x, float y, float z) {
        static_cast<ObjBuilder*>(to)->add_normal({x, y, z});
    };
    calls.index_cb = [](void* to, tinyobj::index_t* indices, int count) {
        std::vector<Corner> face;
        for (int i = 0; i < count; ++i) {
            const tinyobj::index_t& c = indices[i];
            face.push_back({c.vertex_index, c.texcoord_index, c.normal_index});
        }
        static_cast<ObjBuilder*>(to)->add_face(face);
    };
    return calls;
}

}  // namespace

Obj parse_obj(std::string_view text, const std::filesystem::path& path) {
    check_text(text, path);
    ObjReader reader(text, path);
    LineFeed feed(reader);
    std::istream stream(&feed);
    stream.exceptions(std::ios::badbit);  // hands on what underflow() throws
    tinyobj::LoadObjWithCallback(stream, callbacks(), &reader.builder());
    return reader.finish();
}

Obj read_obj(const std::filesystem::path& path) {
    return parse_obj(read_obj_text(path), path);
}

}  // namespace glint
