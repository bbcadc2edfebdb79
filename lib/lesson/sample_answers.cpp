#include "lesson/sample_answers.h"

#include <algorithm>
#include <cmath>

namespace raytree::lesson {
namespace {

constexpr std::size_t most_rays = 1000;
constexpr int values = 21;

std::vector<Json> pixels_of(const Camera& camera, int in_a_row) {
    const int across = std::min(in_a_row, camera.width);
    const int down = std::min(in_a_row, camera.height);
    std::vector<Json> pixels;
    for (int k = 0; k < across * down; ++k) {
        pixels.push_back({k % across * camera.width / across, k / across * camera.height / down});
    }
    return pixels;
}

std::vector<Json> values_of(const Ask& ask) {
    std::vector<Json> all;
    for (int k = 0; k < values; ++k) {
        const double value = ask.from + (ask.to - ask.from) * k / (values - 1);
        all.emplace_back(ask.whole ? std::round(value) : value);
    }
    return all;
}

std::vector<Json> first(std::size_t count) {
    std::vector<Json> all;
    for (std::size_t k = 0; k < count; ++k) {
        all.emplace_back(k);
    }
    return all;
}

}  // namespace

std::vector<Json> sample_answers(const Play& play, std::size_t step, int pixels_in_a_row) {
    const Step& here = play.step(step);
    const Ask& ask = here.ask.value();
    const Pixel pixel = here.show.pixel;
    switch (ask.kind) {
        case AskKind::choice:
            return first(ask.options.size());
        case AskKind::pixel:
            return pixels_of(play.world(step)->scene().camera, pixels_in_a_row);
        case AskKind::ray:
            return first(
                std::min(most_rays, play.world(step)->tree_at(pixel.i, pixel.j)->rays.size()));
        case AskKind::value:
            return values_of(ask);
        default: {
            const double truth = ask.truth.number(*play.scope(step));
            return {truth, truth + 1 + ask.tolerance, truth - 1 - ask.tolerance, -truth, 0.0};
        }
    }
}

}  // namespace raytree::lesson
