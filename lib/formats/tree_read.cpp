#include <algorithm>
#include <array>
#include <cmath>

#include "formats/json_members.h"
#include "formats/scene_json.h"
#include "formats/tree_json.h"
#include "formats/tree_shape.h"

namespace raytree {
namespace {

/// Nested trees have two JSON levels to a level of theirs; the rest is for what a ray holds.
constexpr std::size_t deepest_document = 2 * most_tree_levels + 10;
constexpr double rounding = 1e-12;
constexpr std::size_t most_mistakes = 20;  // after which no more of them are looked for

void stop_at_mistakes(JsonReport& report, std::size_t enough) {
    if (report.mistakes.size() >= enough) {
        throw InputError(std::move(report.mistakes));
    }
}

TreeHit<double> read_hit(const OptionalMembers& in, TreeRay<double>& ray, double unit) {
    TreeHit<double> hit;
    in.text("object", hit.object);
    in.text("material", hit.material);
    const bool has_t = in.number("t", hit.t);
    hit.t *= unit;
    if (!in.point("point", hit.point)) {
        hit.point = along(ray.origin, hit.t, ray.direction);
    } else if (!has_t) {
        hit.t = length(hit.point - ray.origin);
    }
    in.point("normal", hit.normal);
    hit.side = static_cast<Side>(in.choice("side", {"front", "back"}));
    if (!in.number("cos_incident", hit.cos_incident)) {
        hit.cos_incident = -inner(ray.direction, hit.normal);
    }
    std::array<double, 2> eta;
    if (in.numbers("eta", eta.size(), eta.data())) {
        const double ratio = eta[0] / eta[1];
        Interface<double> interface {
            eta[0], eta[1], ratio* ratio*(1 - hit.cos_incident * hit.cos_incident)
        };
        if (!in.number("sin2_transmitted", interface.sin2_transmitted) &&
            !isfinite(interface.sin2_transmitted)) {
            interface.sin2_transmitted = 0;
        }
        hit.interface = interface;
    }
    return hit;
}

ShadowPart<double> read_shadow(const OptionalMembers& in, double unit) {
    ShadowPart<double> shadow;
    in.text("light", shadow.light);
    double distance = 0;
    if (in.number("distance", distance)) {
        shadow.distance = distance;
    }
    in.object("blocked_by", [&](const OptionalMembers& blocker) {
        shadow.blocked_by.emplace();
        blocker.text("object", shadow.blocked_by->object);
        blocker.number("t", shadow.blocked_by->t);
        shadow.blocked_by->t *= unit;
        shadow.transmittance = Rgb<double>(0);
    });
    in.colour("transmittance", shadow.transmittance);
    return shadow;
}

Skipped read_skipped(const OptionalMembers& in) {
    Skipped skipped;
    constexpr std::array kinds = {RayKind::shadow, RayKind::reflected, RayKind::refracted};
    skipped.kind = kinds[in.choice("kind", {"shadow", "reflected", "refracted"})];
    in.text("light", skipped.light);
    skipped.reason = in.reason("reason").value_or(Reason::not_reflective);
    return skipped;
}

/// Makes the direction unit; gives the length that it had, in which `t` is measured.
double read_direction(const OptionalMembers& in, Vec3<double>& direction) {
    in.point("direction", direction);
    const double unit = length(direction);
    if (!(unit > 0) || std::abs(unit - 1) <= rounding) {
        return 1;
    }
    direction = UnitVec3<double>::of(direction);
    return unit;
}

/// A level that is given must be that of the ray's place in the tree, counted from 1 or from 0.
class LevelCheck {
  public:
    void see(const ShapedRay& shaped, JsonReport& report, JsonReport& contradictions) {
        const OptionalMembers in(*shaped.members, *shaped.place, report);
        double level = 0;
        if (!in.number("level", level)) {
            return;
        }
        const bool from_0 = level == shaped.level - 1;
        first_is_0_ = first_is_0_.value_or(from_0);
        const int due = shaped.level - (*first_is_0_ ? 1 : 0);
        if (level != due && contradictions.mistakes.size() < most_mistakes) {
            contradictions.add(
                in.reader().place_of("level"),
                "must be " + std::to_string(due) + ", by the ray's place in the tree");
        }
    }

  private:
    std::optional<bool> first_is_0_;
};

/// Counts that are given, but for those of shadow rays, which a tree may leave out. The deepest
/// level may be counted from 0.
void check_counts(const OptionalMembers& in, const TreeCounts& due, JsonReport& contradictions) {
    in.object("counts", [&](const OptionalMembers& counts) {
        const auto check = [&](std::string_view key, double of_rays, double or_else = -1) {
            double given = of_rays;
            counts.number(key, given);
            if (given != of_rays && given != or_else) {
                contradictions.add(counts.reader().place_of(key),
                                   "is not the number of them in the tree");
            }
        };
        check("primary", static_cast<double>(due.primary));
        check("levels", due.levels, due.levels - 1);
        check("reflected", static_cast<double>(due.reflected));
        check("refracted", static_cast<double>(due.refracted));
        if (due.shadow > 0) {
            check("shadow", static_cast<double>(due.shadow));
        }
    });
}

/// One ray; its parent is in `tree` already. `unit` is the length of its direction as given.
TreeRay<double> read_ray(const ShapedRay& shaped, const RayTree<double>& tree, double& unit,
                         JsonReport& report) {
    const OptionalMembers in(*shaped.members, *shaped.place, report);
    TreeRay<double> ray;
    ray.id = tree.rays.size();
    ray.kind = shaped.kind;
    ray.level = shaped.level;
    if (ray.id == 0) {
        ray.origin = tree.camera.eye;
    } else {
        const TreeRay<double>& parent = tree.rays[shaped.parent];
        ray.parent = shaped.parent;
        ray.origin = parent.hit ? parent.hit->point : parent.origin;
    }
    in.point("origin", ray.origin);
    unit = read_direction(in, ray.direction);
    in.colour("diffuse", ray.diffuse);
    in.colour("specular", ray.specular);
    if (ray.kind == RayKind::shadow) {
        ray.shadow = read_shadow(in, unit);
        return ray;
    }
    in.colour("weight", ray.weight);
    in.number("attenuation", ray.attenuation);
    in.object("hit", [&](const OptionalMembers& hit) { ray.hit = read_hit(hit, ray, unit); });
    in.colour("ambient", ray.ambient);
    in.colour("intensity", ray.intensity);
    ray.termination = in.reason("termination");
    in.list("skipped",
            [&](const OptionalMembers& skipped) { ray.skipped.push_back(read_skipped(skipped)); });
    return ray;
}

/// A ray that others start from hit something, whether the file says so or not.
void complete_hit(RayTree<double>& tree, std::size_t parent, const TreeRay<double>& child) {
    TreeRay<double>& from = tree.rays[parent];
    if (!from.hit) {
        from.hit.emplace();
        from.hit->point = child.origin;
        from.hit->t = length(child.origin - from.origin);
    }
}

/// `weight(child) = weight(parent) f(parent) k`, solved for k where the parent has a share.
void recover_coefficients(RayTree<double>& tree) {
    const auto quotient = [](double a, double b) { return isfinite(a / b) ? a / b : 0; };
    for (const TreeRay<double>& child : tree.rays) {
        if (child.parent && !child.shadow) {
            TreeRay<double>& parent = tree.rays[*child.parent];
            const Rgb<double> share = parent.attenuation * parent.weight;
            Rgb<double>& k = child.kind == RayKind::reflected ? parent.hit->kr : parent.hit->kt;
            k = {quotient(child.weight.r, share.r), quotient(child.weight.g, share.g),
                 quotient(child.weight.b, share.b)};
        }
    }
}

bool all_finite(const Vec3<double>& v) { return isfinite(v.x) && isfinite(v.y) && isfinite(v.z); }

/// Whether all numbers are, those too that only follow from what the file says.
bool all_finite(const TreeRay<double>& ray) {
    if (!all_finite(ray.origin) || !all_finite(ray.direction)) {
        return false;
    }
    if (ray.shadow && ray.shadow->blocked_by && !isfinite(ray.shadow->blocked_by->t)) {
        return false;
    }
    if (!ray.hit) {
        return true;
    }
    return isfinite(ray.hit->t) && all_finite(ray.hit->point) && isfinite(ray.hit->cos_incident);
}

void check_range(const RayTree<double>& tree, const TreeShape& shape, JsonReport& report) {
    for (std::size_t k = 0; k < tree.rays.size(); ++k) {
        if (!all_finite(tree.rays[k])) {
            report.add(*shape.rays[k].place,
                       "has numbers from which others follow that are beyond the range of a "
                       "double: a direction, a distance or a point is too large");
        }
    }
}

void count_rays(RayTree<double>& tree) {
    for (const TreeRay<double>& ray : tree.rays) {
        TreeCounts& n = tree.counts;
        (ray.kind == RayKind::primary     ? n.primary
         : ray.kind == RayKind::reflected ? n.reflected
         : ray.kind == RayKind::refracted ? n.refracted
                                          : n.shadow) += 1;
        n.levels = std::max(n.levels, ray.level);
    }
}

void read_pixel(const OptionalMembers& in, RayTree<double>& tree, JsonReport& report) {
    std::array<double, 2> pixel{};
    if (!in.reader().numbers("pixel", pixel.size(), pixel.data(), Need::required)) {
        return;
    }
    const bool whole = std::ranges::all_of(pixel, [](double place) {
        return place >= 0 && place <= 65535 && std::floor(place) == place;
    });
    if (!whole) {
        report.add(in.reader().place_of("pixel"),
                   "must be the column and the row, whole numbers from 0 to 65535");
        return;
    }
    tree.pixel_i = static_cast<int>(pixel[0]);
    tree.pixel_j = static_cast<int>(pixel[1]);
}

/// What the file says of a ray; `null` says something only where it means that there is none.
Given given_of(const ShapedRay& shaped) {
    constexpr auto is_given = [](const Json& object, Field field) {
        const auto member = object.find(word_of(field));
        const bool may_be_null = field == Field::hit || field == Field::blocked_by;
        return member != object.end() && (may_be_null || !member->is_null());
    };
    const auto hit = shaped.members->find("hit");
    const bool has_hit = hit != shaped.members->end() && hit->is_object();
    Given given;
    for (std::size_t k = 0; k < field_count; ++k) {
        const Field field = static_cast<Field>(k);
        const bool of_hit = field >= Field::object && field <= Field::sin2_transmitted;
        given[k] = of_hit ? has_hit && is_given(*hit, field) : is_given(*shaped.members, field);
    }
    return given;
}

/// The scene inside the file, whose places are those of a file of its own.
Scene read_document(const Json& document, const std::filesystem::path& folder, JsonReport& report) {
    JsonReport own;
    own.file = report.file;
    Scene scene;
    try {
        scene = read_scene_json(document, folder, own);
    } catch (const InputError& error) {
        own.mistakes = error.mistakes();
    }
    for (Mistake& mistake : own.mistakes) {
        mistake.place = "/scene/document" + mistake.place;
        report.mistakes.push_back(std::move(mistake));
    }
    report.warnings.insert(report.warnings.end(), own.warnings.begin(), own.warnings.end());
    return scene;
}

void read_head(const OptionalMembers& in, const std::filesystem::path& folder, JsonReport& report,
               ReadTree& out) {
    RayTree<double>& tree = out.tree;
    in.text("generator", tree.generator);
    in.object("scene", [&](const OptionalMembers& scene) {
        scene.text("name", tree.scene_name);
        scene.text("sha256", tree.scene_sha256);
        if (scene.gives("document")) {
            out.scene = read_document(*scene.reader().find("document"), folder, report);
        }
    });
    read_pixel(in, tree, report);
    out.has_camera = in.gives("camera");
    if (out.has_camera) {
        tree.camera =
            read_camera_json(*in.reader().find("camera"), in.reader().place_of("camera"), report);
    }
    out.has_settings = in.gives("settings");
    if (out.has_settings) {
        tree.settings = read_settings_json(*in.reader().find("settings"),
                                           in.reader().place_of("settings"), report);
    }
    in.object("counts", [&](const OptionalMembers& counts) {
        if (counts.count("lights", tree.counts.lights)) {
            out.lights = tree.counts.lights;
        }
        counts.number("full_tree", tree.counts.full_tree);
        counts.count("intersection_tests", tree.counts.intersection_tests);
    });
}

}  // namespace

ReadTree read_tree_json(const std::string& text, const std::filesystem::path& file) {
    JsonReport report;
    report.file = file.string();
    const Json document = parse_json(text, report.file, deepest_document);
    check_json_format(document, "raytree", 1, 0, report);
    report.unknown_keys_are_fine = true;

    ReadTree out;
    const JsonPlace top;
    const OptionalMembers in(document, top, report);
    read_head(in, file.parent_path(), report, out);
    const TreeShape shape = read_tree_shape(document, report);
    LevelCheck levels;
    JsonReport contradictions;
    for (const ShapedRay& shaped : shape.rays) {
        levels.see(shaped, report, contradictions);
        double unit = 1;
        TreeRay<double> ray = read_ray(shaped, out.tree, unit, report);
        if (ray.parent) {
            complete_hit(out.tree, *ray.parent, ray);
        }
        out.tree.rays.push_back(std::move(ray));
        out.ids.push_back(shaped.id);
        out.given.push_back(given_of(shaped));
        out.units.push_back(unit);
        stop_at_mistakes(report, most_mistakes);
    }
    out.tree.intensity = out.tree.rays.front().intensity;
    in.colour("intensity", out.tree.intensity);
    stop_at_mistakes(report, 1);
    count_rays(out.tree);
    check_counts(in, out.tree.counts, contradictions);
    recover_coefficients(out.tree);
    check_range(out.tree, shape, report);
    stop_at_mistakes(report, 1);
    out.warnings = std::move(report.warnings);
    out.contradictions = std::move(contradictions.mistakes);
    return out;
}

}  // namespace raytree
