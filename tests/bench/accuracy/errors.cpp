#include "accuracy/errors.h"

#include <algorithm>

#include "tree/record.h"

namespace raytree::bench {
namespace {

double off(double own, Quad exact) { return static_cast<double>(abs(Quad(own) - exact)); }

template <class T> double off(const Vec3<T>& own, const Vec3<Quad>& exact) {
    return static_cast<double>(length<Quad>(vector_cast<Quad>(own) - exact));
}

void add(Errors& errors, const Rgb<double>& own, const Rgb<Quad>& exact, double largest) {
    if (exact.r <= Quad(largest) && exact.g <= Quad(largest) && exact.b <= Quad(largest)) {
        errors.add(off(own.r, exact.r));
        errors.add(off(own.g, exact.g));
        errors.add(off(own.b, exact.b));
    }
}

template <class T> bool same_shape(const Steps<T>& own, const Steps<Quad>& exact) {
    return std::ranges::equal(own.rays, exact.rays,
                              [](const auto& a, const auto& b) { return same_shape(a, b); });
}

}  // namespace

void Errors::add(double error) {
    worst = std::max(worst, error);
    squares += error * error;
    ++count;
}

template <class T> std::vector<Steps<T>> all_steps(const World<T>& world) {
    std::vector<Steps<T>> result;
    for_each_pixel(world.scene(),
                   [&](int i, int j) { result.push_back(steps_of(record_tree(world, i, j))); });
    return result;
}

Errors picture_errors(const Picture& picture, const Truth& truth, double largest) {
    Errors errors;
    for (std::size_t k = 0; k < truth.size(); ++k) {
        add(errors, picture.pixels[k], truth[k].intensity, largest);
    }
    return errors;
}

template <class T> std::size_t other_shapes(const std::vector<Steps<T>>& own, const Truth& truth) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < truth.size(); ++k) {
        count += same_shape(own[k], truth[k]) ? 0 : 1;
    }
    return count;
}

template <class T> Rounding rounding_of(const std::string& name, const std::vector<Steps<T>>& own,
                                        const Truth& truth, double size) {
    Rounding result{name, {}, {}, {}, {}, other_shapes(own, truth)};
    for (std::size_t p = 0; p < truth.size(); ++p) {
        add(result.intensity, rgb_cast<double>(own[p].intensity), truth[p].intensity, INFINITY);
        // Rays are compared as far as both trees go the same way.
        for (std::size_t k = 0; k < std::min(own[p].rays.size(), truth[p].rays.size()); ++k) {
            const Step<T>& a = own[p].rays[k];
            const Step<Quad>& b = truth[p].rays[k];
            if (a.kind != b.kind || a.level != b.level || a.object != b.object) {
                break;
            }
            const auto bounces = static_cast<std::size_t>(b.level - 1);
            result.direction.resize(std::max(result.direction.size(), bounces + 1));
            result.direction[bounces].add(off(a.direction, b.direction));
            if (b.met) {
                result.distance.add(off(static_cast<double>(a.t), b.t) / static_cast<double>(b.t));
                result.place.add(off(a.point, b.point) / size);
            }
        }
    }
    return result;
}

#define RAYTREE_INSTANTIATE(T)                                                         \
    template std::vector<Steps<T>> all_steps<T>(const World<T>&);                      \
    template std::size_t other_shapes<T>(const std::vector<Steps<T>>&, const Truth&);  \
    template Rounding rounding_of<T>(const std::string&, const std::vector<Steps<T>>&, \
                                     const Truth&, double);
RAYTREE_INSTANTIATE(float)
RAYTREE_INSTANTIATE(double)
#undef RAYTREE_INSTANTIATE
template std::vector<Steps<Quad>> all_steps<Quad>(const World<Quad>&);

}  // namespace raytree::bench
