#include "check/whole.h"

#include <algorithm>
#include <cmath>

#include "check/laws.h"

namespace raytree::check {
namespace {

/// Whether two numbers, or points, are the same but for the digits of a file.
struct Near {
    double close;

    bool operator()(double a, double b) const {
        return std::abs(a - b) <= close * std::max(1.0, std::abs(b));
    }
    bool operator()(const Point& a, const Point& b) const {
        return largest_component(a - b) <= close * std::max(1.0, largest_component(b));
    }
    bool operator()(const ImagePlane& a, const ImagePlane& b) const {
        return (*this)(a.left, b.left) && (*this)(a.right, b.right) &&
               (*this)(a.bottom, b.bottom) && (*this)(a.top, b.top);
    }
};

/// The window on the plane at distance 1, whichever way the camera gives it.
ImagePlane window_of(const Camera& camera) {
    if (const auto* plane = std::get_if<ImagePlane>(&camera.window)) {
        return *plane;
    }
    const double x =
        std::tan(std::get<HorizontalFov>(camera.window).degrees * Real<double>::pi / 360);
    const double y = x * camera.height / camera.width;
    return {-x, x, -y, y};
}

/// Whether both cameras send the same rays: `up` may have another length, or lean.
bool same(const Camera& a, const Camera& b, const Near& near) {
    const auto right = [](const Camera& camera) {
        return model::unit(outer(camera.look_at - camera.eye, camera.up));
    };
    return near(a.eye, b.eye) && a.width == b.width && a.height == b.height &&
           near(model::unit(a.look_at - a.eye), model::unit(b.look_at - b.eye)) &&
           near(right(a), right(b)) && near(a.near, b.near) && near(window_of(a), window_of(b));
}

/// A setting that the submission states, other than the scene's. What it leaves out is read as the
/// default.
std::string other_setting(const Settings& stated, const Settings& due) {
    const Settings usual;
    const auto differs = [](const auto& a, const auto& b, const auto& c) {
        return a != b && a != c;
    };
    if (differs(stated.max_depth, due.max_depth, usual.max_depth)) {
        return "max_depth";
    }
    if (differs(stated.specular_model, due.specular_model, usual.specular_model)) {
        return "specular_model";
    }
    if (differs(stated.shadows, due.shadows, usual.shadows)) {
        return "shadows";
    }
    if (differs(stated.pixel_sample, due.pixel_sample, usual.pixel_sample)) {
        return "pixel_sample";
    }
    const bool reflects = stated.total_internal_reflection != due.total_internal_reflection &&
                          stated.total_internal_reflection != usual.total_internal_reflection;
    return reflects ? "total_internal_reflection" : "";
}

/// Whether a ray of this sort has the field at all.
bool can_give(const TreeRay<double>& ray, Field field) {
    const bool of_light = field >= Field::light && field <= Field::transmittance;
    if (ray.shadow) {
        return of_light || field == Field::origin || field == Field::direction ||
               field == Field::diffuse || field == Field::specular;
    }
    const bool of_hit = (field >= Field::object && field <= Field::cos_incident) ||
                        field == Field::ambient || field == Field::diffuse ||
                        field == Field::specular;
    const bool rare =
        field == Field::eta || field == Field::sin2_transmitted || field == Field::termination;
    return !of_light && !rare && (!of_hit || ray.hit);
}

}  // namespace

Finding of_the_whole(std::string subject, std::string reason) {
    Finding finding;
    finding.problem = Problem::whole;
    finding.subject = std::move(subject);
    finding.reason = std::move(reason);
    finding.error = 1;
    return finding;
}

bool fits_scene(const Submission& submission, const Scene& scene, const Names& names,
                std::vector<Finding>& findings) {
    const Camera& camera = scene.camera;
    const RayTree<double>& tree = submission.tree;
    if (tree.pixel_i >= camera.width || tree.pixel_j >= camera.height) {
        findings.push_back(of_the_whole(
            "pixel", "the pixel " + std::to_string(tree.pixel_i) + ',' +
                         std::to_string(tree.pixel_j) + " lies outside the picture of " +
                         std::to_string(camera.width) + " x " + std::to_string(camera.height)));
        return false;
    }
    const Near near{std::max(1e-4, 4 * submission.precision.relative)};
    if (submission.has_camera && !same(tree.camera, camera, near)) {
        findings.push_back(
            of_the_whole("camera", "its camera is not that of the scene; is it another scene?"));
    }
    const std::string setting =
        submission.has_settings ? other_setting(tree.settings, scene.settings) : "";
    if (!setting.empty()) {
        findings.push_back(
            of_the_whole("settings", "its " + setting + " is not that of the scene"));
    }
    const auto unknown = std::ranges::find_if(tree.rays, [&](const TreeRay<double>& ray) {
        return ray.hit && !ray.hit->object.empty() && !names.find(ray.hit->object);
    });
    if (unknown != tree.rays.end()) {
        findings.push_back(of_the_whole("scene", "no object of the scene is called \"" +
                                                     unknown->hit->object +
                                                     "\"; is it of another scene?"));
    }
    const Rgb<double>& whole = tree.intensity;
    const Rgb<double>& primary = tree.rays.front().intensity;
    const auto same = [&](auto change) {
        return near(whole.r, change(primary.r)) && near(whole.g, change(primary.g)) &&
               near(whole.b, change(primary.b));
    };
    if (!same([](double x) { return x; }) &&
        !same([](double x) { return std::clamp(x, 0.0, 1.0); })) {
        findings.push_back(
            of_the_whole("intensity", "the tree's intensity is not that of its primary ray"));
    }
    return true;
}

void look_for_contradictions(const Submission& submission, const Rulebook& book,
                             std::vector<Finding>& findings) {
    for (const Mistake& mistake : submission.contradictions) {
        findings.push_back(of_the_whole(mistake.place, mistake.text));
    }
    const std::size_t lights = book.scene.lights.size();
    if (submission.lights.value_or(lights) != lights) {
        findings.push_back(
            of_the_whole("/counts/lights", "is " + std::to_string(*submission.lights) +
                                               "; the scene has " + std::to_string(lights)));
    }
    for (const TreeRay<double>& ray : submission.tree.rays) {
        const bool said = ray.hit && !ray.hit->material.empty();
        const auto shape = said ? book.names.find(ray.hit->object) : std::nullopt;
        if (!shape) {
            continue;
        }
        const Object& object = book.scene.objects[book.place.shapes.shapes()[*shape].object];
        const std::string& due = book.scene.materials[object.material].name;
        if (due != ray.hit->material) {
            findings.push_back(of_the_whole(
                "material", "ray " + submission.ids[ray.id] + " is said to hit " +
                                ray.hit->material + "; " + ray.hit->object + " is of " + due));
            return;
        }
    }
}

void look_for_missing_fields(const Submission& submission, const Given& required,
                             std::vector<Finding>& findings, std::vector<std::string>& remarks) {
    std::string by_none;
    for (std::size_t k = 0; k < field_count; ++k) {
        const Field field = static_cast<Field>(k);
        std::size_t missing = 0, first = 0, able = 0;
        for (std::size_t ray = 0; ray < submission.tree.rays.size(); ++ray) {
            if (can_give(submission.tree.rays[ray], field)) {
                ++able;
                first = missing == 0 && !submission.given[ray][k] ? ray : first;
                missing += submission.given[ray][k] ? 0 : 1;
            }
        }
        if (missing == 0) {
            continue;
        }
        const std::string name(word_of(field));
        const std::string what =
            name + " is not given by " +
            (missing == able ? "any ray"
                             : std::to_string(missing) + " of " + std::to_string(able) + " rays");
        if (required[k]) {
            findings.push_back(of_the_whole(
                name, what + ", first by ray " + submission.ids[first] + "; it is required"));
        } else if (missing == able) {
            by_none += (by_none.empty() ? "" : ", ") + name;
        } else {
            remarks.push_back(what);
        }
    }
    if (!by_none.empty()) {
        remarks.push_back("not given by any ray, and so not compared: " + by_none);
    }
}

}  // namespace raytree::check
