#include "state/command_groups.h"

namespace raytree::inspector {
namespace {

template <int di, int dj> void move_pixel(State& state, std::string_view) {
    state.pick({state.pixel().i + di, state.pixel().j + dj}, Pick::on_the_way);
}

template <int by> void go_back(State& state, std::string_view) { state.go_back(by); }
template <int by> bool can_go_back(const State& state) {
    return state.history().at(by).has_value();
}

void pick(State& state, std::string_view argument) {
    const Pixel pixel = pixel_from(argument);
    if (!state.document()->contains(pixel)) {
        const Camera& camera = state.document()->scene().camera;
        throw InputError("", "pixel.pick",
                         "pixel " + text_of(pixel) +
                             " lies outside the picture; allowed are 0,0 to " +
                             text_of(Pixel{camera.width - 1, camera.height - 1}));
    }
    state.pick(pixel);
}

constexpr Command table[] = {
    {"pixel.pick", "", "Choose pixel", "", "Shows the ray tree of pixel I,J.", Argument::pixel,
     pick, has_scene},
    {"pixel.back", "Pixel", "Back", "Alt+Left", "Chooses the pixel that was chosen before.", none,
     go_back<-1>, can_go_back<-1>},
    {"pixel.forward", "Pixel", "Forward", "Alt+Right",
     "Chooses the pixel that had been gone back from.", none, go_back<1>, can_go_back<1>},
    {"pixel.left", "Pixel", "One to the left", "Left", "Chooses the pixel to the left.", none,
     move_pixel<-1, 0>, has_scene},
    {"pixel.right", "Pixel", "One to the right", "Right", "Chooses the pixel to the right.", none,
     move_pixel<1, 0>, has_scene},
    {"pixel.up", "Pixel", "One up", "Up", "Chooses the pixel above.", none, move_pixel<0, -1>,
     has_scene},
    {"pixel.down", "Pixel", "One down", "Down", "Chooses the pixel below.", none, move_pixel<0, 1>,
     has_scene},
    {"pixel.far_left",
     "Pixel",
     "Ten to the left",
     "Shift+Left",
     "Chooses the pixel ten to the left.",
     none,
     move_pixel<-10, 0>,
     has_scene,
     nullptr,
     {},
     true},
    {"pixel.far_right", "Pixel", "Ten to the right", "Shift+Right",
     "Chooses the pixel ten to the right.", none, move_pixel<10, 0>, has_scene},
    {"pixel.far_up", "Pixel", "Ten up", "Shift+Up", "Chooses the pixel ten above.", none,
     move_pixel<0, -10>, has_scene},
    {"pixel.far_down", "Pixel", "Ten down", "Shift+Down", "Chooses the pixel ten below.", none,
     move_pixel<0, 10>, has_scene},
    {"pixel.fit_picture",
     "Pixel",
     "Whole picture",
     "0",
     "Shows all of the picture.",
     none,
     ask<Request::fit_picture>,
     has_scene,
     nullptr,
     {},
     true},
    {"pixel.closer", "Pixel", "Picture larger",
     "Ctrl++ Ctrl+=", "Shows the picture twice as large, about the chosen pixel.", none,
     ask<Request::picture_closer>, has_scene},
    {"pixel.further", "Pixel", "Picture smaller", "Ctrl+-", "Shows the picture half as large.",
     none, ask<Request::picture_further>, has_scene},
    {"pixel.values", "Pixel", "Values around the pixel", "9",
     "Zooms onto the chosen pixel until each pixel has its raw and its 8-bit value in it.", none,
     ask<Request::picture_values>, has_scene},
};

}  // namespace

std::span<const Command> pixel_commands() { return table; }

}  // namespace raytree::inspector
