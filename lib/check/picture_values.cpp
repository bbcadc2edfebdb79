#include "check/picture_values.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "check/forge.h"
#include "scene/input_error.h"
#include "tree/explain.h"

namespace raytree::check {
namespace {

constexpr double nearby = 1e-3;  // pixels
constexpr double darkest = 1e-3;
constexpr float half_level = 0.5F / 255;

/// The scene with its window moved by a share of a pixel.
Scene moved(const Scene& scene, double columns, double rows) {
    Scene out = scene;
    Camera& camera = out.camera;
    if (const auto* fov = std::get_if<HorizontalFov>(&camera.window)) {
        const double x = std::tan(fov->degrees * Real<double>::pi / 360);
        const double y = x * camera.height / camera.width;
        camera.window = ImagePlane{-x, x, -y, y};
    }
    auto& window = std::get<ImagePlane>(camera.window);
    const double dx = columns * (window.right - window.left) / camera.width;
    const double dy = rows * (window.top - window.bottom) / camera.height;
    window.left += dx;
    window.right += dx;
    window.top -= dy;
    window.bottom -= dy;
    return out;
}

/// Secondary and shadow rays that do not see what is very near, as programs have them which start
/// them a little off the surface or at a smallest t.
constexpr double blind_share = 1e-3;

std::optional<Hit<double>> meet_blindly(const Place& place, const Step& step,
                                        Interval<double> interval) {
    if (step.kind != RayKind::primary) {
        interval.from = std::max(interval.from, blind_share);
    }
    return model::meet(place, step, interval);
}

Passage shadow_blindly(const Place& place, const Step& step, const Shine& shine) {
    const double reach = shine.distance < Real<double>::infinity ? shine.distance : 1;
    Step off = step;
    off.point = along(step.point, blind_share * reach, shine.towards);
    off.primitive = no_primitive;
    Shine rest = shine;
    rest.distance = shine.distance - blind_share * reach;
    return model::shadow(place, off, rest);
}

bool only_settings(const Rulebook& book) {
    return std::ranges::none_of(book.choices, [](const Convention* c) { return c->on_laws; });
}

}  // namespace

Spectrum colour_by(const Place& place, const Laws& laws, PixelPlace at) {
    try {
        return forge_tree(place, laws, at.i, at.j).intensity;
    } catch (const InputError&) {
        return Spectrum(std::numeric_limits<double>::quiet_NaN());
    }
}

double gamma_of(const Choices& choices) {
    const auto choice = std::ranges::find(choices, "gamma", &Convention::axis);
    const std::string_view value = choice == choices.end() ? "none" : (*choice)->value;
    return value == "2.2" ? 2.2 : value == "2" ? 2 : 1;
}

Spectrum through_curve(const Spectrum& colour, double gamma) {
    const auto curved = [gamma](double x) { return std::pow(std::max(0.0, x), 1 / gamma); };
    return gamma == 1 ? colour : Spectrum(curved(colour.r), curved(colour.g), curved(colour.b));
}

bool PixelMatch::operator()(PixelPlace at, const Spectrum& linear) const {
    const Rgb<float>& found = picture_.at(at.i, at.j);
    const Spectrum colour = through_curve(linear, gamma_);
    const std::array<double, 3> due = {colour.r, colour.g, colour.b};
    const std::array<float, 3> is = {found.r, found.g, found.b};
    for (std::size_t c = 0; c < 3; ++c) {
        if (!std::isfinite(due[c])) {
            return false;
        }
        if (!picture_.eight_bit) {
            const double size = std::max(std::abs(due[c]), darkest);
            if (std::abs(static_cast<double>(is[c]) - due[c]) > std::max(rtol_, 1e-4) * size) {
                return false;
            }
            continue;
        }
        const int level = static_cast<int>((is[c] + half_level) * 255);
        const double exact = 255 * std::clamp(due[c], 0.0, 1.0);
        if (level > std::round(exact) + 1 || level < std::floor(exact) - 1) {
            return false;
        }
    }
    return true;
}

std::size_t PixelMatch::misses(const Place& place, const Laws& laws, std::span<const PixelPlace> at,
                               std::size_t enough) const {
    std::size_t count = 0;
    for (const PixelPlace& pixel : at) {
        count += (*this)(pixel, colour_by(place, laws, pixel)) ? 0 : 1;
        if (count >= enough) {
            break;
        }
    }
    return count;
}

bool is_near_tie(const Rulebook& book, const PixelMatch& match, PixelPlace at) {
    Laws blind = book.laws;
    blind.meet = meet_blindly;
    blind.shadow = shadow_blindly;
    if (match(at, colour_by(book.place, blind, at))) {
        return true;
    }
    for (const auto& [columns, rows] : {std::pair{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
        const Scene scene = moved(book.scene, columns * nearby, rows * nearby);
        const Place place(scene);
        if (match(at, colour_by(place, book.laws, at))) {
            return true;
        }
    }
    return false;
}

Picture picture_by(const Rulebook& book) {
    if (only_settings(book)) {
        return render(book.place);
    }
    const Camera& camera = book.scene.camera;
    Picture picture{camera.width, camera.height, {}};
    picture.pixels.resize(static_cast<std::size_t>(camera.width) *
                          static_cast<std::size_t>(camera.height));
    tbb::parallel_for(0, camera.height, [&](int j) {
        for (int i = 0; i < camera.width; ++i) {
            picture.pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(camera.width) +
                           static_cast<std::size_t>(i)] = colour_by(book.place, book.laws, {i, j});
        }
    });
    return picture;
}

std::vector<PixelPlace> spread(const std::vector<PixelPlace>& from, std::size_t count) {
    if (from.size() <= count) {
        return from;
    }
    std::vector<PixelPlace> some;
    for (std::size_t k = 0; k < count; ++k) {
        // The odd part keeps the pixels from falling into columns.
        some.push_back(
            from[(k * from.size() + (k * 7919) % from.size() % (from.size() / count)) / count]);
    }
    return some;
}

}  // namespace raytree::check
