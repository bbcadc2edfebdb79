#include "formats/tree_json.h"

#include "formats/json_text.h"
#include "formats/scene_json.h"

namespace raytree {
namespace {

using Layout = JsonWriter::Layout;

void write_scene_reference(JsonWriter& json, const std::string& name, const std::string& sha256,
                           const Scene* embedded) {
    json.key("scene").begin_object(embedded != nullptr ? Layout::block : Layout::fill);
    json.member("name", name);
    if (!sha256.empty()) {
        json.member("sha256", sha256);
    }
    if (embedded != nullptr) {
        json.key("document");
        write_scene_json(json, *embedded);
    }
    json.end_object();
}

void write_counts(JsonWriter& json, const TreeCounts& counts) {
    json.key("counts").begin_object();
    json.member("primary", counts.primary);
    json.member("reflected", counts.reflected);
    json.member("refracted", counts.refracted);
    json.member("shadow", counts.shadow);
    json.member("levels", counts.levels);
    json.member("lights", counts.lights);
    json.member("full_tree", counts.full_tree);
    json.member("intersection_tests", counts.intersection_tests);
    json.end_object();
}

/// What every ray begins with.
template <class T> void write_place(JsonWriter& json, const TreeRay<T>& ray) {
    json.member("id", ray.id);
    json.member("parent", ray.parent);
    json.member("kind", word_of(ray.kind));
    if (ray.shadow) {
        json.member("light", ray.shadow->light);
    }
    json.member("level", ray.level);
    json.member("origin", ray.origin);
    json.member("direction", ray.direction);
}

template <class T> void write_shadow_ray(JsonWriter& json, const TreeRay<T>& ray) {
    const ShadowPart<T>& shadow = *ray.shadow;
    json.member("distance", shadow.distance);
    json.key("blocked_by");
    if (shadow.blocked_by) {
        json.begin_object();
        json.member("object", shadow.blocked_by->object);
        json.member("t", shadow.blocked_by->t);
        json.end_object();
    } else {
        json.null();
    }
    json.member("transmittance", shadow.transmittance);
    json.member("diffuse", ray.diffuse);
    json.member("specular", ray.specular);
}

template <class T> void write_hit(JsonWriter& json, const TreeHit<T>& hit) {
    json.begin_object();
    json.member("object", hit.object);
    json.member("material", hit.material);
    json.member("t", hit.t);
    json.member("point", hit.point);
    json.member("normal", hit.normal);
    json.member("side", hit.side == Side::front ? "front" : "back");
    json.member("cos_incident", hit.cos_incident);
    if (hit.interface) {
        json.key("eta").numbers({hit.interface->eta1, hit.interface->eta2});
        json.member("sin2_transmitted", hit.interface->sin2_transmitted);
    }
    json.end_object();
}

void write_skipped(JsonWriter& json, const std::vector<Skipped>& skipped) {
    json.key("skipped").begin_array();
    for (const Skipped& ray : skipped) {
        json.begin_object();
        json.member("kind", word_of(ray.kind));
        if (ray.kind == RayKind::shadow) {
            json.member("light", ray.light);
        }
        json.member("reason", word_of(ray.reason));
        json.end_object();
    }
    json.end_array();
}

template <class T> void write_carrying_ray(JsonWriter& json, const TreeRay<T>& ray) {
    json.member("weight", ray.weight);
    json.member("attenuation", ray.attenuation);
    json.key("hit");
    if (ray.hit) {
        write_hit(json, *ray.hit);
        json.member("ambient", ray.ambient);
        json.member("diffuse", ray.diffuse);
        json.member("specular", ray.specular);
    } else {
        json.null();
    }
    json.member("intensity", ray.intensity);
    json.key("termination");
    if (ray.termination) {
        json.value(word_of(*ray.termination));
    } else {
        json.null();
    }
    write_skipped(json, ray.skipped);
}

template <class T> void write_hit_bounds(JsonWriter& json, const TreeHit<T>& hit,
                                         const HitBounds& bounds) {
    json.key("hit").begin_object();
    json.member("t", bounds.t);
    json.member("point", bounds.point);
    json.member("normal", bounds.normal);
    json.member("cos_incident", bounds.cos_incident);
    if (hit.interface) {
        json.member("sin2_transmitted", bounds.sin2_transmitted);
    }
    json.end_object();
}

/// A bound for each number of the ray, under the number's own name.
template <class T>
void write_bounds(JsonWriter& json, const TreeRay<T>& ray, const RayBounds& bounds) {
    json.key("error_bounds").begin_object();
    json.member("origin", bounds.origin);
    json.member("direction", bounds.direction);
    if (ray.shadow) {
        if (ray.shadow->distance) {
            json.member("distance", bounds.distance);
        }
        if (ray.shadow->blocked_by) {
            json.key("blocked_by").begin_object();
            json.member("t", bounds.hit.t);
            json.end_object();
        }
        json.member("transmittance", bounds.transmittance);
    } else {
        json.member("weight", bounds.weight);
        json.member("attenuation", bounds.attenuation);
    }
    if (ray.hit) {
        write_hit_bounds(json, *ray.hit, bounds.hit);
        json.member("ambient", bounds.ambient);
    }
    if (ray.hit || ray.shadow) {
        json.member("diffuse", bounds.diffuse);
        json.member("specular", bounds.specular);
    }
    if (!ray.shadow) {
        json.member("intensity", bounds.intensity);
    }
    json.end_object();
    if (!bounds.doubts.empty()) {
        json.key("undecided").begin_array();
        for (const Doubt& doubt : bounds.doubts) {
            json.value(doubt.text);
        }
        json.end_array();
    }
}

template <class T>
void write_ray(JsonWriter& json, const TreeRay<T>& ray, const RayBounds* bounds) {
    json.begin_object();
    write_place(json, ray);
    if (ray.shadow) {
        write_shadow_ray(json, ray);
    } else {
        write_carrying_ray(json, ray);
    }
    if (bounds) {
        write_bounds(json, ray, *bounds);
    }
    json.end_object();
}

}  // namespace

template <class T> std::string write_tree_json(const RayTree<T>& tree, const Scene* embedded,
                                               const std::vector<RayBounds>* bounds) {
    JsonWriter json;
    json.begin_object(Layout::block);
    json.member("format", "raytree/1.0");
    json.member("generator", tree.generator);
    write_scene_reference(json, tree.scene_name, tree.scene_sha256, embedded);
    json.key("pixel").numbers({tree.pixel_i, tree.pixel_j});
    json.key("camera");
    write_camera_json(json, tree.camera);
    json.key("settings");
    write_settings_json(json, tree.settings);
    json.member("intensity", tree.intensity);
    write_counts(json, tree.counts);
    json.key("rays").begin_array(Layout::block);
    for (const TreeRay<T>& ray : tree.rays) {
        write_ray(json, ray, bounds ? &(*bounds)[ray.id] : nullptr);
    }
    json.end_array();
    json.end_object();
    return json.take();
}

std::string write_ray_json(const TreeRay<double>& ray) {
    JsonWriter json;
    write_ray(json, ray, nullptr);
    return json.take();
}

template std::string write_tree_json(const RayTree<float>&, const Scene*,
                                     const std::vector<RayBounds>*);
template std::string write_tree_json(const RayTree<double>&, const Scene*,
                                     const std::vector<RayBounds>*);
template std::string write_tree_json(const RayTree<Quad>&, const Scene*,
                                     const std::vector<RayBounds>*);

}  // namespace raytree
