#include "framework/app/window.hpp"

#include "framework/app/window_remote.hpp"
#include "framework/app/window_viewer.hpp"
#include "framework/math/error.hpp"

#include <SDL.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace glint {
namespace {

[[noreturn]] void fail(const std::string& what) {
    throw Error("--window: " + what + " (" + SDL_GetError() + ")");
}

void start_sdl() {
    // What shows windows; SDL would go on to drivers that draw where nobody sees it. Who sets
    // SDL_VIDEODRIVER is not overruled.
    SDL_SetHint(SDL_HINT_VIDEODRIVER,
                std::getenv("WAYLAND_DISPLAY") != nullptr ? "x11,wayland" : "x11");
    SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
    // Pixels go straight to the window: no OpenGL is set up to copy them.
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
    if (SDL_Init(SDL_INIT_VIDEO) != 0) {
        fail("there is no display to open a window on");
    }
    SDL_StopTextInput();  // keys are keys, not letters on their way to an input method
}

// Lives as long as the program, whose end closes it. Not before: SDL 2 wakes itself by messages to
// its window on a second connection, and one that arrives after the window is gone ends the program
// with BadWindow.
class Window {
  public:
    Window(const std::string& title, int width, int height)
        : window_(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                                   width, height, SDL_WINDOW_RESIZABLE)),
          arrow_(SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_ARROW)),
          sideways_(SDL_CreateSystemCursor(SDL_SYSTEM_CURSOR_SIZEWE)) {
        if (window_ == nullptr) {
            fail("the display opens no window");
        }
    }

    void show(const SrgbImage& picture) {
        // SDL only reads these pixels, but its type for them is not const.
        auto* pixels = const_cast<Rgba8*>(picture.pixels().data());
        const int pitch = picture.width() * static_cast<int>(sizeof(Rgba8));
        const std::unique_ptr<SDL_Surface, decltype(&SDL_FreeSurface)> from(
            SDL_CreateRGBSurfaceWithFormatFrom(pixels, picture.width(), picture.height(), 32, pitch,
                                               SDL_PIXELFORMAT_RGBA32),
            SDL_FreeSurface);
        SDL_Surface* to = SDL_GetWindowSurface(window_);
        if (!from || to == nullptr) {
            fail("the window takes no picture");
        }
        SDL_SetSurfaceBlendMode(from.get(), SDL_BLENDMODE_NONE);
        SDL_BlitSurface(from.get(), nullptr, to, nullptr);
        SDL_UpdateWindowSurface(window_);
    }

    void point_sideways(bool sideways) { SDL_SetCursor(sideways ? sideways_ : arrow_); }

  private:
    SDL_Window* window_;
    SDL_Cursor* arrow_;
    SDL_Cursor* sideways_;
};

// The key by its letter on the user's keyboard, else by its place on a US keyboard.
std::optional<Action> meaning_of(const SDL_Keysym& key) {
    if ((key.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) != 0) {
        return std::nullopt;
    }
    const bool shift = (key.mod & KMOD_SHIFT) != 0;
    const auto by_letter = action_of(SDL_GetKeyName(key.sym), shift);
    return by_letter ? by_letter : action_of(SDL_GetScancodeName(key.scancode), shift);
}

std::optional<MouseButton> button_of(std::uint8_t number) {
    switch (number) {
        case SDL_BUTTON_LEFT:
            return MouseButton::left;
        case SDL_BUTTON_MIDDLE:
            return MouseButton::middle;
        case SDL_BUTTON_RIGHT:
            return MouseButton::right;
        default:
            return std::nullopt;
    }
}

// Carries what happens to the window to the viewer.
class Messenger {
  public:
    Messenger(Viewer& viewer, Window& window) : viewer_(viewer), window_(window) {}

    void take(const SDL_Event& e) {
        switch (e.type) {
            case SDL_QUIT:
                viewer_.act(Action::close);
                break;
            case SDL_KEYDOWN:
                press(e.key);
                break;
            case SDL_MOUSEBUTTONDOWN:
                if (const auto button = button_of(e.button.button)) {
                    const bool shift = (SDL_GetModState() & KMOD_SHIFT) != 0;
                    mouse_.press(*button, shift, viewer_.on_split_line(e.button.x), e.button.x,
                                 e.button.y);
                }
                break;
            case SDL_MOUSEBUTTONUP:
                if (const auto button = button_of(e.button.button)) {
                    viewer_.act(mouse_.release(*button, e.button.x, e.button.y));
                }
                break;
            case SDL_MOUSEMOTION:
                viewer_.act(mouse_.move(e.motion.x, e.motion.y));
                window_.point_sideways(viewer_.on_split_line(e.motion.x));
                break;
            case SDL_MOUSEWHEEL:
                viewer_.zoom_steps(e.wheel.preciseY);
                break;
            case SDL_WINDOWEVENT:
                change(e.window);
                break;
            default:
                break;
        }
    }

    // Whether the window lost what it showed since it was last asked.
    bool lost_picture() { return std::exchange(lost_, false); }

  private:
    void press(const SDL_KeyboardEvent& key) {
        const auto action = meaning_of(key.keysym);
        if (action && (key.repeat == 0 || repeats(*action))) {
            viewer_.act(*action);
        }
    }
    void change(const SDL_WindowEvent& e) {
        if (e.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
            viewer_.resize(e.data1, e.data2);
        }
        lost_ =
            lost_ || e.event == SDL_WINDOWEVENT_EXPOSED || e.event == SDL_WINDOWEVENT_SIZE_CHANGED;
    }

    Viewer& viewer_;
    Window& window_;
    Mouse mouse_;
    bool lost_ = false;
};

// What lessons/run --watch says, on standard input: "draw" when the program was built anew, else
// words to show. Its end closes the window.
class Watch {
  public:
    explicit Watch(RemotePicture& picture) : picture_(picture), line_(SDL_RegisterEvents(1)) {
        std::thread([type = line_] {
            for (std::string line; std::getline(std::cin, line);) {
                push(type, new std::string(line));
            }
            push(SDL_QUIT, nullptr);
        }).detach();
    }

    void take(const SDL_Event& e, Viewer& viewer) {
        if (e.type == line_) {
            const std::unique_ptr<std::string> line(static_cast<std::string*>(e.user.data1));
            if (*line == "draw") {
                picture_.restart();
            } else {
                viewer.say({*line});
            }
        }
    }

  private:
    static void push(std::uint32_t type, std::string* line) {
        SDL_Event event{};
        event.type = type;
        event.user.data1 = line;
        SDL_PushEvent(&event);
    }

    RemotePicture& picture_;
    std::uint32_t line_;
};

// Until the window is closed; of a watch there may be none.
void show_until_closed(Viewer& viewer, Window& window, const Options& options, Watch* watch) {
    Messenger messenger(viewer, window);
    SDL_Event event;
    const auto take = [&] {
        messenger.take(event);
        if (watch != nullptr) {
            watch->take(event, viewer);
        }
    };
    for (int drawn = 0; !viewer.closed();) {
        // All that has happened goes into one frame, so that a slow frame does not lag behind.
        while (SDL_PollEvent(&event) != 0) {
            take();
        }
        if (messenger.lost_picture() || viewer.stale()) {
            window.show(viewer.frame());
            if (++drawn == options.frames) {
                break;
            }
        }
        if (options.frames > 0) {
            viewer.redraw();
        } else if (SDL_WaitEvent(&event) != 0) {
            take();
        }
    }
}

}  // namespace

int run_window(const Lesson& lesson, const Options& options) {
    if (draws_for_window()) {
        return draw_for_window(lesson, options);
    }
    std::unique_ptr<PictureSource> source;
    RemotePicture* remote = nullptr;
    if (window_is_watched()) {
        auto picture = std::make_unique<RemotePicture>(options);
        remote = picture.get();
        source = std::move(picture);
    } else {
        source = std::make_unique<LivePicture>(lesson, options);
    }
    Viewer viewer(std::move(source), options);
    start_sdl();
    Window window(lesson.title, options.width, options.height);
    std::optional<Watch> watch;
    if (remote != nullptr) {
        watch.emplace(*remote);
    }
    show_until_closed(viewer, window, options, watch ? &*watch : nullptr);
    return 0;
}

}  // namespace glint
