#include "check/catalogue.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "normals";

/// A normal turned to the ray as the model turns it.
Turned turned(const Step& step, const Vec& normal) {
    const bool front = inner(step.direction, step.outward) < 0;
    return {front ? normal : -normal, front};
}

const Object& object_of(const Place& place, const Step& step) {
    return place.scene().objects[place.shapes.shapes()[step.primitive].object];
}

/// M v of the linear part, or its transpose.
Vec times(const Affine& m, const Vec& v, bool transposed) {
    Vec result(0.0);
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const auto row = static_cast<std::size_t>(transposed ? k : i);
            const auto column = static_cast<std::size_t>(transposed ? i : k);
            result[i] += m[row][column] * v[k];
        }
    }
    return result;
}

/// The normal in the object's own space.
Vec own_normal(const Affine& m, const Step& step) {
    return model::unit(times(m, step.shading, true));
}

template <class Change> Turned of_transformed(const Place& place, const Step& step, Change change) {
    const Object& object = object_of(place, step);
    return turned(step, object.transform ? model::unit(change(*object.transform)) : step.shading);
}

Turned by_forward_matrix(const Place& place, const Step& step) {
    return of_transformed(place, step,
                          [&](const Affine& m) { return times(m, own_normal(m, step), false); });
}

Turned from_world_centre(const Place& place, const Step& step) {
    const Object& object = object_of(place, step);
    const auto* sphere = std::get_if<Sphere>(&object.shape);
    if (!sphere || !object.transform) {
        return turned(step, step.shading);
    }
    const Affine& m = *object.transform;
    const Vec centre = times(m, sphere->center, false) + Vec(m[0][3], m[1][3], m[2][3]);
    return turned(step, model::unit(step.point - centre));
}

Turned by_inverse(const Place& place, const Step& step) {
    return of_transformed(place, step, [&](const Affine& m) {
        // The linear part of the inverse map, applied to the own normal.
        const AffineMap<double> map(m);
        Ray<double> ray;
        ray.direction = own_normal(m, step);
        return map.ray_to_own_space(ray).direction;
    });
}

Turned as_a_point(const Place& place, const Step& step) {
    return of_transformed(place, step, [&](const Affine& m) {
        return times(m, own_normal(m, step), false) + Vec(m[0][3], m[1][3], m[2][3]);
    });
}

Turned not_unit(const Place& place, const Step& step) {
    const auto* sphere = std::get_if<Sphere>(&object_of(place, step).shape);
    return turned(step, sphere ? sphere->radius * step.shading : step.shading);
}

const MistakeRow rows[] = {
    {"nrm.forward_matrix", "The normal is taken to the world by the matrix of the points.", topic,
     [](Laws& laws) { laws.normal = by_forward_matrix; }},
    {"nrm.p_minus_c", "The normal of a stretched ball is taken as point - centre.", topic,
     [](Laws& laws) { laws.normal = from_world_centre; }},
    {"nrm.object_space", "The normal stays in the object's own space.", topic,
     [](Laws& laws) {
         laws.normal = [](const Place& place, const Step& step) {
             return of_transformed(place, step,
                                   [&](const Affine& m) { return own_normal(m, step); });
         };
     }},
    {"nrm.inverse_not_transposed", "The normal is taken to the world by the inverse, untransposed.",
     topic, [](Laws& laws) { laws.normal = by_inverse; }},
    {"nrm.homogeneous_point", "The normal is moved like a point: its w is 1 instead of 0.", topic,
     [](Laws& laws) { laws.normal = as_a_point; }},
    {"nrm.from_origin", "The normal is the hit point made unit: the centre is not subtracted.",
     topic,
     [](Laws& laws) {
         laws.normal = [](const Place& place, const Step& step) {
             const bool ball = std::holds_alternative<Sphere>(object_of(place, step).shape);
             return turned(step, ball ? model::unit(step.point) : step.shading);
         };
     }},
    {"nrm.inverted", "The normal points the wrong way.", topic,
     [](Laws& laws) {
         laws.normal = [](const Place& place, const Step& step) {
             const Turned right = model::normal(place, step);
             return Turned{-right.normal, right.front};
         };
     }},
    {"nrm.not_normalised", "The normal is not made unit: it has the radius for its length.", topic,
     [](Laws& laws) { laws.normal = not_unit; }},
    {"nrm.not_flipped_inside", "The normal is not turned to the ray on back sides.", topic,
     [](Laws& laws) {
         laws.normal = [](const Place&, const Step& step) {
             return Turned{step.shading, inner(step.direction, step.outward) < 0};
         };
     }},
    {"nrm.flat_for_smooth", "The face's normal is used where vertex normals are given.", topic,
     [](Laws& laws) {
         laws.normal = [](const Place&, const Step& step) { return turned(step, step.outward); };
     }},
    {"nrm.side_swapped", "Front and back are exchanged.", topic,
     [](Laws& laws) {
         laws.normal = [](const Place& place, const Step& step) {
             const Turned right = model::normal(place, step);
             return Turned{right.normal, !right.front};
         };
     }},
};

}  // namespace

std::span<const MistakeRow> normal_mistakes() { return rows; }

}  // namespace raytree::check
