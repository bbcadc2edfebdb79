#include "check/align.h"

#include <algorithm>
#include <cmath>

#include "tree/explain.h"

namespace raytree::check {
namespace {

class Aligner {
  public:
    Aligner(const RayTree<double>& first, const RayTree<double>& second)
        : first_(first),
          second_(second),
          children_(children_of(first)),
          other_children_(children_of(second)) {
        found_.of_first.resize(first.rays.size());
        found_.of_second.resize(second.rays.size());
    }

    /// Parents stand before their children.
    Alignment run() {
        if (!first_.rays.empty() && !second_.rays.empty()) {
            pair(0, 0);
        }
        for (std::size_t ray = 0; ray < first_.rays.size(); ++ray) {
            if (found_.of_first[ray]) {
                pair_children(ray, *found_.of_first[ray]);
            }
        }
        return std::move(found_);
    }

  private:
    void pair(std::size_t ray, std::size_t other) {
        found_.of_first[ray] = other;
        found_.of_second[other] = ray;
    }

    void pair_children(std::size_t parent, std::size_t other_parent) {
        std::size_t nameless = 0;
        for (const std::size_t ray : children_[parent]) {
            const TreeRay<double>& child = first_.rays[ray];
            const std::string light = child.shadow ? child.shadow->light : "";
            auto other = corresponding(second_, other_children_[other_parent], child.kind, light);
            if (!other && child.shadow) {
                other = by_order(other_children_[other_parent], nameless, light.empty());
            }
            nameless += child.shadow ? 1 : 0;
            if (other && !found_.of_second[*other]) {
                pair(ray, *other);
            }
        }
    }

    /// Where one of the trees does not name its lights, shadow rays correspond by their order.
    std::optional<std::size_t> by_order(const std::vector<std::size_t>& children, std::size_t place,
                                        bool first_is_nameless) const {
        for (const std::size_t child : children) {
            const auto& shadow = second_.rays[child].shadow;
            if (shadow && place-- == 0) {
                return first_is_nameless || shadow->light.empty() ? std::optional(child)
                                                                  : std::nullopt;
            }
        }
        return std::nullopt;
    }

    const RayTree<double>& first_;
    const RayTree<double>& second_;
    std::vector<std::vector<std::size_t>> children_, other_children_;
    Alignment found_;
};

/// The word of a field that is one.
std::string word_of(const TreeRay<double>& ray, Field field) {
    switch (field) {
        case Field::object:
            return ray.shadow ? "" : ray.hit ? ray.hit->object : "nothing";
        case Field::side:
            return !ray.hit ? "" : ray.hit->side == Side::front ? "front" : "back";
        case Field::blocked_by:
            return !ray.shadow              ? ""
                   : ray.shadow->blocked_by ? ray.shadow->blocked_by->object
                                            : "nothing";
        case Field::light:
            return ray.shadow ? ray.shadow->light : "";
        case Field::termination:
            return ray.termination ? std::string(raytree::word_of(*ray.termination)) : "";
        default:
            return "";
    }
}

bool is_unit(Field field) {
    return field == Field::direction || field == Field::normal || field == Field::cos_incident ||
           field == Field::sin2_transmitted;
}

bool is_part_of_intensity(Field field) {
    return field == Field::ambient || field == Field::diffuse || field == Field::specular ||
           field == Field::intensity;
}

double largest(const Numbers& numbers) {
    double most = 0;
    for (int k = 0; k < numbers.size; ++k) {
        most = std::max(most, std::abs(numbers.x[static_cast<std::size_t>(k)]));
    }
    return most;
}

double error_of(Field field, const Numbers& a, const Numbers& b, double intensity) {
    double off = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        off = std::max(off, std::abs(a.x[k] - b.x[k]));
    }
    const double least = is_part_of_intensity(field) ? intensity : 0;
    const double size = is_unit(field) ? 1 : std::max({least, largest(a), largest(b)});
    return off == 0 ? 0 : off / size;
}

/// What a part of the ray's intensity is measured by: a highlight of 1e-147 is none. Of a shadow
/// ray, whose light is a part of its parent's.
double size_of_intensity(const RayTree<double>& tree, std::size_t ray) {
    constexpr double of_pixel = 1e-12;
    const std::size_t whole = tree.rays[ray].shadow ? tree.rays[ray].parent.value_or(ray) : ray;
    return std::max(largest(numbers_of(tree, whole, Field::intensity)),
                    of_pixel * largest(numbers_of(tree, 0, Field::intensity)));
}

}  // namespace

std::optional<std::size_t> corresponding(const RayTree<double>& tree,
                                         const std::vector<std::size_t>& children, RayKind kind,
                                         const std::string& light) {
    for (const std::size_t child : children) {
        const TreeRay<double>& ray = tree.rays[child];
        if (ray.kind == kind && (!ray.shadow || ray.shadow->light == light)) {
            return child;
        }
    }
    return std::nullopt;
}

Alignment align(const RayTree<double>& first, const RayTree<double>& second) {
    return Aligner(first, second).run();
}

Value value_of(const RayTree<double>& tree, std::size_t ray, Field field) {
    Value value;
    const bool unused = field == Field::intensity && tree.rays[ray].shadow;
    if (!unused) {
        value.numbers = numbers_of(tree, ray, field);
        value.word = word_of(tree.rays[ray], field);
    }
    return value;
}

std::vector<FieldDifference> differences(const RayTree<double>& first, std::size_t ray,
                                         const RayTree<double>& second, std::size_t other,
                                         double rtol) {
    std::vector<FieldDifference> found;
    const double intensity =
        std::max(size_of_intensity(first, ray), size_of_intensity(second, other));
    for (std::size_t k = 0; k < field_count; ++k) {
        const Field field = static_cast<Field>(k);
        const Value a = value_of(first, ray, field), b = value_of(second, other, field);
        const bool words = !a.word.empty() && !b.word.empty();
        if (words ? a.word != b.word : field == Field::termination && a.word != b.word) {
            found.push_back({field, a, b, 1});
        } else if (a.numbers.size == b.numbers.size) {
            const double error = error_of(field, a.numbers, b.numbers, intensity);
            if (!(error <= rtol)) {
                found.push_back({field, a, b, error});
            }
        }
    }
    return found;
}

}  // namespace raytree::check
