#include "framework/app/window_viewer.hpp"

#include "framework/app/window_compare.hpp"
#include "framework/app/window_overlay.hpp"
#include "framework/app/window_picture.hpp"
#include "framework/image/png.hpp"
#include "framework/image/same_size.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace glint {
namespace {

constexpr int grip = 5;    // pixels beside the split line that still hold it
constexpr int margin = 8;  // pixels between panels and the window's edge

// out/name.png becomes out/name-shot.png, or -shot2 and so on where that is taken.
std::filesystem::path free_name(const std::filesystem::path& out) {
    const auto stem = out.parent_path() / out.stem();
    std::filesystem::path name = stem.string() + "-shot.png";
    for (int i = 2; std::filesystem::exists(name); ++i) {
        name = stem.string() + "-shot" + std::to_string(i) + ".png";
    }
    return name;
}

}  // namespace

Viewer::Viewer(const Lesson& lesson, const Options& options)
    : Viewer(std::make_unique<LivePicture>(lesson, options), options) {}

Viewer::Viewer(std::unique_ptr<PictureSource> source, const Options& options)
    : live_(std::move(source)) {
    if (!options.compare.empty()) {
        kept_ = read_png(options.compare);
        kept_name_ = std::filesystem::path(options.compare).filename().string();
        require_same_size(kept_, SrgbImage(options.width, options.height));
        comparison_ = Comparison::split;
    }
}

// ---- what the user does ------------------------------------------------------------------------

void Viewer::resize(int width, int height) {
    live_->resize(width, height);
}

void Viewer::act(Action action) {
    message_.clear();
    stale_ = true;
    live_->act(action);
    switch (action) {
        case Action::keep_picture:
            return keep();
        case Action::show_split:
            return compare(Comparison::split);
        case Action::show_difference:
            return compare(Comparison::difference);
        case Action::dismiss:
            return dismiss();
        case Action::show_words:
            show_words_ = !show_words_;
            return;
        case Action::show_keys:
            show_keys_ = !show_keys_;
            return;
        case Action::save:
            return save();
        case Action::close:
            closed_ = true;
            return;
        default:
            return;
    }
}

void Viewer::act(const Gesture& gesture) {
    if (gesture.kind == Gesture::Kind::split) {
        const float column = static_cast<float>(gesture.x) + 0.5F;
        split_ = std::clamp(column / static_cast<float>(options().width), 0.0F, 1.0F);
        stale_ = true;
    }
    live_->act(gesture);
}

void Viewer::zoom_steps(float steps) {
    live_->zoom_steps(steps);
}

void Viewer::redraw() {
    live_->redraw();
}

void Viewer::say(const Lines& lines) {
    said_ = lines;
    stale_ = true;
}

bool Viewer::on_split_line(int x) const {
    return comparison_ == Comparison::split && comparable() && std::abs(x - split_column()) <= grip;
}

void Viewer::compare(Comparison wanted) {
    if (kept_.empty()) {
        message_ = "nothing to compare with: K keeps this picture";
        return;
    }
    comparison_ = comparison_ == wanted ? Comparison::none : wanted;
}

void Viewer::keep() {
    kept_ = picture();
    kept_name_ = "kept picture";
    message_ = "picture kept";
    if (comparison_ == Comparison::none) {
        comparison_ = Comparison::split;
    }
}

void Viewer::save() {
    try {
        const auto name = free_name(options().outs.front());
        if (name.has_parent_path()) {
            std::filesystem::create_directories(name.parent_path());
        }
        write_png(name, picture());
        message_ = "saved " + name.string();
    } catch (const std::exception& e) {
        message_ = std::string("not saved: ") + e.what();
    }
}

void Viewer::dismiss() {
    live_->forget_probe();
    show_keys_ = false;
    comparison_ = Comparison::none;
}

bool Viewer::comparable() const {
    return kept_.width() == options().width && kept_.height() == options().height;
}

int Viewer::split_column() const {
    const int column = static_cast<int>(split_ * static_cast<float>(options().width));
    return std::min(column, options().width - 1);
}

// ---- drawing -----------------------------------------------------------------------------------

const SrgbImage& Viewer::picture() {
    stale_ = stale_ || live_->stale();
    return live_->seen().picture;
}

const SrgbImage& Viewer::frame() {
    if (stale()) {
        compose();
        stale_ = false;
    }
    return frame_;
}

void Viewer::compose() {
    const float scale = words_scale(options().height);
    std::string about_difference;
    if (comparison_ == Comparison::split && comparable()) {
        frame_ = split_picture(kept_, picture(), split_column());
    } else if (comparison_ == Comparison::difference && comparable()) {
        CodeDifference difference = code_difference(kept_, picture());
        about_difference = difference_line(difference, kept_name_);
        frame_ = std::move(difference.picture);
        draw_difference_legend(frame_, scale);
    } else {
        frame_ = picture();
    }
    int below = margin;
    if (show_words_) {
        draw_labels();
        const WordsPanel status{words(about_difference), scale};
        status.draw(frame_, margin, margin);
        below += status.height() + margin;
    }
    if (show_keys_) {
        const WordsPanel keys = fitting_panel(key_lines(), scale, options().height - 2 * margin);
        keys.draw(frame_, (options().width - keys.width()) / 2,
                  (options().height - keys.height()) / 2);
    } else if (!live_->seen().report.empty()) {
        draw_report(below);
    }
}

Lines Viewer::words(const std::string& about_difference) const {
    Lines lines = live_->seen().status;
    if (!about_difference.empty()) {
        lines.push_back(about_difference);
    }
    if (comparison_ != Comparison::none && !comparable()) {
        lines.push_back(kept_name_ + " has " + std::to_string(kept_.width()) + "x" +
                        std::to_string(kept_.height()) + " pixels: not to compare at this size");
    }
    if (!message_.empty()) {
        lines.push_back(message_);
    }
    lines.insert(lines.end(), said_.begin(), said_.end());
    lines.emplace_back("F1 keys, H hides this, Q quits");
    return lines;
}

// At the bottom: what lies left and right of the split line, or what each panel shows.
void Viewer::draw_labels() {
    const float scale = words_scale(options().height);
    const auto draw = [&](const std::string& words, int x, bool ends_there) {
        const WordsPanel label{{words}, scale};
        label.draw(frame_, ends_there ? x - label.width() : x,
                   options().height - label.height() - margin);
    };
    if (on_split_line(split_column())) {
        draw(kept_name_, split_column() - margin, true);
        draw("now", split_column() + margin, false);
        return;
    }
    for (const auto& [left, words] : live_->seen().labels) {
        draw(words, left + margin, false);
    }
}

// At the right, or below the words at the left where it would hide the pixel.
void Viewer::draw_report(int below) {
    const float scale = words_scale(options().height);
    const auto [x, y] = *options().probe;
    Lines lines = live_->seen().report;
    lines.insert(lines.begin(), "pixel " + std::to_string(x) + "," + std::to_string(y));
    WordsPanel panel = fitting_panel(lines, scale, options().height - 2 * margin);
    int left = options().width - panel.width() - margin;
    int top = margin;
    if (x >= left - margin) {
        panel = fitting_panel(lines, scale, options().height - below - margin);
        left = margin;
        top = below;
    }
    panel.draw(frame_, left, top);
    draw_mark(frame_, x, y);
}

}  // namespace glint
