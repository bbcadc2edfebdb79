#include <algorithm>
#include <cmath>

#include "check/catalogue.h"
#include "check/film.h"
#include "check/not_unit.h"

namespace raytree::check {
namespace {

constexpr std::string_view topic = "the camera and primary rays";

Beam scaled(const Place& place, const Step& step, double sx, double sy) {
    const FilmPoint at = film_of(place, step);
    return beam_through(place, {at.x * sx, at.y * sy});
}

Beam at_pixel(const Place& place, double column, double row) {
    const Camera& camera = place.scene().camera;
    return beam_through(place, film_at(place, column / camera.width, row / camera.height));
}

Beam over_one_less(const Place& place, double column, double row) {
    const Camera& camera = place.scene().camera;
    return beam_through(place, film_at(place, column / std::max(1.0, camera.width - 1.0),
                                       row / std::max(1.0, camera.height - 1.0)));
}

double offset(const Place& place) {
    return place.scene().settings.pixel_sample == PixelSample::center ? 0.5 : 0;
}

Beam along_axes(const Place& place, const Step& step, const Vec& forward, const Vec& right,
                const Vec& up) {
    const FilmPoint at = film_of(place, step);
    return {place.scene().camera.eye, forward + at.x * right + at.y * up};
}

Beam symmetric_window(const Place& place, const Step& step) {
    const auto* plane = std::get_if<ImagePlane>(&place.scene().camera.window);
    if (!plane) {
        return model::primary(place, step);
    }
    const Camera& camera = place.scene().camera;
    const double u = (step.pixel_i + offset(place)) / camera.width;
    const double v = (step.pixel_j + offset(place)) / camera.height;
    return beam_through(place, {(2 * u - 1) * plane->right, (1 - 2 * v) * plane->top});
}

Beam look_at_as_direction(const Place& place, const Step& step) {
    const Camera& camera = place.scene().camera;
    if (!(largest_component(camera.look_at) > 0)) {
        return model::primary(place, step);
    }
    const Vec forward = model::unit(camera.look_at);
    const Vec right = model::unit(outer(forward, camera.up));
    return along_axes(place, step, forward, right, outer(right, forward));
}

/// The window follows from the tangent of another angle than half the field of view.
template <double (*angle)(double half)> void by_tangent(Laws& laws) {
    laws.primary = [](const Place& place, const Step& step) {
        const auto half = half_fov(place);
        const double scale = half ? std::tan(angle(*half)) / std::tan(*half) : 1;
        return scaled(place, step, scale, scale);
    };
}

template <int x, int y> void axes_times(Laws& laws) {
    laws.primary = [](const Place& place, const Step& step) { return scaled(place, step, x, y); };
}

const MistakeRow rows[] = {
    {"cam.no_half",
     "The ray goes through the pixel's corner: the half pixel is not added.",
     topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return at_pixel(place, step.pixel_i, step.pixel_j);
         };
     },
     {[](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return at_pixel(place, step.pixel_i, step.pixel_j + 1);
         };
     }}},
    {"cam.half_added_twice", "Half a pixel is added where the scene samples corners.", topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return at_pixel(place, step.pixel_i + offset(place) + 0.5,
                             step.pixel_j + offset(place) + 0.5);
         };
     }},
    {"cam.wminus1",
     "The pixel's column and row are divided by width - 1 and height - 1.",
     topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return over_one_less(place, step.pixel_i, step.pixel_j);
         };
     },
     {[](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return over_one_less(place, step.pixel_i + 0.5, step.pixel_j + 0.5);
         };
     }}},
    {"cam.row_off_by_one",
     "The row is one too far down or up.",
     topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return at_pixel(place, step.pixel_i + offset(place), step.pixel_j + offset(place) + 1);
         };
     },
     {[](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return at_pixel(place, step.pixel_i + offset(place), step.pixel_j + offset(place) - 1);
         };
     }}},
    {"cam.ij_swapped",
     "Column and row are exchanged.",
     topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return at_pixel(place, step.pixel_j + offset(place), step.pixel_i + offset(place));
         };
     },
     {[](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             const Camera& camera = place.scene().camera;
             return beam_through(place,
                                 film_at(place, (step.pixel_j + offset(place)) / camera.height,
                                         (step.pixel_i + offset(place)) / camera.width));
         };
     }}},
    {"cam.fov_not_halved", "The tangent is taken of the whole field of view, not of half.", topic,
     by_tangent<[](double half) { return 2 * half; }>},
    {"cam.fov_halved_twice", "The field of view is halved twice.", topic,
     by_tangent<[](double half) { return half / 2; }>},
    {"cam.fov_degrees", "The tangent is taken of degrees as if they were radians.", topic,
     by_tangent<[](double half) { return half * 180 / Real<double>::pi; }>},
    {"cam.fov_angle_for_tangent", "The angle itself is used where its tangent belongs.", topic,
     by_tangent<[](double half) { return std::atan(half); }>},
    {"cam.fov_horizontal",
     "The field of view is taken for that of the other axis.",
     topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return scaled(place, step, aspect_of(place), aspect_of(place));
         };
     },
     {[](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return scaled(place, step, 1 / aspect_of(place), 1 / aspect_of(place));
         };
     }}},
    {"cam.aspect_inverted",
     "Height over width is used for the aspect, or the other way round.",
     topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return scaled(place, step, 1, aspect_of(place) * aspect_of(place));
         };
     },
     {[](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return scaled(place, step, 1 / (aspect_of(place) * aspect_of(place)), 1);
         };
     }}},
    {"cam.aspect_missing",
     "The picture's aspect is left out, or cut off to a whole number.",
     topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return scaled(place, step, 1, aspect_of(place));
         };
     },
     {[](Laws& laws) {
          laws.primary = [](const Place& place, const Step& step) {
              return scaled(place, step, 1 / aspect_of(place), 1);
          };
      },
      [](Laws& laws) {
          laws.primary = [](const Place& place, const Step& step) {
              const double whole = std::max(1.0, std::trunc(aspect_of(place)));
              return scaled(place, step, 1, aspect_of(place) / whole);
          };
      }}},
    {"cam.y_flipped",
     "Rows are counted from below: the picture stands on its head.",
     topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return at_pixel(place, step.pixel_i + offset(place),
                             place.scene().camera.height - step.pixel_j - offset(place));
         };
     },
     {axes_times<1, -1>}},
    {"cam.row_flipped_h_minus_j",
     "Rows are flipped by height - j and not height - 1 - j: one row off.",
     topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return at_pixel(place, step.pixel_i + offset(place),
                             place.scene().camera.height - step.pixel_j + offset(place));
         };
     },
     {[](Laws& laws) {  // and counted from below, so that the picture stands upright
         laws.primary = [](const Place& place, const Step& step) {
             return at_pixel(place, step.pixel_i + offset(place), step.pixel_j + offset(place) - 1);
         };
     }}},
    {"cam.mirrored",
     "Left and right are exchanged: the cross product is the wrong way round.",
     topic,
     axes_times<-1, 1>,
     {[](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return at_pixel(place, place.scene().camera.width - step.pixel_i - offset(place),
                             step.pixel_j + offset(place));
         };
     }}},
    {"cam.turned_round", "Both axes are reversed: the picture is turned by half a turn.", topic,
     axes_times<-1, -1>},
    {"cam.lookat_as_dir", "The look-at point is used as the viewing direction.", topic,
     [](Laws& laws) { laws.primary = look_at_as_direction; }},
    {"cam.looks_back",
     "The camera looks backwards: eye - look-at instead of look-at - eye.",
     topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return along_axes(place, step, -place.camera.forward().vec(),
                               place.camera.right().vec(), place.camera.up());
         };
     },
     {[](Laws& laws) {  // the cross products follow
         laws.primary = [](const Place& place, const Step& step) {
             return along_axes(place, step, -place.camera.forward().vec(),
                               -place.camera.right().vec(), place.camera.up());
         };
     }}},
    {"cam.up_not_orthogonalised", "The given up vector is used as it is, not made perpendicular.",
     topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return along_axes(place, step, place.camera.forward().vec(),
                               place.camera.right().vec(), model::unit(place.scene().camera.up));
         };
     }},
    {"cam.right_not_normalised", "Vx is not made unit, nor is Vy then.", topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             const Vec forward = place.camera.forward().vec();
             const Vec right = outer(forward, place.scene().camera.up);
             return along_axes(place, step, forward, right, outer(right, forward));
         };
     }},
    {"cam.forward_not_normalised", "The viewing direction is not made unit.", topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             const Camera& camera = place.scene().camera;
             return along_axes(place, step, camera.look_at - camera.eye, place.camera.right().vec(),
                               place.camera.up());
         };
     }},
    {"cam.target_as_dir", "The point on the image plane is used as the direction.", topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             const Beam beam = beam_through(place, film_of(place, step));
             return Beam{beam.origin, beam.origin + beam.direction};
         };
     }},
    {"cam.origin_is_pixel", "The ray starts on the image plane and not at the eye.", topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             const Beam beam = beam_through(place, film_of(place, step));
             return Beam{beam.origin + beam.direction, beam.direction};
         };
     }},
    {"cam.eye_ignored", "The ray starts at the origin and not at the eye.", topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step& step) {
             return Beam{Vec(0.0), model::primary(place, step).direction};
         };
     }},
    {"cam.dir_not_normalised",
     "The primary direction is not made unit and is used for V as if it were.",
     topic,
     [](Laws& laws) {
         laws.primary = primary_not_unit;
         laws.specular = highlight_not_unit;
     },
     {[](Laws& laws) {
         laws.primary = primary_not_unit;
         laws.specular = highlight_not_unit;
         laws.refracted = refracted_not_unit;
     }}},
    {"cam.window_symmetric", "The window's left and bottom are ignored, as if it were symmetric.",
     topic, [](Laws& laws) { laws.primary = symmetric_window; }},
    {"num.int_division", "Column over width is divided in whole numbers, which is always 0.", topic,
     [](Laws& laws) {
         laws.primary = [](const Place& place, const Step&) {
             return beam_through(place, film_at(place, 0, 0));
         };
     }},
};

}  // namespace

std::span<const MistakeRow> camera_mistakes() { return rows; }

}  // namespace raytree::check
